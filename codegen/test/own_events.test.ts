/// The ready reaction to an own event takes the event where the program has one, and nowhere else.

import {expect, it} from "vitest"
import type {SavedBlock, SavedWorkspace} from "../src/serialized_blocks.ts"
import {ownEventReaction, withOnlyEvent} from "../src/workspace/toolbox/own_events.ts"

const data = (name: string, ...fields: readonly {readonly type: string}[]): SavedBlock => ({
  type: "data",
  extraState: {name, constructors: [{name, fields}]},
})
const program = (...blocks: SavedBlock[]): SavedWorkspace => ({blocks: {languageVersion: 0, blocks}})

it("takes the only event", () => {
  const {inputs} = withOnlyEvent(ownEventReaction(), program(data("Knock")))
  expect(inputs).toEqual({
    P0_0: {block: {type: "pattern_construct", extraState: {con: "Knock", args: 0}}},
  })
})

it("stays empty with no event, several, or one that carries a value, and other blocks stay as they are", () => {
  const reaction = ownEventReaction()
  for (const workspace of [
    program(),
    program(data("Knock"), data("Ring")),
    program(data("At", {type: "Int"})),
  ])
    expect(withOnlyEvent(reaction, workspace)).toBe(reaction)
  const other: SavedBlock = {
    type: "define",
    extraState: {name: "mine", as: "event", arity: 1, equations: [{}]},
  }
  expect(withOnlyEvent(other, program(data("Knock")))).toBe(other)
  const filled: SavedBlock = {...reaction, inputs: {}}
  expect(withOnlyEvent(filled, program(data("Knock")))).toBe(filled)
})
