/// Every block that the toolbox offers explains itself: a tooltip with an example, and a link to the page that says more.

import {existsSync, readFileSync} from "node:fs"
import {blockView, type Level, preludeNames, type SavedBlock, toolbox} from "@rosy/codegen"
import {expect, test} from "vitest"
import {apiPage, helpAddress, placeOf, preludePage} from "../../src/help/help_links.ts"

function* inside(block: SavedBlock): Generator<SavedBlock> {
  yield block
  for (const input of Object.values(block.inputs ?? {})) if (input.block) yield* inside(input.block)
  if (block.next?.block) yield* inside(block.next.block)
}

const levels: readonly Level[] = ["tasks", "reactions", "haskell"]
const blocks = levels
  .flatMap(level => toolbox(level))
  .flatMap(category => category.items)
  .flatMap(item => [...inside(item.block)])
const shapes = blocks.map(block => ({block, shape: blockView(block.type)?.shape(block.extraState ?? {})}))

test("every tooltip has an example", () => {
  expect(shapes.length).toBeGreaterThan(100)
  const bare = shapes.filter(({shape}) => !shape?.tooltip.includes("Example: "))
  expect(bare.map(({block}) => [block.type, block.extraState])).toEqual([])
})

// The page is made with the language (`./rosy start`).
const page = new URL("../../../.rosy/api-docs/Rosy.html", import.meta.url)

test.runIf(existsSync(page))("every help link into Rosy's page leads to what it names", () => {
  const html = readFileSync(page, "utf8")
  const links = new Set(shapes.map(({shape}) => helpAddress(shape?.help)))
  const dead = [...links].filter(link => {
    const [where, anchor] = link.split("#")
    return where === apiPage && anchor !== undefined && !html.includes(`id="${anchor}"`)
  })
  expect(links.size).toBeGreaterThan(30)
  expect(dead).toEqual([])
})

test("a name goes to its own place, and an operator by its numbers", () => {
  expect(helpAddress("v:wait")).toBe("api-docs/Rosy.html#v:wait")
  expect(helpAddress("t:Velocity")).toBe("api-docs/Rosy.html#t:Velocity")
  expect(helpAddress("v:&&")).toBe("prelude.html#v:-38--38-")
  expect(helpAddress("v:myOwn")).toBe("api-docs/Rosy.html")
})

test("every help link to a name of Haskell's own leads to its place on the page of those names", () => {
  const places = new Set(preludeNames().map(n => placeOf(`${n.kind === "type" ? "t" : "v"}:${n.name}`)))
  const links = [...new Set(shapes.map(({shape}) => helpAddress(shape?.help)))]
  const into = links.filter(link => link.startsWith(preludePage)).map(link => link.split("#")[1] ?? "")
  expect(into.length).toBeGreaterThan(20)
  expect(into.filter(place => !places.has(place))).toEqual([])
  expect(links.filter(link => link.includes("://"))).toEqual([])
})
