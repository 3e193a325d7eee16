/// A Kobuki that is not there and a Rosy that may drive it. The base is the emulator of the robots' suite: a
/// pseudo-terminal that answers as a Kobuki does, and tells what it was told.

import {type ChildProcess, spawn} from "node:child_process"
import {mkdtempSync} from "node:fs"
import {tmpdir} from "node:os"
import {join} from "node:path"
import {createInterface} from "node:readline"

const root = new URL("../..", import.meta.url).pathname

type Environment = Readonly<Record<string, string | undefined>>

/// A program and the lines it says.
class Talker {
  readonly process: ChildProcess
  private readonly said: string[] = []
  private waiting: (() => void) | null = null

  constructor(command: string, args: readonly string[], env: Environment) {
    this.process = spawn(command, args, {cwd: root, env, stdio: ["pipe", "pipe", "inherit"]})
    if (this.process.stdout === null) throw new Error(`expected ${command} to have an output`)
    createInterface(this.process.stdout).on("line", line => {
      this.said.push(line)
      this.waiting?.()
    })
  }

  ask(line: string): void {
    this.process.stdin?.write(`${line}\n`)
  }

  /// The next line that fits; those before it are dropped.
  async says(wanted: RegExp): Promise<RegExpExecArray> {
    for (;;) {
      for (let line = this.said.shift(); line !== undefined; line = this.said.shift()) {
        const found = wanted.exec(line)
        if (found !== null) return found
      }
      await new Promise<void>(resolve => {
        this.waiting = resolve
      })
    }
  }
}

export interface Rig {
  readonly base: Talker
  /// Of the page, without and with the code.
  readonly address: string
  readonly opened: string
  readonly code: string
  /// In which an emergency stop meets nobody else who drives a robot from this machine.
  readonly environment: Environment
  close(): void
}

export async function openRig(): Promise<Rig> {
  const folder = mkdtempSync(join(tmpdir(), "rosy-e2e-"))
  const emulator = join(root, "rosy-hs", "test-robots", "peers", "kobuki.py")
  const environment = {...process.env, XDG_RUNTIME_DIR: folder}
  const base = new Talker("/usr/bin/python3", [emulator, join(folder, "kobuki")], environment)
  const device = (await base.says(/^plugged (.*)$/))[1]
  const args = ["start", "--no-browser", "--port", "0", "--robot", `Kitchen=serial:${device}`]
  const service = new Talker(join(root, "rosy"), args, environment)
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
