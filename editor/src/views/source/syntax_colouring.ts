/// Syntax colouring of the Haskell pane: each name in the colour of its block. Tokens are computed for the whole text, because a comment may start far above; only the
/// visible part is decorated.
///
/// The syntax tree gives the role of a name, the blocks give its family. Until an edit has been parsed, unchanged words keep their colour, and new words are coloured
/// by their spelling.

import {type Extension, RangeSetBuilder, StateEffect} from "@codemirror/state"
import {Decoration, type DecorationSet, type EditorView, ViewPlugin, type ViewUpdate} from "@codemirror/view"
import {firstWith, knownNames, type Token, tokens, tokensAfter} from "@rosy/codegen"
import type {Word, WordRole} from "@rosy/codegen/reader"
import type {Family, Program} from "../../program/program.ts"
import {type ChangeDesc, ChangeSet, unchangedPosition} from "../../program/text_changes.ts"

/// Tells the pane that its text now is this program's.
export const programShown = StateEffect.define<Program>()

class ColouringPlugin {
  decorations: DecorationSet
  private text: string
  private words: readonly Token[]
  private palette: Palette = noPalette
  /// From the text of `palette` to `text`.
  private changes: ChangeDesc

  constructor(view: EditorView) {
    this.text = view.state.doc.toString()
    this.words = tokens(this.text)
    this.changes = ChangeSet.of({from: 0, insert: this.text}, 0)
    this.decorations = this.inSight(view)
  }

  update(update: ViewUpdate): void {
    if (update.docChanged) {
      this.changes = this.changes.composeDesc(update.changes)
      const change = {from: this.text.length, to: 0}
      update.changes.iterChangedRanges((_fromOld, _toOld, from, to) => {
        change.from = Math.min(change.from, from)
        change.to = Math.max(change.to, to)
      })
      const before = this.text.length
      this.text = update.state.doc.toString()
      this.words = tokensAfter(this.words, this.text, {...change, shift: this.text.length - before})
    }
    let told = false
    for (const transaction of update.transactions)
      for (const effect of transaction.effects)
        if (effect.is(programShown) && effect.value.text === this.text) {
          this.palette = paletteOf(effect.value)
          this.changes = ChangeSet.empty(this.text.length)
          told = true
        }
    if (told || update.docChanged || update.viewportChanged) this.decorations = this.inSight(update.view)
  }

  private inSight(view: EditorView): DecorationSet {
    const builder = new RangeSetBuilder<Decoration>()
    const {from, to} = view.viewport
    const before = unchangedPosition(this.changes)
    for (let i = firstWith(this.words, token => token.end >= from); i < this.words.length; i += 1) {
      const token = this.words[i] as Token
      if (token.start > to) break
      const word = this.text.slice(token.start, token.end)
      const known = before(token.start, token.end)
      const name = classOf(token, word, known === null ? undefined : this.palette.at(known, word))
      if (name !== null) builder.add(token.start, token.end, markOf(name))
    }
    return builder.finish()
  }
}

const marks = new Map<string, Decoration>()

function markOf(name: string): Decoration {
  const known = marks.get(name)
  if (known !== undefined) return known
  const made = Decoration.mark({class: name})
  marks.set(name, made)
  return made
}

export const syntaxColouring: Extension = ViewPlugin.fromClass(ColouringPlugin, {
  decorations: plugin => plugin.decorations,
})

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
export interface WordInfo {
  readonly role: WordRole | undefined
  /// The family of the block that says it.
  readonly family: Family | undefined
}

const nothing: WordInfo = {role: undefined, family: undefined}

/// The class of a token; `null` for plain ink.
export function classOf(token: Token, word: string, {role, family}: WordInfo = nothing): string | null {
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

/// The families of the words in a program's text.
export interface Palette {
  at(start: number, word: string): WordInfo
}

const noPalette: Palette = {at: () => nothing}

export function paletteOf(program: Program): Palette {
  const blockAt = smallestAt(program)
  const definedBy = new Map(program.definitions.map(d => [d.name, program.families.get(d.block)]))
  return {
    at(start, word) {
      const role = roleAt(program.words, start)
      const family = blockAt(start)
      if (role !== "definition" || family !== undefined) return {role, family}
      // Each clause of a definition begins with its name, the block with the first.
      const atMargin = start === 0 || program.text[start - 1] === "\n"
      return {role, family: atMargin ? definedBy.get(word) : undefined}
    },
  }
}

/// Characters of text for which families are looked up together: only what is in sight is asked for.
const stretch = 1024

/// The family of the block whose text begins at an offset: that of the smallest one.
function smallestAt(program: Program): (start: number) => Family | undefined {
  const stretches = new Map<number, ReadonlyMap<number, Family>>()
  return start => {
    const index = Math.floor(start / stretch)
    let families = stretches.get(index)
    if (families === undefined) {
      families = familiesIn(program, index * stretch, (index + 1) * stretch)
      stretches.set(index, families)
    }
    return families.get(start)
  }
}

function familiesIn(program: Program, from: number, to: number): ReadonlyMap<number, Family> {
  const found = new Map<number, Family>()
  const lengths = new Map<number, number>()
  for (const {block, start, end} of program.spans) {
    if (start < from || start >= to) continue
    const family = program.families.get(block)
    if (family === undefined || end - start >= (lengths.get(start) ?? Number.POSITIVE_INFINITY)) continue
    lengths.set(start, end - start)
    found.set(start, family)
  }
  return found
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
