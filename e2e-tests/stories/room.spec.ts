/// The room: change it, take the robot by hand, stop the clock, look back, reach a goal.

import {expect, type Page} from "@playwright/test"
import {boxAtRest} from "./at_rest.ts"
import {drags, Floor, type Place} from "./floor.ts"
import {Learner, until} from "./learner.ts"
import {test} from "./story.ts"

/// What reads alike for a second: most frames that were on their way have come, and the robot has rolled out.
async function standsStill<T>(read: () => Promise<T>): Promise<T> {
  let last = await read()
  let alike = 0
  await expect
    .poll(
      async () => {
        const before = JSON.stringify(last)
        last = await read()
        alike = before === JSON.stringify(last) ? alike + 1 : 0
        return alike
      },
      {intervals: [250]},
    )
    .toBeGreaterThan(4)
  return last
}

/// Opens the gallery of rooms and takes one.
async function chooses(page: Page, room: string): Promise<void> {
  await page.getByRole("button", {name: /^Room to drive in/}).click()
  await page.getByRole("dialog").getByRole("button", {name: room}).click()
  await expect(page.getByRole("button", {name: `Room to drive in: ${room}`})).toBeVisible()
}

/// Opens the gallery of rooms and takes one from a file.
async function opensRoom(page: Page, name: string, world: object | string): Promise<void> {
  await page.getByRole("button", {name: /^Room to drive in/}).click()
  const chooser = page.waitForEvent("filechooser")
  await page.getByRole("dialog").getByRole("button", {name: "Open a room…"}).click()
  const text = typeof world === "string" ? world : JSON.stringify(world)
  await (await chooser).setFiles({name, mimeType: "application/json", buffer: Buffer.from(text)})
}

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

  async drags(from: Place, to: Place): Promise<void> {
    const box = await boxAtRest(this.sheet())
    const at = ([x, y]: Place): Place => [box.x + x * box.width, box.y + y * box.height]
    await drags(this.page, at(from), at([(from[0] + to[0]) / 2, (from[1] + to[1]) / 2]), at(to))
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

test("a changed room is kept with the program, and comes back after a reload", async ({page}) => {
  const learner = new Learner(page)
  const workshop = new Workshop(page)
  await learner.opens("move")
  await workshop.opens()
  await workshop.takes("Wall")
  await page.keyboard.press("Tab")
  await workshop.sheet().focus()
  // By keyboard alone: the cross-hair begins in the middle.
  await page.keyboard.press("Enter")
  for (let i = 0; i < 5; i++) await page.keyboard.press("ArrowUp")
  await page.keyboard.press("Enter")
  await expect(workshop.told()).toHaveText("Wall 1 from 2.5 m, 2 m to 2.5 m, 2.5 m")
  await page.keyboard.press("ArrowRight")
  await expect(workshop.told()).toHaveText("Wall 1 from 2.6 m, 2 m to 2.6 m, 2.5 m")
  await workshop.isDone()
  await expect(page.getByTestId("saved")).toHaveText("saved")
  await page.goto("/")
  await expect(page.getByRole("button", {name: "Room to drive in: A room, changed"})).toBeVisible()
  await learner.runs()
  await until(learner.robot("x"), x => x > 2.3 && x < 2.5)
  await expect(learner.robot("bumpers")).not.toBeEmpty()
  await learner.stops()
})

test("the editor says why the robot cannot start there, and Done waits", async ({page}) => {
  const learner = new Learner(page)
  const workshop = new Workshop(page)
  await learner.opens("move")
  await workshop.opens()
  await workshop.takes("Holes")
  await workshop.drags([0.25, 0.45], [0.35, 0.55])
  await expect(page.getByRole("alert")).toContainText("over a hole")
  await expect(page.getByRole("button", {name: "Done"})).toBeDisabled()
  await page.keyboard.press("Control+z")
  await expect(page.getByRole("button", {name: "Done"})).toBeEnabled()
  await page.getByRole("button", {name: "Leave it as it was"}).click()
  await expect(page.getByRole("button", {name: "Room to drive in: A room"})).toBeVisible()
})

test("a room from a file tells where it is wrong, and a good one is driven in until its goal is reached", async ({
  page,
}) => {
  const learner = new Learner(page)
  await learner.opens("move")
  const good = {
    name: "hall",
    size: [6, 4],
    start: {x: 1, y: 2, theta: 0},
    goals: [
      {kind: "reach", x: 3, y: 2, r: 0.3, title: "Come to the middle"},
      {kind: "avoid", what: "bumps", title: "Touch nothing"},
    ],
  }
  await opensRoom(page, "bad.json", {...good, walls: [{from: [0, 0], to: [1]}]})
  await expect(page.getByTestId("notice")).toContainText("walls[0].to: expected a point")
  await opensRoom(page, "cut.json", JSON.stringify(good).slice(0, 30))
  await expect(page.getByTestId("notice")).toContainText("damaged or cut short")
  await opensRoom(page, "hall.json", good)
  const goals = page.getByTestId("goals")
  await expect(goals.getByRole("listitem")).toHaveCount(2)
  await learner.runs()
  await expect(goals.locator(".done")).toContainText("Come to the middle")
  await learner.keeps("goals")
  await expect(goals.locator(".missed")).toContainText("Touch nothing")
  await learner.stops()
})

test("hands take the robot, turn it, press and lift it, and push a box, while it runs", async ({page}) => {
  const learner = new Learner(page)
  await learner.opens("move")
  // So slow that it is where it was read when a hand comes there, on a busy machine as well.
  await learner.changesNumber("0.5", "0.05")
  await expect(learner.haskell()).toContainText("Velocity 0.05 0")
  await chooses(page, "A room full of boxes")
  await page.getByRole("combobox", {name: "Speed"}).selectOption("0.1")
  await learner.runs()
  await expect(learner.status()).toHaveText("Running")
  const floor = new Floor(page, [6, 5])
  // It drives all the while.
  const place = async () =>
    [Number(await learner.robot("x").textContent()), Number(await learner.robot("y").textContent())] as const
  await floor.drags(await place(), [2, 4.15])
  await until(learner.robot("y"), y => y > 3.8)
  await until(learner.robot("x"), x => x > 1.8)
  // The handle in front of the robot turns it.
  const [x, y] = await place()
  await floor.drags([x + 0.33, y], [x, y + 0.5])
  await until(learner.robot("heading"), angle => angle > 60 && angle < 120)
  // A drum is pushed against the robot from its right; its bumper feels it.
  await floor.canvas().focus()
  await page.keyboard.press("b")
  await expect(page.getByTestId("held")).toContainText("Box 1")
  await page.keyboard.press("Escape")
  await page.keyboard.press(",")
  await until(learner.robot("heading"), angle => angle > 75 && angle < 135)
  await floor.drags([5, 1], [5, 2.5])
  await floor.drags([5, 2.5], [1.2, 4.9])
  await expect(learner.robot("bumpers")).not.toBeEmpty()
  await page.getByRole("button", {name: "Lift", exact: true}).click()
  await expect(learner.robot("wheels")).toHaveText("left right")
  await page.getByRole("button", {name: "Lift", exact: true}).click()
  await expect(learner.robot("wheels")).toBeEmpty()
  await learner.keeps("hands")
  await learner.stops()
})

test("the clock stands, makes single steps, goes on, and the run can be looked back at", async ({page}) => {
  const learner = new Learner(page)
  await learner.opens("forwardBackward")
  // Two steps for each frame: the clock stops as often at a step without a frame as at one with.
  await page.getByLabel("Speed", {exact: true}).selectOption("2")
  await learner.runs()
  await until(learner.robot("time"), time => time > 1)
  await page.getByRole("button", {name: "Pause"}).click()
  await expect(learner.status()).toHaveText("Paused")
  let stood = 0
  // Once more when a frame from before the pause came late.
  await expect(async () => {
    stood = Number(await standsStill(() => learner.robot("time").textContent()))
    for (let i = 0; i < 3; i++) await page.getByRole("button", {name: /^One step/}).click()
    await expect(learner.robot("time")).toHaveText((stood + 0.06).toFixed(2), {timeout: 5000})
  }).toPass()
  const x = Number(await learner.robot("x").textContent())
  const line = page.getByRole("slider", {name: "Look back in the run"})
  await line.fill("0.5")
  await expect(learner.status()).toHaveText("Looking back")
  // The last picture until then: a busy machine does not get all fifty a second.
  await until(learner.robot("time"), now => now < 0.521)
  await until(learner.robot("x"), then => then < x - 0.1)
  await learner.keeps("looking-back")
  await page.getByRole("button", {name: "Go on"}).click()
  await until(learner.robot("time"), now => now > stood + 0.5)
  await learner.stops()
})

test("the same run again is the same to the last digit on a slippery floor; Run has new luck", async ({
  page,
}) => {
  const learner = new Learner(page)
  await learner.opens("drawSquare")
  await chooses(page, "A slippery room, like a real one")
  await page.getByRole("combobox", {name: "Speed"}).selectOption("max")
  const shown = () =>
    Promise.all(["time", "x", "y", "heading"].map(async what => `${await learner.robot(what).textContent()}`))
  /// Puts the robot back. What the page says of the run before is gone afterwards.
  const resets = async () => {
    await page.getByRole("button", {name: "Reset"}).click()
    await expect(learner.status()).not.toHaveText("Finished")
    await expect(learner.robot("time")).toHaveText("0.00")
  }
  /// Where the robot has rolled to rest after the program's end.
  const end = async () => {
    await expect(learner.status()).toHaveText("Finished")
    await expect(learner.robot("speed")).toHaveText("0.000")
    return standsStill(shown)
  }
  await learner.runs()
  const first = await end()
  await resets()
  await page.getByRole("button", {name: "The same run again"}).click()
  await expect(learner.status()).toHaveText("Finished")
  await expect.poll(shown).toEqual(first)
  await resets()
  await learner.runs()
  expect(await end()).not.toEqual(first)
})

test.describe("on a phone", () => {
  test.use({viewport: {width: 390, height: 844}, hasTouch: true})

  test("a finger puts down a post and takes it away again", async ({page}) => {
    const workshop = new Workshop(page)
    await page.goto("/?example=move")
    await page.getByRole("button", {name: "Room", exact: true}).tap()
    await page.getByRole("button", {name: "Change this room"}).tap()
    await page.getByRole("toolbar").getByRole("button", {name: "Post", exact: true}).tap()
    const box = await boxAtRest(workshop.sheet())
    await page.touchscreen.tap(box.x + 0.7 * box.width, box.y + 0.5 * box.height)
    await expect(workshop.told()).toHaveText(/^Post 1 at .*, radius 0.2 m$/)
    await page.getByRole("button", {name: "Take away"}).tap()
    await expect(workshop.told()).toBeEmpty()
    await page.getByRole("button", {name: "Undo"}).tap()
    await expect(page.getByRole("button", {name: /^Post 1 at/})).toBeVisible()
    await page.getByRole("button", {name: "Done"}).tap()
    await expect(page.getByRole("button", {name: "Room to drive in: A room, changed"})).toBeVisible()
  })
})
