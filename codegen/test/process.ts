/// Other programs, and long work, without keeping the test runner waiting: it ends a run when it has heard nothing for a minute.

import {spawn} from "node:child_process"
import {setImmediate} from "node:timers/promises"

export interface Ended {
  readonly stdout: string
  readonly stderr: string
  readonly status: number | null
  readonly signal: string | null
}

/// Runs a program to its end, whatever that is; rejects when there is no such program.
export function run(command: string, args: readonly string[], cwd?: string): Promise<Ended> {
  return new Promise((resolve, reject) => {
    const child = spawn(command, args, {cwd, stdio: ["ignore", "pipe", "pipe"]})
    const said = {stdout: "", stderr: ""}
    for (const stream of ["stdout", "stderr"] as const) {
      child[stream].setEncoding("utf8")
      child[stream].on("data", (text: string) => {
        said[stream] += text
      })
    }
    child.on("error", reject)
    child.on("close", (status, signal) => resolve({...said, status, signal}))
  })
}

/// Lets the runner hear that a test is alive. Without a clock: it costs next to nothing.
export const breathe = (): Promise<void> => setImmediate()
