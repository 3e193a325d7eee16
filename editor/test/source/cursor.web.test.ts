/// What is typed stands where it is typed, also when marks change around it between two letters; and the cursor is the browser's own.

import {afterAll, beforeAll, expect, inject, test} from "vitest"
import {openStage, type Stage} from "../blocks/browser.ts"
import {openPane} from "./pane.ts"

let stage: Stage
beforeAll(async () => {
  stage = await openStage(inject("stage"))
})
afterAll(() => stage.close())

test("a letter follows the one before it when the marks on that change twice in between", async () => {
  const page = await openPane(stage)
  await page.keyboard.type("type Side = Either ")
  for (const letter of "Degrees") {
    await page.keyboard.type(letter)
    await page.evaluate(() => {
      const {pane} = window as unknown as {
        pane: import("../../src/views/source/haskell_pane_types.ts").HaskellPane
      }
      const end = pane.cursor()
      pane.mark([
        {
          severity: "error",
          message: "",
          hint: "",
          kind: "other",
          range: {start: 5, end: end - 1},
          block: null,
          fixes: [],
        } as never,
      ])
      pane.link({start: 0, end: end - 1})
    })
  }
  expect(await page.getByRole("textbox", {name: "Haskell"}).textContent()).toBe("type Side = Either Degrees")
})

test("the browser draws the cursor: a drawing of the page's own would cost each key a layer and a frame", async () => {
  const page = await openPane(stage)
  await page.keyboard.type("x")
  const drawn = await page.evaluate(() => {
    const content = document.querySelector(".cm-content")
    return {
      own: document.querySelectorAll(".cm-cursorLayer, .cm-selectionLayer").length,
      colour: content === null ? "" : getComputedStyle(content).caretColor,
      animations: document.getAnimations().length,
    }
  })
  expect(drawn).toEqual({
    own: 0,
    colour: expect.stringMatching(/^(?!rgba\(0, 0, 0, 0\)|transparent).+/),
    animations: 0,
  })
})

test("the focus stays where it went from a cursor at the break of a wrapped line", async () => {
  const page = await openPane(stage)
  await page.evaluate(() => {
    const field = document.createElement("input")
    document.body.append(field)
    const pane = document.querySelector<HTMLElement>(".cm-editor")
    if (pane !== null) pane.style.width = "200px"
  })
  await page.keyboard.type("one two three four five six seven eight nine ten eleven twelve")
  await page.keyboard.press("Control+Home")
  // The end of what is drawn as the first line.
  await page.keyboard.press("End")
  await page.locator("input").last().click()
  // CodeMirror learns of it in a task of its own, and measures in a frame after that.
  const focused = await page.evaluate(async () => {
    const frame = () => new Promise(done => requestAnimationFrame(done))
    for (let frames = 0; frames < 10; frames++) await frame()
    return document.activeElement?.tagName
  })
  expect(focused).toBe("INPUT")
})
