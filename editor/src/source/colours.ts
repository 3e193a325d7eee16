/// The colours of the Haskell pane: each name in the colour its block has. A word that was printed from a block
/// takes that block's family; other words take the family that codegen gives the name.

import {type Extension, RangeSetBuilder, StateEffect, StateField} from "@codemirror/state"
import {Decoration, type DecorationSet, EditorView} from "@codemirror/view"
import {knownNames} from "@rosy/codegen"
import {emptyProgram, type Family, type Program} from "../state/program.ts"
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

function decorate(program: Program): DecorationSet {
  const {text} = program
  // The smallest span that starts where a word does belongs to the block that printed the word.
  const blockAt = new Map<number, {length: number; family: Family}>()
  for (const span of program.spans) {
    const family = program.families[span.block]
    const length = span.end - span.start
    const known = blockAt.get(span.start)
    if (family !== undefined && (known === undefined || length < known.length))
      blockAt.set(span.start, {length, family})
  }
  const starts = new Set(program.definitions.map(d => d.name))
  const builder = new RangeSetBuilder<Decoration>()
  let typesUntil = -1
  for (const token of tokens(text)) {
    const word = text.slice(token.start, token.end)
    // In a signature a name is a type, and has the family of its name whatever block it came from.
    if (word === "::") typesUntil = endOfLine(text, token.end)
    const atLineStart = token.start === 0 || text[token.start - 1] === "\n"
    const family = token.start < typesUntil ? undefined : blockAt.get(token.start)?.family
    const name = classOf(token, word, family, atLineStart && starts.has(word))
    if (name !== null) builder.add(token.start, token.end, Decoration.mark({class: name}))
  }
  return builder.finish()
}

/// Tells the pane that its text now is this program's.
export const programShown = StateEffect.define<Program>()

interface Coloured {
  readonly program: Program
  readonly set: DecorationSet
}

const coloured = StateField.define<Coloured>({
  create: () => ({program: emptyProgram, set: Decoration.none}),
  update(before, transaction) {
    for (const effect of transaction.effects)
      if (effect.is(programShown) && effect.value.text === transaction.newDoc.toString())
        return {program: effect.value, set: decorate(effect.value)}
    if (!transaction.docChanged) return before
    // Colours at once while typing; the blocks of the words follow with the next program.
    const program = {...before.program, text: transaction.newDoc.toString(), spans: []}
    return {program, set: decorate(program)}
  },
  provide: field => EditorView.decorations.from(field, value => value.set),
})

export const colours: Extension = coloured
