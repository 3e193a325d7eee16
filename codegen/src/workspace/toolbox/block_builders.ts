/// Block builders: short functions that make serialized blocks for the toolbox.

import {labelsOf} from "../../blocks/spec/constructor_labels.ts"
import type {Extra, SavedBlock} from "../../serialized_blocks.ts"

export function make(
  type: string,
  extra: Extra = {},
  sockets: {readonly [name: string]: SavedBlock} = {},
): SavedBlock {
  return {
    type,
    ...(Object.keys(extra).length > 0 ? {extraState: extra} : {}),
    ...(Object.keys(sockets).length > 0
      ? {inputs: Object.fromEntries(Object.entries(sockets).map(([name, block]) => [name, {block}]))}
      : {}),
  }
}

export const num = (value: string) => make("number", {value})
export const text = (value: string) => make("text", {value})
export const ref = (name: string) => make("name", {name, args: 0})
export const named = (name: string) => make("pattern_name", {name})
export const anything = (what: string) => make("pattern_any", {what})
export const pick = (of: string, value: string) => make("choice", {of, value})
export const match = (of: string, value: string) => make("pattern_choice", {of, value})
export const numbered = (blocks: readonly SavedBlock[], letter: string) =>
  Object.fromEntries(blocks.map((b, i) => [`${letter}${i}`, b]))
export const con = (name: string, ...args: readonly SavedBlock[]) =>
  make(
    "construct",
    {con: name, args: Math.max(args.length, labelsOf(name).parts.length)},
    numbered(args, "A"),
  )
export const pat = (name: string, ...args: readonly SavedBlock[]) =>
  make(
    "pattern_construct",
    {con: name, args: Math.max(args.length, labelsOf(name).parts.length)},
    numbered(args, "A"),
  )
export const call = (name: string, count: number, ...args: readonly SavedBlock[]) =>
  make("name", {name, args: count, fn: true}, numbered(args, "A"))
export const infix = (op: string, left?: SavedBlock, right?: SavedBlock) =>
  make("infix", {op}, {...(left === undefined ? {} : {L: left}), ...(right === undefined ? {} : {R: right})})

export function reaction(
  name: string,
  as: string,
  patterns: readonly SavedBlock[],
  answer?: SavedBlock,
): SavedBlock {
  return make(
    "define",
    {name, as, arity: patterns.length, equations: [{}]},
    {
      ...Object.fromEntries(patterns.map((p, i) => [`P0_${i}`, p])),
      ...(answer === undefined ? {} : {E0_0: answer}),
    },
  )
}

/// What a definition answers to each of several inputs.
export function answers(
  name: string,
  cases: readonly {readonly when: SavedBlock; readonly answer: SavedBlock}[],
  as = "event",
): SavedBlock {
  return make(
    "define",
    {name, as, arity: 1, equations: cases.map(() => ({}))},
    Object.fromEntries(
      cases.flatMap(({when, answer}, i) => [
        [`P${i}_0`, when],
        [`E${i}_0`, answer],
      ]),
    ),
  )
}

/// A definition with an empty place for what it answers to some inputs. It answers nothing to all others, so that it has a case for
/// each input as it is.
export const sometimes = (name: string, when: SavedBlock, as?: string): SavedBlock =>
  answers(
    name,
    [
      {when, answer: con("Just")},
      {when: anything("thing"), answer: con("Nothing")},
    ],
    as,
  )

/// Steps one below the other.
export function stacked([first, ...rest]: readonly SavedBlock[]): SavedBlock {
  if (first === undefined) throw new Error("expected at least one step, found none")
  return rest.length === 0 ? first : {...first, next: {block: stacked(rest)}}
}
