/// Places of moved nodes follow their function when it is renamed.

import {expect, it} from "vitest"
import type {ProgramPart, TypeShape} from "../../src/program/program_graph.ts"
import {placesAfter} from "../../src/views/diagram/layout/renamed_places.ts"
import {networkOf} from "../../src/views/diagram/network/network_builder.ts"

const type = (written: string): TypeShape => ({
  kind: "type",
  written,
  spelled: written,
  own: false,
  topic: null,
})
const either: TypeShape = {kind: "either", of: [type("Bumper"), type("Cliff")]}
const fn = (name: string, input: TypeShape = either): ProgramPart => ({
  kind: "function",
  name,
  at: null,
  inputs: [input],
  output: type("Velocity"),
})
const network = (...parts: readonly ProgramPart[]) => networkOf(parts, () => "")
const moved = {backOff: [10, 20] as const, Other: [1, 2] as const}
const before = network(fn("backOff"), fn("go", type("Wheel")))

it("the place of a renamed function is that of its new name", () => {
  expect(placesAfter(before, network(fn("flee"), fn("go", type("Wheel"))), moved)).toEqual({
    flee: [10, 20],
    Other: [1, 2],
  })
})

it("a function that is gone, or changed as well, leaves its place to none", () => {
  expect(placesAfter(before, network(fn("go", type("Wheel"))), moved)).toEqual(moved)
  expect(placesAfter(before, network(fn("flee", type("Cliff"))), moved)).toEqual(moved)
  expect(placesAfter(before, before, moved)).toBe(moved)
})
