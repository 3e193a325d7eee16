/// Class mode: the teacher and a pupil edit the pupil's program together.

import {AxeBuilder} from "@axe-core/playwright"
import {expect, type Page} from "@playwright/test"
import {screenshot} from "./learner.ts"
import {device, RunningClass, savedIn} from "./running_class.ts"
import {test} from "./story.ts"

/// What axe-core finds wrong with a part of a page (WCAG 2.2 A and AA).
async function faults(page: Page, part: string): Promise<unknown[]> {
  const {violations} = await new AxeBuilder({page})
    .withTags(["wcag2a", "wcag2aa", "wcag21a", "wcag21aa", "wcag22aa"])
    .include(part)
    .exclude("iframe")
    .analyze()
  return violations.map(violation => [violation.id, violation.nodes.map(node => node.html)])
}

test("the teacher and a pupil edit a program together after the pupil has allowed it", async ({browser}) => {
  const running = await RunningClass.start()
  const {learner: ada} = await running.joins(browser, "Ada")
  await ada.changesNumber("0.5", "0.25")
  await savedIn(ada)
  const teacher = await device(browser)
  await teacher.goto(running.board)
  await teacher.getByRole("button", {name: "Look at the program of Ada"}).click()
  const dialog = teacher.getByRole("dialog")
  const state = dialog.getByTestId("board-sharing")
  const text = teacher.frameLocator("iframe").getByTestId("haskell")
  const line = ada.page.getByTestId("class-sharing")
  await expect(text).toContainText("0.25")

  // Ada declines first.
  await dialog.getByRole("button", {name: "Ask to edit together"}).click()
  await expect(line.getByRole("alert")).toContainText("Your teacher asks to edit")
  await expect(state).toContainText("Ada was asked")
  await line.getByRole("button", {name: "Not now"}).click()
  await expect(line).toHaveCount(0)
  await expect(state).toContainText("Ada does not want to edit together now.")

  // What Ada changes before she allows it is there, saved or not.
  await ada.entersHaskell()
  await ada.page.keyboard.press("Control+End")
  await ada.page.keyboard.type("\n-- by Ada")
  await savedIn(ada)
  // The copy on the board follows what Ada saves.
  await expect(text).toContainText("-- by Ada")
  await ada.page.keyboard.type(", unsaved")
  await dialog.getByRole("button", {name: "Ask to edit together"}).click()
  await ada.page.setViewportSize({width: 390, height: 844})
  await expect(line.getByRole("alert")).toBeVisible()
  expect(await faults(ada.page, ".class-bar")).toEqual([])
  await ada.page.screenshot({path: screenshot("class-sharing-phone")})
  await ada.page.setViewportSize({width: 1440, height: 900})
  await line.getByRole("button", {name: "Allow"}).click()
  await expect(line).toContainText("Your teacher and you are editing this program together.")
  await expect(state).toContainText("You and Ada are editing this program together.")
  await expect(text).toContainText("-- by Ada, unsaved")

  // Both write in the last line.
  await text.click()
  await teacher.keyboard.press("Control+End")
  await teacher.keyboard.type(" and her teacher")
  await expect(ada.haskell()).toContainText("-- by Ada, unsaved and her teacher")
  await expect(ada.page.getByTestId("other-cursor")).toBeVisible()
  await expect(line).toContainText(/Your teacher is in line \d+/)
  await ada.entersHaskell()
  await ada.page.keyboard.press("Control+End")
  await ada.page.keyboard.type("!")
  await expect(text).toContainText("-- by Ada, unsaved and her teacher!")
  await expect(dialog).toContainText(/Ada is in line \d+/)
  await expect(text.getByTestId("other-cursor")).toBeVisible()
  expect(await faults(teacher, ".board-program")).toEqual([])
  await ada.page.screenshot({path: screenshot("class-sharing")})
  await teacher.screenshot({path: screenshot("board-sharing")})

  // An edit of a block reaches the other's text and blocks.
  await ada.changesNumber("0.25", "0.375")
  await expect(text).toContainText("0.375")
  await expect(teacher.frameLocator("iframe").locator(".blocks-host")).toContainText("0.375")

  // Undo takes back the teacher's own words, not what Ada did after them.
  await text.click()
  await teacher.keyboard.press("Control+z")
  await expect(ada.haskell()).not.toContainText("and her teacher")
  await expect(ada.haskell()).toContainText("-- by Ada")
  await expect(ada.haskell()).toContainText("0.375")

  await line.getByRole("button", {name: "Stop editing together"}).click()
  await expect(state).toContainText("Editing together has ended.")
  await expect(line).toContainText("Editing together has ended.")
  await expect(ada.page.getByTestId("other-cursor")).toHaveCount(0)
  await teacher.keyboard.type("-- too late")
  await expect(text).toContainText("-- too late")
  await expect(ada.haskell()).not.toContainText("too late")
  await savedIn(ada)
  await ada.page.reload()
  await expect(ada.haskell()).toContainText("0.375")
  for (const page of [ada.page, teacher]) await page.context().close()
  await running.ends()
})
