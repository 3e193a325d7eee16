/// The helper that reads Haskell dies in the middle of a run: the page says so calmly, and the next Run works.

import {readdirSync, readFileSync} from "node:fs"
import {expect, test} from "@playwright/test"
import {Learner, until} from "./learner.ts"

test("a worker that is killed is replaced, and the next Run works", async ({page}) => {
  const learner = new Learner(page)
  await learner.opens("move")
  await learner.runs()
  await until(learner.robot("speed"), v => v > 0.3)
  expect(killWorkers()).toBeGreaterThan(0)
  await expect(learner.status()).toHaveText("Ended by a problem")
  await learner.seesProblem(/had to start again/)
  await learner.seesProblem(/Press Run once more/)
  await expect(learner.robot("speed")).toHaveText("0.000")
  await learner.keeps("worker-killed")
  await expect(learner.haskell()).toContainText("move = Velocity 0.5 0")
  await learner.runs()
  await expect(learner.status()).toHaveText("Running")
  await until(learner.robot("speed"), v => v > 0.3)
  await learner.stops()
})

/// Kills every worker of this test's own service, the spare one as well; says how many processes that were.
function killWorkers(): number {
  const processes = readdirSync("/proc")
    .filter(name => /^\d+$/.test(name))
    .map(name => ({pid: Number(name), parent: parentOf(name), words: wordsOf(name)}))
  const port = process.env["ROSY_E2E_PORT"] ?? ""
  const ours = new Set(
    processes.filter(p => p.words.includes("serve") && p.words.includes(port)).map(p => p.pid),
  )
  const workers = processes.filter(p => p.words.some(w => w.endsWith("/rosy-worker")) && ours.has(p.parent))
  for (const worker of workers) process.kill(worker.pid, "SIGKILL")
  return workers.length
}

const wordsOf = (pid: string): readonly string[] => look(pid, "cmdline").split("\0")

/// The fourth word of the file, and the second after the name in brackets: proc(5).
const parentOf = (pid: string): number => Number(look(pid, "stat").split(") ").at(-1)?.split(" ")[1])

/// Empty when the process has ended meanwhile.
function look(pid: string, file: string): string {
  try {
    return readFileSync(`/proc/${pid}/${file}`, "utf8")
  } catch {
    return ""
  }
}
