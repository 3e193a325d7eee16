/// What is typed stands where it is typed, also when marks change around it between two letters; and the cursor is the browser's own.

import type {Page} from "playwright-core"
import {afterAll, beforeAll, expect, inject, test} from "vitest"
import {openStage, type Stage} from "../blocks/browser.ts"

let stage: Stage
beforeAll(async () => {
  stage = await openStage(inject("stage"))
})
afterAll(() => stage.close())

/// A page with nothing but an empty pane, which has the focus.
async function openPane(): Promise<Page> {
  const page = await stage.openOwn("empty")
  await page.addScriptTag({
    type: "module",
    content: 'import * as source from "/src/source/haskell_pane.ts"; Object.assign(window, source)',
  })
  await page.waitForFunction("window.openHaskellPane !== undefined")
  await page.evaluate(() => {
    const {openHaskellPane} = window as unknown as typeof import("../../src/source/haskell_pane.ts")
    const host = document.createElement("div")
    document.body.replaceChildren(host)
    const nobody = () => null
    const nothing = () => undefined
    const pane = openHaskellPane(host, {
      label: "Haskell",
      description: "",
      completer: {fitting: async () => null, snippets: () => [], fromToolbox: ""},
      explainer: {about: async () => null, more: ""},
      renamer: {rename: nobody, words: {label: () => "", rename: ""}},
      phrases: {},
      longest: 1000,
      tooLong: nothing,
      format: nothing,
      cursorMoved: nothing,
      edited: nothing,
      mend: nothing,
      numbers: {hint: "", begins() {}, ends() {}, isBehind: () => false},
      fixHere: nobody,
      valueClicked: nothing,
      asked: nothing,
    })
    pane.setEditable(true)
    Object.assign(window, {pane})
  })
  await page.getByRole("textbox", {name: "Haskell"}).click()
  return page
}

test("a letter follows the one before it when the marks on that change twice in between", async () => {
  const page = await openPane()
  await page.keyboard.type("type Side = Either ")
  for (const letter of "Degrees") {
    await page.keyboard.type(letter)
    await page.evaluate(() => {
      const {pane} = window as unknown as {pane: import("../../src/source/haskell_pane_types.ts").HaskellPane}
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
  const page = await openPane()
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
