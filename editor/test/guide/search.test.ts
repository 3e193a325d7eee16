/// Search of the guide: all words, beginnings, accents, order and excerpts.

import {expect, test} from "vitest"
import {type SearchEntry, search} from "../../src/guide/search.ts"

const entry = (heading: string, text: string): SearchEntry => ({
  page: "a.html",
  title: "Page",
  anchor: heading.toLowerCase(),
  heading,
  text,
})

const index = [
  entry("Bumpers", "A bumper is pressed at a wall."),
  entry("Walls", "What stops the robot, and what the bumper does."),
  entry("Memory", "What a function writes; a café has none."),
]
const found = (query: string) => search(index, query).map(({entry: {heading}}) => heading)

test("finds sections that contain all words, as words or as beginnings, whatever their case and accents", () => {
  expect(found("bumper wall")).toEqual(["Bumpers", "Walls"])
  expect(found("MEM")).toEqual(["Memory"])
  expect(found("cafe")).toEqual(["Memory"])
  expect(found("umper")).toEqual([])
  expect(found("bumper memory")).toEqual([])
  expect(found("  ?! ")).toEqual([])
})

test("a word of a heading comes before a word of a text", () => {
  expect(found("walls")).toEqual(["Walls"])
  expect(found("bumper")[0]).toBe("Bumpers")
})

test("an excerpt is whole words around the first word that was found", () => {
  const long = `${"before ".repeat(40)}needle ${"after ".repeat(40)}`.trim()
  const [result] = search([entry("Hay", long)], "needle")
  expect(result?.excerpt).toMatch(/^… (?:before )+needle (?:after )+after …$/)
  expect(search([entry("Hay", "short needle")], "needle")[0]?.excerpt).toBe("short needle")
})
