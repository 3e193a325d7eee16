/// A number is changed by dragging its digits, and pulled out by the edge of its block.

import {afterAll, beforeAll, expect, inject, test} from "vitest"
import {drag, openStage, type Stage, settled} from "./browser.ts"
import {Keys} from "./keyboard_user.ts"

let stage: Stage
beforeAll(async () => {
  stage = await openStage(inject("stage"))
})
afterAll(() => stage.close())

/// A program with one number, and the box of the number's block.
async function withNumber(literal: string) {
  const keys = await Keys.onEmpty(stage)
  await keys.page.evaluate(value => {
    window.blocks.load({
      blocks: {
        languageVersion: 0,
        blocks: [
          {
            id: "main",
            type: "main",
            x: 60,
            y: 40,
            inputs: {
              R0: {
                block: {
                  type: "do",
                  inputs: {
                    S: {
                      block: {
                        type: "step_wait",
                        inputs: {X: {block: {id: "n", type: "number", extraState: {value}}}},
                      },
                    },
                  },
                },
              },
            },
          },
        ],
      },
    } as unknown as Parameters<typeof window.blocks.load>[0])
  }, literal)
  await settled(keys.page)
  return {keys, box: (await keys.page.locator('[data-id="n"] > .blocklyPath').boundingBox())!}
}

test.each([
  ["130", 40, "140"],
  ["130", -40, "120"],
  ["0.5", 8, "0.6"],
  ["0.5", -44, "(-0.05)"],
  ["2", 80, "32"],
] as const)("%s dragged %i pixels is %s, in its place", async (literal, way, expected) => {
  const {keys, box} = await withNumber(literal)
  const middle = {x: box.x + box.width / 2, y: box.y + box.height / 2}
  await drag(keys.page, middle, {x: middle.x + way, y: middle.y + 60})
  await settled(keys.page)
  expect(await keys.haskell()).toContain(`wait ${expected}`)
})

test("by its edge a number is pulled out", async () => {
  const {keys, box} = await withNumber("130")
  const edge = {x: box.x + 2, y: box.y + box.height / 2}
  await drag(keys.page, edge, {x: edge.x + 40, y: edge.y + 160})
  await settled(keys.page)
  expect(await keys.haskell()).toContain("wait _")
})

test("a press without a drag opens the number for typing", async () => {
  const {keys, box} = await withNumber("130")
  await keys.page.mouse.click(box.x + box.width / 2, box.y + box.height / 2)
  await keys.page.keyboard.type("7")
  await keys.page.keyboard.press("Enter")
  await settled(keys.page)
  expect(await keys.haskell()).toContain("wait 7")
})
