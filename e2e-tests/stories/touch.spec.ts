/// On tablets and phones, with fingers: a block goes into the bin and comes back from the list, and a conflict is mended with one tap.

import {writeFileSync} from "node:fs"
import {expect, type Locator} from "@playwright/test"
import {boxAtRest} from "./at_rest.ts"
import {Finger} from "./finger.ts"
import {Floor} from "./floor.ts"
import {Learner} from "./learner.ts"
import {test} from "./story.ts"

const sizes = [
  {width: 820, height: 1180},
  {width: 390, height: 844},
] as const

/// `drive` sends its velocity at each tick, so that `backOff` has no visible effect.
const conflict = `drive :: Velocity
drive = Velocity 0.3 0

backOff :: Bumper -> Velocity
backOff _ = Velocity (-0.1) 0

main = simulate (drive, backOff)
`

/// CSS pixels: the height of a button that a finger hits (2.4 rem).
const smallestButton = 36

/// Where a finger takes a definition: on the words of its second row.
const grip = {x: 10, y: 62}

for (const size of sizes)
  test.describe(`on ${size.width} by ${size.height}`, () => {
    test.use({viewport: size, hasTouch: true, isMobile: true})

    test(`a finger drops a function into the bin and restores it from the list, ${size.width} wide`, async ({
      page,
    }) => {
      const learner = new Learner(page)
      await learner.opens("accelerateAndPlay")
      const play = learner.definition("play")
      const before = await learner.haskellText()
      const finger = await Finger.on(page)
      const block = await boxAtRest(play.locator("> .blocklyPath"))
      await finger.takesUp({x: block.x + grip.x, y: block.y + grip.y})
      const bin = await boxAtRest(page.locator(".rosyBin"))
      await finger.movesTo({x: bin.x + bin.width / 2, y: bin.y + bin.height / 2})
      await expect(page.locator(".rosyBin")).toHaveClass(/open/)
      await learner.keeps(`touch-bin-${size.width}`)
      await finger.letsGo()
      await expect(play).toHaveCount(0)

      await page.getByRole("button", {name: "Deleted blocks"}).tap()
      const entry = page.locator(".blocklyContextMenu .blocklyMenuItem")
      await expect(entry).toHaveText(/^\s*play \(Bumper _ Pressed\) =/)
      await isInWindow(entry)
      await learner.keeps(`touch-restore-${size.width}`)
      await entry.tap()
      await expect(play).toHaveCount(1)
      await expect.poll(() => learner.haskellText()).toBe(before)
    })

    test(`a finger mends a conflict with one tap, ${size.width} wide`, async ({page}, info) => {
      const learner = new Learner(page)
      await learner.opens("move")
      const file = info.outputPath("conflict.hs")
      writeFileSync(file, conflict)
      await learner.opensFile(file)
      await expect(learner.definition("backOff")).toHaveCount(1)
      const room = page.getByRole("button", {name: "Room", exact: true})
      // A phone shows one part of the page at a time.
      if (size.width < 600) await room.tap()
      const problems = page.getByRole("tab", {name: /Problems/})
      await expect(problems).toContainText("1")
      await problems.tap()
      const card = page.getByTestId("problems").getByRole("article")
      await expect(card).toHaveCount(1)
      await expect(card).toContainText("both set the velocity, and")
      // The way out is shown before it is chosen.
      await expect(card.getByRole("list", {name: "Ways to mend it"})).toContainText(/bumps \d+ times/)
      await learner.keeps(`touch-conflict-${size.width}`)
      for (const button of await card.getByRole("button").all())
        expect((await boxAtRest(button)).height).toBeGreaterThanOrEqual(smallestButton)
      await card.getByRole("button", {name: / go first/}).tap()
      await expect(page.getByTestId("problems")).toContainText("No problems")
    })
  })

test.describe("with a finger", () => {
  test.use({viewport: {width: 820, height: 1180}, hasTouch: true, isMobile: true})

  test("a tap on the robot, beside its trail, and on a value asks why; a drag still moves the robot", async ({
    page,
  }) => {
    const learner = new Learner(page)
    await learner.opens("accelerateAndPlay")
    const console = page.getByTestId("console")
    await page.getByRole("button", {name: "Trail, picture and film"}).tap()
    await page.getByRole("checkbox", {name: "Show values in the program"}).check()
    await page.keyboard.press("Escape")
    await learner.runs()
    await expect(console).toContainText("Bumper CenterBumper Pressed")
    await page.getByRole("button", {name: "Pause", exact: true}).tap()
    const heading = page.getByTestId("why").getByRole("heading")
    const closes = async () => {
      await page.getByRole("button", {name: "Close the answer"}).tap()
      await expect(heading).toHaveCount(0)
    }
    const metres = async (what: "x" | "y") =>
      Number.parseFloat((await learner.robot(what).textContent()) ?? "")
    const floor = new Floor(page, [5, 4])
    const before = [await metres("x"), await metres("y")] as const

    await page.touchscreen.tap(...(await floor.pixel(...before)))
    await expect(heading).toHaveText("Why does it move like this?")
    await learner.keeps("touch-why-robot")
    await closes()
    expect([await metres("x"), await metres("y")]).toEqual(before)

    const [x, y] = await floor.pixel(3, before[1])
    await page.touchscreen.tap(x, y + 20)
    await expect(heading).toHaveText(/^Why was the robot there at \d+\.\d\d s\?$/)
    await closes()
    await learner.definition("accelerate").locator("> .rosyValue").tap()
    await expect(heading).toHaveText("Why did accelerate run?")
    await closes()
    await console.getByRole("button", {name: "Why ErrorSound?"}).tap()
    await expect(page.getByTestId("why-answer")).toContainText(/play sent ErrorSound/)
    await closes()

    const finger = await Finger.on(page)
    const [fromX, fromY] = await floor.pixel(...before)
    await finger.takesUp({x: fromX, y: fromY})
    const [toX, toY] = await floor.pixel(2, 3)
    await finger.movesTo({x: toX, y: toY})
    await finger.letsGo()
    await expect.poll(() => metres("x")).toBeLessThan(3)
    await expect(heading).toHaveCount(0)
    await learner.stops()
  })
})

/// All of it is in the window.
async function isInWindow(target: Locator): Promise<void> {
  const box = await boxAtRest(target)
  const window = target.page().viewportSize()!
  expect(box.x).toBeGreaterThanOrEqual(0)
  expect(box.x + box.width).toBeLessThanOrEqual(window.width)
  expect(box.y + box.height).toBeLessThanOrEqual(window.height)
}
