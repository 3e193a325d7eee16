/// Definitions on sockets: a function that is dropped where a function is wanted leaves a reference and returns to its place;
/// what cannot go there is refused with a reason. With the real language.

import {afterAll, beforeAll, expect, inject, test} from "vitest"
import {drag, grip, openStage, type Stage, settled, socket} from "./browser.ts"

let stage: Stage
beforeAll(async () => {
  stage = await openStage(inject("stage"))
})
afterAll(() => stage.close())

type Page = Awaited<ReturnType<Stage["open"]>>

/// A program that runs nothing yet, a function that drives, one without a type, a step and a value.
async function start(): Promise<Page> {
  const page = await stage.open("empty")
  await page.evaluate(() => {
    const name = (id: string, name: string) => ({block: {id, type: "name", extraState: {name, args: 0}}})
    const number = (id: string, value: string) => ({block: {id, type: "number", extraState: {value}}})
    window.blocks.load({
      blocks: {
        languageVersion: 0,
        blocks: [
          {
            id: "main",
            type: "main",
            x: 20,
            y: 20,
            extraState: {controllers: 2},
            inputs: {R1: name("r1", "go")},
          },
          {
            id: "go",
            type: "define",
            x: 20,
            y: 180,
            extraState: {name: "go", arity: 0, equations: [{}], signature: "Velocity"},
            inputs: {
              E0_0: {
                block: {
                  id: "velocity",
                  type: "construct",
                  extraState: {con: "Velocity", args: 2},
                  inputs: {A0: number("n0", "0.2"), A1: number("n1", "0")},
                },
              },
            },
          },
          {
            id: "count",
            type: "define",
            x: 20,
            y: 300,
            extraState: {name: "count", arity: 0, equations: [{}]},
            inputs: {E0_0: number("n2", "5")},
          },
          {id: "slow", type: "construct", x: 20, y: 470, extraState: {con: "Velocity", args: 2}},
          {id: "step", type: "step_wait", x: 20, y: 400, inputs: {X: number("n3", "1")}},
        ],
      },
    } as unknown as Parameters<typeof window.blocks.load>[0])
    window.blocks.focus()
  })
  await settled(page)
  return page
}

const inSocket = (page: Page, id: string, input: string) =>
  page.evaluate(
    ([block, name]) => {
      const main = window.Blockly.getMainWorkspace().getBlockById(block!)
      return main?.getInputTargetBlock(name!)?.toString() ?? ""
    },
    [id, input],
  )

const placeOf = (page: Page, id: string) =>
  page.evaluate(block => {
    const {x, y} = window.Blockly.getMainWorkspace().getBlockById(block)!.getRelativeToSurfaceXY()
    return {x, y}
  }, id)

test("a function dropped on a socket leaves a reference there and returns to its place; one undo takes it back", async () => {
  const page = await start()
  const before = await placeOf(page, "go")
  const to = await socket(page, "main", "R0")
  await drag(page, await grip(page, "go"), {x: to.x + 14, y: to.y + 10})
  await settled(page)
  expect(await inSocket(page, "main", "R0")).toBe("go")
  expect(await placeOf(page, "go")).toEqual(before)
  await page.evaluate(() => window.blocks.undo())
  await settled(page)
  expect(await inSocket(page, "main", "R0")).toBe("")
  expect(await placeOf(page, "go")).toEqual(before)
})

test.each([
  ["count", "main", "R0", /^A number is not a command; put Velocity here/],
  ["step", "slow", "A0", /^Then there would be a task where a number must be/],
] as const)("%s on a socket of %s is refused with a reason", async (id, block, input, why) => {
  const page = await start()
  const to = await socket(page, block, input)
  await drag(page, await grip(page, id), {x: to.x + 14, y: to.y + 10}, true)
  const line = page.locator(".rosyRefusal")
  expect(await line.isVisible()).toBe(true)
  expect(await line.textContent()).toMatch(why)
  await page.mouse.up()
  await settled(page)
  expect(await inSocket(page, block, input)).toBe("")
})

test("a new definition from the toolbox, clicked while a socket is chosen, is used there", async () => {
  const page = await start()
  const to = await socket(page, "main", "R0")
  await page.mouse.click(to.x + 14, to.y + 10)
  await page.keyboard.insertText("ready-made: drive straight on")
  await page.keyboard.press("Enter")
  await settled(page)
  expect(await inSocket(page, "main", "R0")).toBe("driveOn")
})

/// An empty program: `simulate` with one socket.
async function fresh(): Promise<Page> {
  const page = await stage.open("empty")
  await page.evaluate(() => {
    window.blocks.load({
      blocks: {languageVersion: 0, blocks: [{id: "main", type: "main", x: 20, y: 20}]},
    } as unknown as Parameters<typeof window.blocks.load>[0])
    window.blocks.focus()
  })
  await settled(page)
  return page
}

const haskell = (page: Page) => page.evaluate(() => window.codegen.toHaskell(window.blocks.save()).text)

test("a step from the toolbox dropped on the socket of simulate becomes a task of one step; one undo takes it back", async () => {
  const page = await fresh()
  await page.locator(".rosySearch").click()
  await page.keyboard.insertText("drive 50")
  await settled(page)
  const box = (await page.locator(".blocklyFlyout .blocklyDraggable > .blocklyPath").first().boundingBox())!
  const to = await socket(page, "main", "R0")
  await drag(page, {x: box.x + 9, y: box.y + 12}, {x: to.x + 14, y: to.y + 10})
  await settled(page)
  expect(await haskell(page)).toBe("main :: IO ()\nmain = simulate (drive 50)\n")
  await page.evaluate(() => window.blocks.undo())
  await settled(page)
  expect(await haskell(page)).toBe("main :: IO ()\nmain = simulate _\n")
})

test("a step chosen for the socket of simulate is its first step, and the next one comes below it", async () => {
  const page = await fresh()
  const to = await socket(page, "main", "R0")
  await page.mouse.click(to.x + 14, to.y + 10)
  await page.keyboard.insertText("drive 50")
  await page.keyboard.press("Enter")
  await settled(page)
  await page.keyboard.press("t")
  await page.keyboard.insertText("turn 90")
  await page.keyboard.press("Enter")
  await settled(page)
  expect(await haskell(page)).toBe("main :: IO ()\nmain = simulate $ do\n  drive 50\n  turn 90\n")
})

test("Look inside in a step's menu inserts the definition from the library", async () => {
  const page = await fresh()
  const to = await socket(page, "main", "R0")
  await page.mouse.click(to.x + 14, to.y + 10)
  await page.keyboard.insertText("blink a light")
  await page.keyboard.press("Enter")
  await settled(page)
  const id = await page.evaluate(
    () =>
      window.Blockly.getMainWorkspace()
        .getAllBlocks(false)
        .find(b => b.type === "step_blink")!.id,
  )
  await page.mouse.click((await grip(page, id)).x, (await grip(page, id)).y, {button: "right"})
  await page.getByRole("menuitem", {name: "Look inside"}).click()
  await settled(page)
  expect(await haskell(page)).toContain("blink :: LedColor -> Task ()\nblink color = do\n")
  await page.mouse.click((await grip(page, id)).x, (await grip(page, id)).y, {button: "right"})
  expect(await page.getByRole("menuitem", {name: "Look inside"}).count()).toBe(0)
})

test("the magnifying glass of a step looks inside, and afterwards leads to the definition; by mouse and by keyboard", async () => {
  const page = await fresh()
  const to = await socket(page, "main", "R0")
  await page.mouse.click(to.x + 14, to.y + 10)
  await page.keyboard.insertText("blink a light")
  await page.keyboard.press("Enter")
  await settled(page)
  const selected = () =>
    page.evaluate(() => {
      const block = window.Blockly.common.getSelected()
      return block === null ? "" : `${(block as unknown as {type: string}).type}`
    })
  const glass = page.locator(".blocklyBlockCanvas").getByLabel("look inside blink")
  const box = await glass.boundingBox()
  if (box === null) throw new Error("expected a magnifying glass")
  expect(Math.min(box.width, box.height)).toBeGreaterThanOrEqual(24)
  await page.mouse.click(box.x + box.width / 2, box.y + box.height / 2)
  await settled(page)
  const text = await haskell(page)
  expect(text).toContain("blink :: LedColor -> Task ()\nblink color = do\n")
  expect(await selected()).toBe("define")

  await glass.first().evaluate(button => (button as unknown as HTMLElement).focus())
  await page.keyboard.press("Enter")
  await settled(page)
  expect(await haskell(page)).toBe(text)
  expect(await selected()).toBe("define")
})

test("the magnifying glass of driveUntil asks for a function first, and gives the definition its type", async () => {
  const page = await fresh()
  const to = await socket(page, "main", "R0")
  await page.mouse.click(to.x + 14, to.y + 10)
  await page.keyboard.insertText("drive until a button")
  await page.keyboard.press("Enter")
  await settled(page)
  const glass = page.locator(".blocklyBlockCanvas").getByLabel("look inside driveUntil")
  await page.evaluate(() => {
    const blocks = window.Blockly.getMainWorkspace().getAllBlocks(false)
    // Unplugging and deleting are one step of undo, as with the Delete key.
    window.Blockly.Events.setGroup(true)
    blocks.find(b => b.type === "lambda")?.dispose()
    window.Blockly.Events.setGroup(false)
  })
  await settled(page)
  await glass.click()
  await page
    .locator(".blocklyToastMessage", {hasText: "First put a function into the empty place."})
    .waitFor({timeout: 600_000})

  await page.keyboard.press("Control+z")
  await settled(page)
  await glass.click()
  await settled(page)
  expect(await haskell(page)).toContain(
    "driveUntil :: (ButtonZero -> Done ()) -> Task ()\ndriveUntil ctrl = do\n",
  )
})
