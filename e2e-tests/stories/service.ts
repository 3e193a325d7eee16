/// Programs that a story starts for itself, and a Rosy service of its own for stories that would disturb the others.

import {type ChildProcess, spawn} from "node:child_process"
import {once} from "node:events"
import {join} from "node:path"
import {createInterface} from "node:readline"
import {fileURLToPath} from "node:url"

export const root = fileURLToPath(new URL("../..", import.meta.url))

export type Environment = Readonly<Record<string, string | undefined>>

/// A child process and the lines that it prints.
export class Talker {
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

  /// Ends the process, and waits until it has: nothing is written to its files and its port is free afterwards.
  async ends(signal: "SIGTERM" | "SIGKILL" = "SIGTERM"): Promise<void> {
    const ended = once(this.process, "exit")
    if (this.process.exitCode !== null || this.process.signalCode !== null) return
    this.process.kill(signal)
    await ended
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

/// Starts a service on a free port. End it with a SIGTERM to its process.
export function startService(args: readonly string[] = [], env: Environment = process.env): Talker {
  return new Talker(join(root, "rosy"), ["start", "--no-browser", "--port", "0", ...args], env)
}
