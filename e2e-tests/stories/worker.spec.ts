/// Death of the worker in the middle of a run: the page says so calmly, and the next Run works. The service is one of its own,
/// because the runs of other stories would end as well.

import {readdirSync, readFileSync} from "node:fs"
import {expect} from "@playwright/test"
import {Learner} from "./learner.ts"
import {startService, type Talker} from "./service.ts"
import {test} from "./story.ts"

let service: Talker
let address = ""
test.beforeAll(async () => {
  service = startService()
  address = (await service.says(/ready at (\S+)/))[1]?.replace(/\/$/, "") ?? ""
})
test.afterAll(() => {
  service.process.kill("SIGTERM")
})

test("a worker that is killed is replaced, and the next Run works", async ({page}) => {
  const learner = new Learner(page)
  await learner.opens("move", address)
  await learner.runsUntil("speed", v => v > 0.3)
  expect(killWorkers()).toBeGreaterThan(0)
  await expect(learner.status()).toHaveText("Ended by a problem")
  await learner.seesProblem(/had to start again/)
  await learner.seesProblem(/Press Run once more/)
  await expect(learner.robot("speed")).toHaveText("0.000")
  await learner.keeps("worker-killed")
  await expect(learner.haskell()).toContainText("move = Velocity 0.5 0")
  await learner.runsUntil("speed", v => v > 0.3)
  await expect(learner.status()).toHaveText("Running")
  await learner.stops()
})

/// Kills every worker of this story's own service, the spare one as well; returns how many processes that were.
function killWorkers(): number {
  const workers = readdirSync("/proc")
    .filter(name => /^\d+$/.test(name))
    .filter(name => wordsOf(name).some(w => w.endsWith("/rosy-worker")))
    .map(Number)
    .filter(pid => parentOf(pid) === service.process.pid)
  for (const pid of workers) process.kill(pid, "SIGKILL")
  return workers.length
}

const wordsOf = (pid: string): readonly string[] => look(pid, "cmdline").split("\0")

/// The fourth word of the file, and the second after the name in brackets: proc(5).
const parentOf = (pid: number): number => Number(look(String(pid), "stat").split(") ").at(-1)?.split(" ")[1])

/// Empty when the process has ended meanwhile.
function look(pid: string, file: string): string {
  try {
    return readFileSync(`/proc/${pid}/${file}`, "utf8")
  } catch {
    return ""
  }
}
