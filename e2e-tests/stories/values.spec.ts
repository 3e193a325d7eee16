/// Values over time and now: strip charts, the table, and what the program remembers.

import {readFileSync} from "node:fs"
import {expect} from "@playwright/test"
import {Learner, until} from "./learner.ts"
import {test} from "./story.ts"

test("several values are drawn at once, one cursor reads them, and the table is saved", async ({page}) => {
  const learner = new Learner(page)
  await learner.opens("forwardBackward")
  const backs = until(learner.robot("speed"), v => v < -0.2)
  await learner.runs()
  await page.getByRole("tab", {name: "Charts"}).click()
  const chips = page.getByRole("group", {name: "Values to draw"})
  await chips.getByRole("button", {name: "x", exact: true}).click()
  await backs
  // While the clock goes on, the chart of all the run has less and less room for its beginning.
  await page.getByRole("button", {name: "Pause", exact: true}).click()
  await chips.getByRole("button", {name: "Memory Hit"}).click()
  const strip = (name: string) => page.getByRole("img", {name: new RegExp(`^${name}:`)})
  for (const name of ["Speed", "Centre bumper", "x", "Memory Hit"]) await expect(strip(name)).toBeVisible()
  await learner.keeps("charts")
  // From the start on, however long it took to come here.
  await page.getByRole("button", {name: "All", exact: true}).click()
  await learner.keeps("charts-all")
  // The cursor of one strip reads all of them.
  await strip("Speed").hover({position: {x: 30, y: 20}})
  await expect(page.getByTestId("cursor")).toHaveText(/^at \d+\.\d\d s$/)
  await expect(strip("Memory Hit")).toHaveAttribute("aria-label", "Memory Hit: ")
  // A click looks back at that moment, and the room and the program's memory are as they were.
  await strip("Speed").click({position: {x: 30, y: 20}})
  await expect(learner.status()).toHaveText("Looking back")
  await until(learner.robot("speed"), v => v >= 0)
  const download = page.waitForEvent("download")
  await page.getByRole("button", {name: /Save as a table/}).click()
  const rows = readFileSync(await (await download).path(), "utf8")
    .trim()
    .split("\n")
  expect(rows[0]).toContain('"time","speed","turning","x","y","heading"')
  expect(rows[0]).toContain("Memory Hit")
  // How many frames a second came depends on how busy the machine is.
  const times = rows.slice(1).map(row => Number(row.split(",")[0]?.replaceAll('"', "")))
  expect(times[0]).toBeLessThan(0.5)
  expect(times).toEqual([...times].sort((a, b) => a - b))
  expect(times.at(-1)).toBeGreaterThan(4)
  expect(new Set(rows.map(row => row.split(",").length)).size).toBe(1)
  await learner.stops()
})

test("the table shows what the program remembers, now and when the learner looks back", async ({page}) => {
  const learner = new Learner(page)
  await learner.opens("forwardBackward")
  await learner.runs()
  await page.getByRole("tab", {name: "Values"}).click()
  await expect(page.getByTestId("sensors")).toContainText("Centre bumper")
  await expect(page.getByTestId("memory")).toContainText("Memory HitTrue")
  await learner.keeps("memory")
  await page.getByRole("slider", {name: "Look back in the run"}).fill("1")
  await expect(learner.status()).toHaveText("Looking back")
  await expect(page.getByTestId("memory")).toBeHidden()
  await page.getByRole("button", {name: "Go on"}).click()
  await expect(page.getByTestId("memory")).toContainText("Memory HitTrue")
  await learner.stops()
})
