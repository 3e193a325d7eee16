/// A block that does not fit says why: to the eye near the pointer or the finger, and to a screen reader. With the real
/// language.

import {afterAll, beforeAll, expect, inject, test} from "vitest"
import {drag, Finger, grip, openStage, type Stage, settled, socket, told} from "./browser.ts"

let stage: Stage
beforeAll(async () => {
  stage = await openStage(inject("stage"))
})
afterAll(() => stage.close())

type Page = Awaited<ReturnType<Stage["open"]>>

/// A function of a velocity, another that binds `gap`, a light, and a velocity with empty sockets.
async function start(): Promise<Page> {
  const page = await stage.open("empty")
  await page.evaluate(() => {
    const define = (id: string, y: number, name: string, input: object, signature: string) => ({
      id,
      type: "define",
      x: 20,
      y,
      extraState: {name, arity: 1, equations: [{}], signature},
      inputs: {P0_0: {block: {id: `${id}-in`, type: "pattern_name", extraState: input}}},
    })
    window.blocks.load({
      blocks: {
        languageVersion: 0,
        blocks: [
          define("go", 20, "go", {name: "x"}, "Position -> Velocity"),
          define("far", 240, "far", {name: "gap"}, "Double -> Double"),
          {id: "light", type: "construct", x: 500, y: 40, extraState: {con: "Led1", args: 1}},
          {id: "out", type: "name", x: 500, y: 240, extraState: {name: "gap"}},
        ],
      },
    } as unknown as Parameters<typeof window.blocks.load>[0])
    window.blocks.focus()
  })
  await settled(page)
  return page
}

async function said(page: Page): Promise<string> {
  const line = page.locator(".rosyRefusal")
  expect(await line.isVisible()).toBe(true)
  const words = (await line.textContent()) ?? ""
  // A screen reader hears the same.
  await told(page, words)
  return words
}

test("a light does not fit where a velocity is wanted", async () => {
  const page = await start()
  const to = await socket(page, "go", "E0_0")
  await drag(page, await grip(page, "light"), {x: to.x + 12, y: to.y + 8}, true)
  expect(await said(page)).toMatch(/^This socket wants a Velocity, and `?Led1`? is /)
  await page.mouse.up()
})

test("a name stays in the function that binds it", async () => {
  const page = await start()
  const to = await socket(page, "go", "E0_0")
  await drag(page, await grip(page, "out"), {x: to.x + 12, y: to.y + 8}, true)
  expect(await said(page)).toContain("gap")
  await page.mouse.up()
})

test("a finger is told, too", async () => {
  const page = await start()
  const to = await socket(page, "go", "E0_0")
  const from = await grip(page, "light")
  const finger = await Finger.on(page)
  await finger.carry(from, {x: to.x + 12, y: to.y + 8})
  expect(await said(page)).toMatch(/^This socket wants a Velocity/)
  await finger.up()
  await settled(page)
  expect(
    await page.evaluate(() => window.Blockly.getMainWorkspace().getBlockById("light")?.getParent()),
  ).toBeNull()
})

test("the keys step only to places that accept the block", async () => {
  const page = await start()
  await page.evaluate(() => window.blocks.select("light"))
  await page.keyboard.press("m")
  await settled(page)
  for (let step = 0; step < 4; step++) await page.keyboard.press("ArrowDown")
  await page.keyboard.press("Enter")
  await settled(page)
  expect(
    await page.evaluate(() => window.Blockly.getMainWorkspace().getBlockById("light")?.getParent()),
  ).toBeNull()
})

test("a level hides nothing of a program and locks nothing in it", async () => {
  const page = await stage.open("example=randomWalk&level=haskell")
  const before = await page.evaluate(() => JSON.stringify(window.blocks.save()))
  await page.evaluate(() => window.blocks.setLevel("tasks"))
  await settled(page)
  expect(await page.evaluate(() => JSON.stringify(window.blocks.save()))).toBe(before)
  const locked = await page.evaluate(() =>
    window.Blockly.getMainWorkspace()
      .getAllBlocks(false)
      .filter(block => !block.isMovable() || !block.isEditable() || !block.isDeletable())
      .map(block => block.type),
  )
  expect(locked).toEqual([])
})

test("where only the compiler knows whether a block fits, the drag says so, and the block goes in", async () => {
  const page = await start()
  const from = await page.evaluate(() => {
    const block = window.Blockly.serialization.blocks.append(
      {id: "text", type: "raw_expression", x: 500, y: 340, extraState: {text: "blend", reason: "expression"}},
      window.Blockly.getMainWorkspace(),
    )
    return block.id
  })
  await settled(page)
  const to = await socket(page, "far", "E0_0")
  await drag(page, await grip(page, from), {x: to.x + 12, y: to.y + 8}, true)
  expect(await said(page)).toBe("Only the compiler knows the types here, and so whether this fits.")
  await page.mouse.up()
  await settled(page)
  expect(
    await page.evaluate(() => window.Blockly.getMainWorkspace().getBlockById("text")?.getParent()?.id),
  ).toBe("far")
})
