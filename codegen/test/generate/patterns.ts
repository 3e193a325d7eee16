/// Patterns that may go into a socket of some type.

import {choices} from "../../src/blocks/spec/constructor_labels.ts"
import type {SavedBlock} from "../../src/index.ts"
import type {Type} from "../../src/types/syntax/type.ts"
import {spine} from "../../src/types/syntax/type.ts"
import type {Maker, WithOrigin} from "./blocks.ts"
import {libraryConstructors} from "./blocks.ts"

export function proposePattern(make: Maker, wanted: Type): SavedBlock {
  const {dice} = make
  const fitting = ofType(make, wanted)
  return dice.weighed<() => SavedBlock>([
    [6, () => make.named()],
    [2, () => make.block("pattern_any", {what: "thing"})],
    [fitting === undefined ? 0 : 8, () => fitting ?? make.named()],
    [
      fitting === undefined ? 0 : 1,
      () => make.block("pattern_as", {name: make.name()}, {P: fitting ?? make.named()}),
    ],
    [1, () => anything(make)],
  ])()
}

function made(make: Maker, c: WithOrigin): SavedBlock {
  const fields = c.fieldNames.flatMap(n => n ?? [])
  return fields.length > 0 && make.dice.once(3)
    ? make.block("pattern_record", {con: c.con, fields: [make.dice.pick(fields)]})
    : make.block("pattern_construct", {con: c.con, args: c.fields.length})
}

function ofType(make: Maker, wanted: Type): SavedBlock | undefined {
  const {dice} = make
  const {head, args} = spine(wanted)
  if (head.kind !== "con") return undefined
  if (["Double", "Int", "Integer", "Seconds", "Orientation"].includes(head.name))
    return dice.once(3) ? make.block("pattern_number", {value: dice.pick(["0", "1", "-1"])}) : undefined
  if (head.name === "Char") return make.block("pattern_character", {value: dice.pick(["a", "'", " "])})
  if (/^\(,*\)$/.test(head.name)) return make.block("pattern_tuple", {items: args.length})
  if (head.name === "[]") {
    const [item] = args
    if (item !== undefined && spine(item).head.kind === "con" && dice.once(2))
      return make.block("pattern_text", {value: dice.pick(["", "hi"])})
    return dice.once(2)
      ? make.block("pattern_list", {items: dice.below(3)})
      : make.block("pattern_infix", {op: ":"})
  }
  const of = choices[head.name]
  if (of !== undefined) return make.block("pattern_choice", {of: head.name, value: dice.pick(of.options)})
  const all = make.constructorsOf(head.name)
  return all.length === 0 ? undefined : made(make, dice.pick(all))
}

function anything(make: Maker): SavedBlock {
  const {dice} = make
  return dice.pick<() => SavedBlock>([
    () => made(make, dice.pick([...make.own, ...libraryConstructors])),
    () => {
      const of = dice.pick(Object.keys(choices))
      return make.block("pattern_choice", {of, value: dice.pick(choices[of]?.options ?? ["True"])})
    },
    () => make.block("pattern_tuple", {items: 2}),
    () => make.block("pattern_list", {items: dice.below(2)}),
    () => make.block("pattern_infix", {op: ":"}),
    () => make.block("pattern_number", {value: dice.pick(["0", "1", "-1", "0.5"])}),
    () => make.block("pattern_text", {value: "hi"}),
    () => make.block("pattern_character", {value: "z"}),
  ])()
}
