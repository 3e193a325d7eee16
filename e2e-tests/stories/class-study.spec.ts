/// Class mode: a class takes part in a study. The page asks, the pupil agrees, and the board exports what the pupil did since.

import {AxeBuilder} from "@axe-core/playwright"
import {expect, type Page} from "@playwright/test"
import {screenshot} from "./learner.ts"
import {device, RunningClass, savedIn} from "./running_class.ts"
import {test} from "./story.ts"

let opened: RunningClass

test.beforeEach(async () => {
  opened = await RunningClass.start()
})

test.afterEach(() => opened.ends())

const faults = async (page: Page, part: string) =>
  (await new AxeBuilder({page}).include(part).analyze()).violations.map(({id}) => id)

test("a pupil is asked, agrees, and is in the export of the board", async ({browser}) => {
  const {learner: ada} = await opened.joins(browser, "Ada")
  await savedIn(ada)
  const teacher = await device(browser)
  await teacher.goto(opened.board)
  const tool = teacher.getByTestId("study-tool")
  await tool.getByText("This class takes part in no study.").click()
  await tool.getByLabel("Whom pupils and parents can ask").fill("Prof. Quirk")
  await tool.getByRole("button", {name: "This class takes part in a study"}).click()
  await expect(tool).toContainText("No pupil takes part yet. Questions: Prof. Quirk.")
  await expect(tool.getByRole("button", {name: "Export for a study (ZIP)"})).toBeDisabled()

  const line = ada.page.getByTestId("class-study")
  await expect(line).toContainText("Your class takes part in a study")
  await expect(line).toContainText("Questions: Prof. Quirk.")
  expect(await faults(ada.page, "#class-bar")).toEqual([])
  await ada.page.screenshot({path: screenshot("class-study")})
  await line.getByRole("button", {name: "I take part"}).click()
  await expect(line).toContainText("You take part in the study of your class.")
  await ada.runs()

  await expect(tool).toContainText("One pupil takes part.")
  await tool.scrollIntoViewIfNeeded()
  await teacher.screenshot({path: screenshot("board-study")})
  expect(await faults(teacher, "[data-testid=study-tool]")).toEqual([])
  const downloading = teacher.waitForEvent("download")
  await tool.getByRole("button", {name: "Export for a study (ZIP)"}).click()
  expect((await downloading).suggestedFilename()).toMatch(/^rosy-study-.*\.zip$/)

  await tool.getByRole("button", {name: "End the study"}).click()
  await tool.getByRole("button", {name: "End it now"}).click()
  await expect(line).toHaveCount(0)
  await expect(tool.getByText("This class takes part in no study.")).toBeVisible()
  for (const page of [ada.page, teacher]) await page.context().close()
})
