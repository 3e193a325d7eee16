/// The colours of the Haskell pane: each name in the colour its block has. A word that was printed from a block
/// takes that block's family; other words take the family that codegen gives the name.

import {type Extension, RangeSetBuilder, StateEffect} from "@codemirror/state"
import {Decoration, type DecorationSet, type EditorView, ViewPlugin, type ViewUpdate} from "@codemirror/view"
import {knownNames} from "@rosy/codegen"
import type {Family, Program} from "../state/program.ts"
import {type Token, tokens} from "./lexer.ts"

// A type and its constructor share a name as a rule; the type's family is what a learner thinks of. Of values only
// the words of tasks are coloured: the rest would make the page motley.
const familyOfName: ReadonlyMap<string, Family> = new Map([
  ...knownNames()
    .filter(n => n.kind !== "value" || n.family === "task")
    .map(n => [n.name, n.family] as const),
  ["Memory", "memory"],
  ["Param", "memory"],
])

/// The class of a token; `null` for plain ink.
export function classOf(
  token: Token,
  word: string,
  blockFamily: Family | undefined,
  defined: boolean,
): string | null {
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
      return null
    case "type":
      return `hs-${blockFamily ?? familyOfName.get(word) ?? "own"}`
    case "name": {
      const family = familyOfName.get(word)
      return family !== undefined ? `hs-${family}` : defined ? "hs-defined" : null
    }
  }
}

function endOfLine(text: string, from: number): number {
  const at = text.indexOf("\n", from)
  return at < 0 ? text.length : at
}

/// The family of the block that printed the word at each offset: that of the smallest span that starts there.
function familiesAt(program: Program): ReadonlyMap<number, Family> {
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

/// Tells the pane that its text now is this program's.
export const programShown = StateEffect.define<Program>()

/// Words are told apart in the whole text, for comments may begin far above; only what is in sight is coloured.
class Colours {
  decorations: DecorationSet
  private text: string
  private words: readonly Token[]
  private families: ReadonlyMap<number, Family> = new Map()
  private defined: ReadonlySet<string> = new Set()

  constructor(view: EditorView) {
    this.text = view.state.doc.toString()
    this.words = tokens(this.text)
    this.decorations = this.inSight(view)
  }

  update(update: ViewUpdate): void {
    if (update.docChanged) {
      this.text = update.state.doc.toString()
      this.words = tokens(this.text)
      // Colours at once while typing; the blocks of the words follow with the next program.
      this.families = new Map()
    }
    let told = false
    for (const transaction of update.transactions)
      for (const effect of transaction.effects)
        if (effect.is(programShown) && effect.value.text === this.text) {
          this.families = familiesAt(effect.value)
          this.defined = new Set(effect.value.definitions.map(d => d.name))
          told = true
        }
    if (told || update.docChanged || update.viewportChanged) this.decorations = this.inSight(update.view)
  }

  private inSight(view: EditorView): DecorationSet {
    const builder = new RangeSetBuilder<Decoration>()
    const {from, to} = view.viewport
    let typesUntil = -1
    for (const token of this.words) {
      if (token.end < from) continue
      if (token.start > to) break
      const word = this.text.slice(token.start, token.end)
      // In a signature a name is a type, and has the family of its name whatever block it came from.
      if (word === "::") typesUntil = endOfLine(this.text, token.end)
      const atLineStart = token.start === 0 || this.text[token.start - 1] === "\n"
      const family = token.start < typesUntil ? undefined : this.families.get(token.start)
      const name = classOf(token, word, family, atLineStart && this.defined.has(word))
      if (name !== null) builder.add(token.start, token.end, Decoration.mark({class: name}))
    }
    return builder.finish()
  }
}

export const colours: Extension = ViewPlugin.fromClass(Colours, {decorations: plugin => plugin.decorations})
