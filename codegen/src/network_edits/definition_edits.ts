/// Edits of one definition's blocks: a further input or output, or one less. The signature is text, and so are its edits.

import {partOf} from "../blocks/families/right_hand_side.ts"
import {objectsIn} from "../blocks/spec/block_spec.ts"
import {uniqueName} from "../model/unique_name.ts"
import {records} from "../robot/roles.ts"
import type {Extra, SavedBlock, SavedInput} from "../serialized_blocks.ts"
import {library} from "../types/environment/standard_library.ts"
import {spine, type Type} from "../types/syntax/type.ts"
import {parseType} from "../types/syntax/type_parser.ts"
import {everyBlockIn} from "../workspace/inference/workspace_inference.ts"
import {make, named, pat} from "../workspace/toolbox/block_builders.ts"

type Inputs = {readonly [name: string]: SavedInput}

/// Maximum number of arguments, as in blocks.
export const mostArguments = 9

export const equationsOf = ({extraState = {}}: SavedBlock): readonly Extra[] => {
  const equations = objectsIn(extraState, "equations")
  return equations.length === 0 ? [{}] : equations
}

export const arityOf = ({extraState = {}}: SavedBlock): number =>
  typeof extraState.arity === "number" ? extraState.arity : 0

export const patternAt = (define: SavedBlock, equation: number, argument: number): SavedBlock | undefined =>
  define.inputs?.[`P${equation}_${argument}`]?.block

/// The sockets of all answers of a definition.
export function answersOf(define: SavedBlock): readonly string[] {
  return equationsOf(define).flatMap((equation, i) => {
    const {guards, otherwise} = partOf(equation)
    const count = Math.max(1, guards)
    const conditional = Array.from({length: count}, (_, g) => `E${i}_${g}`)
    return guards > 0 && otherwise ? [...conditional, `O${i}`] : conditional
  })
}

/// The definition with other patterns: `of` gives those of each equation.
export function withPatterns(
  define: SavedBlock,
  of: (equation: number) => readonly (SavedBlock | undefined)[],
): SavedBlock {
  const equations = equationsOf(define)
  const rest = Object.entries(define.inputs ?? {}).filter(([name]) => !/^P\d+_\d+$/.test(name))
  const all = equations.map((_, i) => of(i))
  const patterns = all.flatMap((row, i) =>
    row.flatMap((block, j) => (block === undefined ? [] : [[`P${i}_${j}`, {block}] as const])),
  )
  return {
    ...define,
    extraState: {...define.extraState, arity: all[0]?.length ?? 0},
    inputs: Object.fromEntries([...patterns, ...rest]),
  }
}

export const patternsOf = (define: SavedBlock, equation: number): readonly (SavedBlock | undefined)[] =>
  Array.from({length: arityOf(define)}, (_, j) => patternAt(define, equation, j))

/// The definition with another equation, which has no answer yet, behind the others.
export function withEquation(define: SavedBlock, patterns: readonly SavedBlock[]): SavedBlock {
  const equations = equationsOf(define)
  const i = equations.length
  return {
    ...define,
    extraState: {...define.extraState, equations: [...equations, {}]},
    inputs: {...define.inputs, ...Object.fromEntries(patterns.map((p, j) => [`P${i}_${j}`, {block: p}]))},
  }
}

/// The definition with only those equations that are kept.
export function withEquations(define: SavedBlock, keeps: (equation: number) => boolean): SavedBlock {
  const equations = equationsOf(define)
  const kept = equations.map((_, i) => i).filter(keeps)
  const inputs: {[name: string]: SavedInput} = {}
  for (const [name, input] of Object.entries(define.inputs ?? {})) {
    const [, letter, number, more = ""] = /^([A-Z])(\d+)(.*)$/.exec(name) ?? []
    const now = kept.indexOf(Number(number))
    if (letter !== undefined && now >= 0) inputs[`${letter}${now}${more}`] = input
  }
  return {
    ...define,
    extraState: {...define.extraState, equations: kept.map(i => equations[i] ?? {})},
    inputs,
  }
}

/// The definition with each answer changed; undefined leaves a place for it.
export function withAnswers(
  define: SavedBlock,
  change: (answer: SavedBlock | undefined) => SavedBlock | undefined,
): SavedBlock {
  const inputs: {[name: string]: SavedInput} = {...(define.inputs as Inputs)}
  for (const name of answersOf(define)) {
    const now = change(inputs[name]?.block)
    if (now === undefined) delete inputs[name]
    else inputs[name] = {block: now}
  }
  return {...define, inputs}
}

export const withSignature = (define: SavedBlock, signature: string): SavedBlock => ({
  ...define,
  extraState: {...define.extraState, signature},
})

/// Names that something in a definition, or the program's top level, has already.
export function namesUsed(blocks: readonly SavedBlock[]): Set<string> {
  const names = new Set<string>()
  for (const block of blocks)
    for (const {extraState = {}} of everyBlockIn(block)) {
      if (typeof extraState.name === "string") names.add(extraState.name)
      if (typeof extraState.text === "string")
        for (const word of extraState.text.match(/[\p{Ll}_][\p{L}\p{N}_']*/gu) ?? []) names.add(word)
    }
  return names
}

/// The name, or with a number behind it if it is taken; it is taken afterwards.
export function claimName(wanted: string, taken: Set<string>): string {
  const name = uniqueName(wanted, taken)
  taken.add(name)
  return name
}

/// A pattern that takes any value of a type and names its parts.
export function patternFor(type: string, own: OwnTypes, taken: Set<string>): SavedBlock {
  const parsed = parseType(type)
  const {head, args} = parsed === undefined ? {head: undefined, args: []} : spine(parsed)
  if (head?.kind !== "con") return named(claimName("value", taken))
  const [inner] = args
  if ((head.name === "Memory" || head.name === "Param") && inner !== undefined)
    return pat(head.name, named(claimName(lowered(headName(inner) ?? "remembered"), taken)))
  if (records.has(head.name) && !own.has(head.name)) {
    const words = wordsOf(head.name)
    const fields = library.constructors.get(head.name)?.fieldNames ?? []
    return pat(
      head.name,
      ...fields.map(field => {
        const rest = wordsOf(field ?? "value").filter(word => !words.includes(word))
        const [first = lowered(head.name), ...others] = rest
        const name = first + others.map(w => w.charAt(0).toUpperCase() + w.slice(1)).join("")
        return named(claimName(name.replace(/\d+$/, ""), taken))
      }),
    )
  }
  const only = own.get(head.name)
  if (only !== undefined && args.length === 0) return make("pattern_construct", {con: only, args: 0})
  return named(claimName(lowered(head.name), taken))
}

/// The program's own types, with their constructor where it is the only one and holds nothing.
export type OwnTypes = ReadonlyMap<string, string | undefined>

const headName = (type: Type): string | undefined => {
  const {head} = spine(type)
  return head.kind === "con" && /^\p{L}/u.test(head.name) ? head.name : undefined
}

const wordsOf = (name: string): readonly string[] => name.split(/(?=\p{Lu})/u).map(word => word.toLowerCase())

const lowered = (name: string): string => {
  const plain = name.slice(name.lastIndexOf(".") + 1)
  return plain.charAt(0).toLowerCase() + plain.slice(1)
}
