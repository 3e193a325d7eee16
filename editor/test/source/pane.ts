/// A page with a Haskell pane, for the tests of the pane in a browser.

import type {Page} from "playwright-core"
import type {Stage} from "../blocks/browser.ts"

/// A page with nothing but an empty pane, which has the focus.
export async function openPane(stage: Stage): Promise<Page> {
  const page = await stage.openOwn("empty")
  await page.addScriptTag({
    type: "module",
    content: 'import * as source from "/src/views/source/haskell_pane.ts"; Object.assign(window, source)',
  })
  await page.waitForFunction("window.openHaskellPane !== undefined")
  await page.evaluate(() => {
    const {openHaskellPane} = window as unknown as typeof import("../../src/views/source/haskell_pane.ts")
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
      pasted: nothing,
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

/// The text in the pane.
export const textOf = (page: Page): Promise<string> =>
  page.evaluate(() => [...document.querySelectorAll(".cm-line")].map(line => line.textContent).join("\n"))
