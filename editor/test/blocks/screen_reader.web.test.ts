/// What a screen reader finds: the browser's own tree of names and roles, over all kinds of blocks of the real language.

import type {Page} from "playwright-core"
import {afterAll, beforeAll, expect, inject, test} from "vitest"
import {drag, grip, openStage, type Stage, settled, socket, told} from "./browser.ts"

let stage: Stage
beforeAll(async () => {
  stage = await openStage(inject("stage"))
})
afterAll(() => stage.close())

/// What can be pressed, filled or entered, and what stands for something.
const named = new Set([
  "application",
  "button",
  "combobox",
  "figure",
  "image",
  "option",
  "searchbox",
  "textbox",
  "tree",
  "treeitem",
])

interface Heard {
  readonly role: string
  readonly name: string
}

async function heard(page: Page): Promise<readonly Heard[]> {
  const session = await page.context().newCDPSession(page)
  const {nodes} = await session.send("Accessibility.getFullAXTree")
  await session.detach()
  return nodes
    .filter(node => !node.ignored)
    .map(node => ({role: String(node.role?.value), name: String(node.name?.value ?? "").trim()}))
}

/// Kinds of blocks that are on the page at once: what is out of sight is not drawn.
const atOnce = 14

test("every kind of block, every place and every field has a name", async () => {
  const page = await stage.open("empty")
  const kinds = await page.evaluate(() => window.codegen.blockTypes.map(({type}) => type))
  const unnamed: unknown[] = []
  for (let first = 0; first < kinds.length; first += atOnce) {
    const some = kinds.slice(first, first + atOnce)
    const wanted = await page.evaluate(types => {
      window.blocks.load({
        blocks: {
          languageVersion: 0,
          blocks: types.map((type, at) => ({type, id: type, x: 20 + (at % 2) * 420, y: 20 + 50 * at})),
        },
      })
      const workspace = window.Blockly.getMainWorkspace() as import("blockly/core").WorkspaceSvg
      workspace.zoomToFit()
      const inputs = workspace.getAllBlocks(false).flatMap(block => block.inputList)
      const places = inputs.flatMap(({connection}) => connection ?? [])
      const fields = inputs.flatMap(({fieldRow}) => fieldRow).filter(field => field.isClickable())
      return [...(places as import("blockly/core").RenderedConnection[]), ...fields].map(
        node => node.getFocusableElement()?.getAttribute("aria-label") ?? "",
      )
    }, some)
    await settled(page)
    const all = await heard(page)
    const names = new Set(all.map(({name}) => name))
    unnamed.push(...all.filter(({role, name}) => named.has(role) && name === ""))
    unnamed.push(...wanted.filter(name => name === "" || name === "Empty" || !names.has(name.trim())))
    expect(all.filter(({role}) => role === "figure").length, some.join(" ")).toBeGreaterThanOrEqual(
      some.length / 2,
    )
  }
  expect(unnamed).toEqual([])
})

test("an open field says which one it is", async () => {
  const page = await stage.open("empty")
  const without = await page.evaluate(async () => {
    const kinds = window.codegen.blockTypes.map(({type}) => type)
    window.blocks.load({
      blocks: {languageVersion: 0, blocks: kinds.map(type => ({type, id: type}))},
    })
    const found: string[] = []
    let opened = 0
    for (const block of window.Blockly.getMainWorkspace().getAllBlocks(false)) {
      for (const field of block.inputList.flatMap(input => input.fieldRow)) {
        if (!(field instanceof window.Blockly.FieldTextInput)) continue
        field.showEditor()
        const input = document.querySelector(".blocklyWidgetDiv .blocklyHtmlInput")
        if (!input?.getAttribute("aria-label")) found.push(`${block.type}: ${field.name}`)
        opened++
        window.Blockly.hideChaff()
      }
    }
    return {found, opened}
  })
  expect(without.found).toEqual([])
  expect(without.opened).toBeGreaterThan(10)
})

test("why a block does not fit is told in a live region", async () => {
  const page = await stage.open("small")
  const to = await socket(page, "empty", "L")
  await drag(page, await grip(page, "led"), {x: to.x + 14, y: to.y + 4}, true)
  const why = (await page.locator(".rosyRefusal").textContent()) ?? ""
  expect(why).toContain("wants a")
  await told(page, why)
  const live = await heard(page)
  await page.mouse.up()
  expect(live.filter(({role}) => role === "status").length).toBeGreaterThan(0)
})
