import type {Place, Verdict} from "@rosy/codegen"
import {expect, test} from "vitest"
import {Movement} from "../../src/views/blocks/dragging/connection_checker.ts"

const refusing = () => {
  const asked: string[] = []
  const asker = {
    fits(place: Place, block: string): Verdict {
      asked.push(`${JSON.stringify(place)} ${block}`)
      return {fits: false, why: "no"}
    },
    referenceTo: () => ({fits: false, why: "no"}) as const,
    overriddenReaction: () => undefined,
  }
  return {asked, asker}
}

test("a movement asks codegen once for each place and block", () => {
  const {asked, asker} = refusing()
  const movement = new Movement(asker, undefined)
  for (let step = 0; step < 3; step++) {
    movement.verdict({block: "a", input: "L"}, "b")
    movement.verdict({below: "a"}, "b")
    movement.verdict({block: "a", input: "L"}, "c")
  }
  expect(asked).toHaveLength(3)
})

test("a block may always go back to where it was taken from, even if it never fitted there", () => {
  const {asked, asker} = refusing()
  const movement = new Movement(asker, {block: "a", input: "L"})
  expect(movement.verdict({block: "a", input: "L"}, "b")).toEqual({fits: true})
  expect(movement.verdict({block: "a", input: "R"}, "b").fits).toBe(false)
  expect(asked).toHaveLength(1)
})
