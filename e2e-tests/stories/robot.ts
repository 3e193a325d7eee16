/// A Kobuki that is not there and a Rosy that may drive it. The base is the emulator of the robots' suite: a
/// pseudo-terminal that answers as a Kobuki does, and tells what it was told.

import {mkdtempSync} from "node:fs"
import {tmpdir} from "node:os"
import {join} from "node:path"
import {type Environment, root, startService, Talker} from "./service.ts"

export interface Rig {
  readonly base: Talker
  /// Of the page, without and with the code.
  readonly address: string
  readonly opened: string
  readonly code: string
  /// In which an emergency stop reaches no other robot driven from this machine.
  readonly environment: Environment
  close(): void
}

export async function openRig(): Promise<Rig> {
  const folder = mkdtempSync(join(tmpdir(), "rosy-e2e-"))
  const emulator = join(root, "rosy-hs", "test-robots", "peers", "kobuki.py")
  const environment = {...process.env, XDG_RUNTIME_DIR: folder, ROSY_RECORDINGS: join(folder, "recordings")}
  const base = new Talker("/usr/bin/python3", [emulator, join(folder, "kobuki")], environment)
  const device = (await base.says(/^plugged (.*)$/))[1]
  const service = startService(["--robot", `Kitchen=serial:${device}?rearm=off`], environment)
  const [, code = "", opened = ""] = await service.says(/the code (\S+): (\S+)$/)
  return {
    base,
    code,
    opened,
    environment,
    address: opened.replace(/#.*/, ""),
    close() {
      service.process.kill("SIGTERM")
      base.process.kill("SIGKILL")
    },
  }
}
