import {expect, test, vi} from "vitest"
import {flyoutBlock, toolboxInfo} from "../../src/views/blocks/interaction/toolbox.ts"
import {search, searchEntries, searchNear} from "../../src/views/blocks/interaction/toolbox_search.ts"
import {small} from "./small_language.ts"

const items = searchEntries(
  small.toolbox("reactions").flatMap(category => category.items),
  small.blockTypes,
)
const found = (query: string) => search(items, query).map(item => item.label)

test("every word of a query must be somewhere in the label, in any order", () => {
  expect(found("drive velocity")).toEqual(["velocity drive speed"])
  expect(found("drive sound")).toEqual([])
})

test("the start of a label counts more than the start of a word, and that more than the middle", () => {
  const labels = ["xtrue", "not true", "true"]
  const made = searchEntries(
    labels.map(label => ({label, block: {type: label}})),
    [],
  )
  expect(search(made, "true").map(item => item.label)).toEqual(["true", "not true", "xtrue"])
})

test("what stands on a block finds it too, after what its label says", () => {
  expect(found("errorsound")).toEqual(["sound play"])
  expect(found("velocity")).toEqual(["velocity drive speed"])
})

test("capitals and accents do not matter, in the query and in the words", () => {
  const made = searchEntries(
    [
      {label: "Número", block: {type: "a"}, also: "ângulo"},
      {label: "outro", block: {type: "b"}},
    ],
    [],
  )
  for (const query of ["numero", "NÚMERO", "angulo", "âng"])
    expect(search(made, query).map(item => item.label)).toEqual(["Número"])
})

test("accents, the width of spaces and the kind of apostrophe do not matter", () => {
  const made = searchEntries(
    ["répéter sans fin", "arrêter", "Sound\u00a0: jouer un son", "avancer jusqu’au choc"].map(label => ({
      label,
      block: {type: label},
    })),
    [],
  )
  const labels = (query: string) => search(made, query).map(item => item.label)
  expect(labels("repeter")).toEqual(["répéter sans fin"])
  expect(labels("ARRÊTER")).toEqual(["arrêter"])
  expect(labels("sound : jouer")).toEqual(["Sound\u00a0: jouer un son"])
  expect(labels("jusqu'au")).toEqual(["avancer jusqu’au choc"])
})

test("nothing is found for nothing", () => {
  expect(found("  ")).toEqual([])
})

test("a block from the toolbox brings no id along, at any depth", () => {
  const block = {
    type: "a",
    id: "1",
    x: 3,
    inputs: {L: {block: {type: "b", id: "2"}}},
    next: {block: {type: "c", id: "3"}},
  }
  expect(JSON.stringify(flyoutBlock({block}))).not.toMatch(/"id"|"x"/)
})

test("search comes first and the names in scope last", () => {
  const names = (toolboxInfo(small, "reactions").contents as unknown as {name: string}[]).map(c => c.name)
  expect(names[0]).toBe("Search blocks")
  expect(names.at(-1)).toBe("Names in scope")
})

test("what the search looks through is computed once, when it is first used", () => {
  const libraryItems = vi.fn(() => small.libraryItems())
  const [first] = toolboxInfo({...small, libraryItems}, "reactions").contents
  expect(libraryItems).not.toHaveBeenCalled()
  const {entries} = first as unknown as {entries: () => readonly unknown[]}
  expect(entries()).toBe(entries())
  expect(libraryItems).toHaveBeenCalledOnce()
})

test.each([
  ["bakwards", ["drive back"]],
  ["wehn it bumps", ["when the bumper is pressed"]],
  ["drive to the moon", ["drive back", "when the bumper is pressed"]],
  ["rotaet", ["turn"]],
  ["ct", []],
  ["?!", []],
] as const)("what is near %s, which finds nothing", (query, expected) => {
  const made = searchEntries(
    [
      {label: "drive back", block: {type: "a"}, also: "backwards reverse"},
      {label: "turn", block: {type: "b"}, also: "rotate cat"},
      {label: "when the bumper is pressed", block: {type: "c"}},
    ],
    [],
  )
  expect(search(made, query)).toEqual([])
  expect(searchNear(made, query).map(item => item.label)).toEqual(expected)
})
