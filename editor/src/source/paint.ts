/// Which colour a word has: the syntax tree says what a name is there for, the blocks say of which family it is. Until they have read what is being
/// typed, a word that was not touched keeps its colour, and a new one has that of its letters. Pure.

import {knownNames} from "@rosy/codegen"
import type {Word, WordRole} from "@rosy/codegen/reader"
import type {Family, Program} from "../state/program.ts"
import type {Token} from "./lexer.ts"

// A type and its constructor share a name as a rule; the type's family is what a learner thinks of. Of values only
// the words of tasks have a family of their own: the others have that of their block.
const familyOfName: ReadonlyMap<string, Family> = new Map([
  ...knownNames()
    .filter(n => n.kind !== "value" || n.family === "task")
    .map(n => [n.name, n.family] as const),
  ["Memory", "memory"],
  ["Param", "memory"],
])

/// What is known of a word beyond its letters.
export interface Known {
  readonly role: WordRole | undefined
  /// The family of the block that says it.
  readonly family: Family | undefined
}

const nothing: Known = {role: undefined, family: undefined}

/// The class of a token; `null` for plain ink.
export function classOf(token: Token, word: string, {role, family}: Known = nothing): string | null {
  switch (token.kind) {
    case "comment":
    case "pragma":
      return "hs-comment"
    case "number":
      return "hs-number"
    case "string":
      return "hs-string"
    case "keyword":
      return "hs-keyword"
    case "hole":
      return "hs-hole"
    case "operator":
      // A browser would break a line after its dash.
      return word.length > 1 && word.includes("-") ? "hs-arrow" : null
    case "type":
    case "name":
      return classOfName(token.kind, word, role, family)
  }
}

function classOfName(
  kind: "type" | "name",
  word: string,
  role: WordRole | undefined,
  family: Family | undefined,
): string | null {
  const named = familyOfName.get(word)
  switch (role) {
    case "type":
      return `hs-${named ?? "own"}`
    case "variable":
      return "hs-variable"
    case "field":
      return "hs-own"
    case "constructor":
      return `hs-${family ?? named ?? "own"}`
    case "definition":
      return family === undefined ? "hs-defined" : `hs-defined hs-${family}`
    case "binder":
    case "use":
    case undefined: {
      const known = family ?? named ?? (kind === "type" ? "own" : undefined)
      return known === undefined ? null : `hs-${known}`
    }
  }
}

/// What a program tells of the words of its text.
export interface Palette {
  readonly text: string
  at(start: number, word: string): Known
}

export const noPalette: Palette = {text: "", at: () => nothing}

export function paletteOf(program: Program): Palette {
  const blockAt = smallestAt(program)
  const definedBy = new Map(program.definitions.map(d => [d.name, program.families[d.block]]))
  return {
    text: program.text,
    at(start, word) {
      const role = roleAt(program.words, start)
      const family = blockAt.get(start)
      if (role !== "definition" || family !== undefined) return {role, family}
      // Each clause of a definition begins with its name, the block with the first.
      const atMargin = start === 0 || program.text[start - 1] === "\n"
      return {role, family: atMargin ? definedBy.get(word) : undefined}
    },
  }
}

/// The family of the block whose text begins at each offset: that of the smallest one.
function smallestAt(program: Program): ReadonlyMap<number, Family> {
  const found = new Map<number, {length: number; family: Family}>()
  for (const span of program.spans) {
    const family = program.families[span.block]
    const length = span.end - span.start
    const known = found.get(span.start)
    if (family !== undefined && (known === undefined || length < known.length))
      found.set(span.start, {length, family})
  }
  return new Map([...found].map(([at, {family}]) => [at, family]))
}

function roleAt(pieces: Program["words"], start: number): WordRole | undefined {
  const piece = lastUpTo(pieces, start, p => p.start)
  const word: Word | undefined =
    piece === undefined ? undefined : lastUpTo(piece.words, start - piece.start, w => w.start)
  return word !== undefined && word.start === start - (piece?.start ?? 0) ? word.role : undefined
}

/// The last of a sorted list that begins at `at` or before.
function lastUpTo<T>(all: readonly T[], at: number, startOf: (one: T) => number): T | undefined {
  let low = 0
  let high = all.length
  while (low < high) {
    const middle = (low + high) >> 1
    const one = all[middle]
    if (one !== undefined && startOf(one) <= at) low = middle + 1
    else high = middle
  }
  return all[low - 1]
}

/// Where what stands in `now` stood in `old`; `null` for what was touched.
export function wayBack(old: string, now: string): (start: number, end: number) => number | null {
  if (old === now) return start => start
  const most = Math.min(old.length, now.length)
  let head = 0
  while (head < most && old.charCodeAt(head) === now.charCodeAt(head)) head += 1
  let tail = 0
  while (
    tail < most - head &&
    old.charCodeAt(old.length - 1 - tail) === now.charCodeAt(now.length - 1 - tail)
  )
    tail += 1
  // A word that ends where the change begins is being written on.
  return (start, end) =>
    end < head || (end === head && end === old.length)
      ? start
      : start > now.length - tail
        ? start + old.length - now.length
        : null
}
