import {uniqueName} from "@rosy/codegen"
import {expect, test} from "vitest"
import {withUniqueNames} from "../../src/views/blocks/construction/unique_names.ts"
import {spacingMoves} from "../../src/views/blocks/dragging/placement.ts"

test("a name that is taken gets the first number that is free", () => {
  expect(uniqueName("f", new Set())).toBe("f")
  expect(uniqueName("f", new Set(["f"]))).toBe("f2")
  expect(uniqueName("f2", new Set(["f", "f2", "f3"]))).toBe("f4")
})

test("a type that comes twice gets new constructors too", () => {
  const extra = {name: "Mode", constructors: [{name: "Go", fields: []}]}
  expect(withUniqueNames(extra, new Set(["Mode", "Go"]))).toEqual({
    name: "Mode2",
    constructors: [{name: "Go2", fields: []}],
  })
})

test("the parts of its constructors, too", () => {
  const place = (name: string, part: string) => ({name, fields: [{name: part, type: "Double"}]})
  const extra = {name: "Place", constructors: [place("Place", "x"), place("There", "x")]}
  expect(withUniqueNames(extra, new Set(["Place", "There", "x"]))).toEqual({
    name: "Place2",
    constructors: [place("Place2", "x2"), place("There2", "x2")],
  })
})

const box = (top: number, bottom: number, left = 0) => ({top, bottom, left, right: left + 100})

test("what a grown block would cover moves down, and what that would cover after it", () => {
  const before = new Map([
    ["a", box(0, 50)],
    ["b", box(60, 100)],
    ["c", box(110, 150)],
    ["aside", box(60, 100, 300)],
  ])
  const moves = spacingMoves(before, new Map(before).set("a", box(0, 90)))
  expect([...moves.keys()]).toEqual(["b", "c"])
  expect(60 + moves.get("b")!).toBeGreaterThan(90)
  expect(110 + moves.get("c")!).toBeGreaterThan(100 + moves.get("b")!)
})

test("what overlapped before stays where it was put", () => {
  const before = new Map([
    ["a", box(0, 70)],
    ["b", box(60, 100)],
  ])
  expect(spacingMoves(before, new Map(before).set("a", box(0, 90))).size).toBe(0)
})
