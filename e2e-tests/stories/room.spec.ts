/// The room: change it, take the robot by hand, stop the clock, look back, reach a goal.

import {expect, type Page, test} from "@playwright/test"
import {Learner, until} from "./learner.ts"

/// The world editor, as hands meet it. Places are parts of the sheet, from its upper left corner.
class Workshop {
  readonly page: Page
  constructor(page: Page) {
    this.page = page
  }

  async opens(): Promise<void> {
    await this.page.getByRole("button", {name: "Change this room"}).click()
    await expect(this.sheet()).toBeVisible()
  }

  sheet() {
    return this.page.getByTestId("sheet")
  }

  /// What a screen reader hears of what is chosen.
  told() {
    return this.page.getByTestId("sheet-told")
  }

  async takes(tool: string): Promise<void> {
    await this.page.getByRole("toolbar").getByRole("button", {name: tool, exact: true}).click()
  }

  async drags(from: readonly [number, number], to: readonly [number, number]): Promise<void> {
    const box = await this.sheet().boundingBox()
    if (box === null) throw new Error("expected the sheet to be seen")
    const at = ([x, y]: readonly [number, number]) => [box.x + x * box.width, box.y + y * box.height] as const
    await this.page.mouse.move(...at(from))
    await this.page.mouse.down()
    await this.page.mouse.move(...at([(from[0] + to[0]) / 2, (from[1] + to[1]) / 2]))
    await this.page.mouse.move(...at(to))
    await this.page.mouse.up()
  }

  async isDone(): Promise<void> {
    await this.page.getByRole("button", {name: "Done"}).click()
    await expect(this.sheet()).toBeHidden()
  }
}

test("a learner draws a wall and a box, drags, undoes, and the robot bumps into the wall", async ({page}) => {
  const learner = new Learner(page)
  const workshop = new Workshop(page)
  await learner.opens("move")
  await workshop.opens()
  await workshop.takes("Wall")
  await workshop.drags([0.6, 0.3], [0.6, 0.7])
  await expect(workshop.told()).toHaveText(/^Wall 1 from 3 m, .* to 3 m/)
  await workshop.takes("Box to push")
  await workshop.drags([0.4, 0.7], [0.45, 0.8])
  await expect(workshop.told()).toHaveText(/^Box 1 at/)
  const before = await workshop.told().textContent()
  await workshop.drags([0.425, 0.75], [0.5, 0.85])
  await expect(workshop.told()).not.toHaveText(before ?? "")
  await page.keyboard.press("Control+z")
  await expect(workshop.told()).toHaveText(before ?? "")
  await learner.keeps("workshop")
  await workshop.isDone()
  await learner.runs()
  await expect(learner.robot("bumpers")).toHaveText("centre")
  await until(learner.robot("x"), x => x > 2.7 && x < 2.85)
  await learner.stops()
})
