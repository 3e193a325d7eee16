/// What the Haskell pane knows of names: what it completes and what it says about the word under the pointer.

import {
  autocompletion,
  type Completion,
  type CompletionContext,
  type CompletionResult,
} from "@codemirror/autocomplete"
import {type Extension, StateEffect, StateField} from "@codemirror/state"
import {hoverTooltip} from "@codemirror/view"
import {type KnownName, knownNames} from "@rosy/codegen"
import type {Declared} from "../state/messages.ts"
import {tokens} from "./lexer.ts"

/// The program's own top-level names with the types that the compiler found.
export const setDeclared = StateEffect.define<readonly Declared[]>()

const declaredField = StateField.define<readonly Declared[]>({
  create: () => [],
  update(value, transaction) {
    for (const effect of transaction.effects) if (effect.is(setDeclared)) return effect.value
    return value
  },
})

const known: readonly KnownName[] = knownNames()
const knownByName = new Map<string, KnownName[]>()
for (const n of known) knownByName.set(n.name, [...(knownByName.get(n.name) ?? []), n])

/// CodeMirror's words for what a completion is.
const kinds: Record<KnownName["kind"], string> = {value: "function", constructor: "class", type: "type"}

const keywordOptions: readonly Completion[] = "case data do else if in let newtype of then type where"
  .split(" ")
  .map(label => ({label, type: "keyword", boost: -2}))

const knownOptions: readonly Completion[] = known.map(n => ({
  label: n.name,
  detail: n.kind === "type" ? "type" : n.type,
  type: kinds[n.kind],
  boost: -1,
}))

function complete(context: CompletionContext): CompletionResult | null {
  const word = context.matchBefore(/[\p{L}_][\p{L}\p{N}_']*/u)
  if (word === null && !context.explicit) return null
  const text = context.state.doc.toString()
  const words = tokens(text)
  const here = words.find(t => t.start < context.pos && context.pos <= t.end)
  if (here?.kind === "comment" || here?.kind === "string" || here?.kind === "number") return null
  // After `::` on its line a type is wanted, elsewhere a value.
  const wantsType = /::[^=|]*$/.test(
    context.state.doc
      .lineAt(context.pos)
      .text.slice(0, context.pos - context.state.doc.lineAt(context.pos).from),
  )
  const own = context.state
    .field(declaredField)
    .map((d): Completion => ({label: d.name, detail: d.type, type: "function", boost: 2}))
  const named = new Set([...own.map(o => o.label), ...known.map(n => n.name)])
  const local = [
    ...new Set(
      words
        .filter(t => (t.kind === "name" || t.kind === "type") && t !== here)
        .map(t => text.slice(t.start, t.end)),
    ),
  ]
    .filter(name => !named.has(name) && name !== "_")
    .map((label): Completion => ({label, type: "variable", boost: 1}))
  const fitting = knownOptions.filter(o => (o.type === "type") === wantsType)
  return {
    from: word?.from ?? context.pos,
    options: wantsType
      ? [...local.filter(l => /^\p{Lu}/u.test(l.label)), ...fitting]
      : [...own, ...local, ...fitting, ...keywordOptions],
    validFor: /^[\p{L}\p{N}_']*$/u,
  }
}

const explain = hoverTooltip((view, pos) => {
  const text = view.state.doc.toString()
  const token = tokens(text).find(t => t.start <= pos && pos < t.end)
  if (token === undefined || (token.kind !== "name" && token.kind !== "type")) return null
  const word = text.slice(token.start, token.end)
  const own = view.state.field(declaredField).find(d => d.name === word)
  const lines =
    own !== undefined
      ? [`${own.name} :: ${own.type}`]
      : (knownByName.get(word) ?? []).map(n =>
          n.kind === "type"
            ? `data ${n.name}${n.type === "" ? "" : ` = ${n.type}`}`
            : `${n.name} :: ${n.type}`,
        )
  if (lines.length === 0) return null
  return {
    pos: token.start,
    end: token.end,
    above: true,
    create() {
      const dom = document.createElement("div")
      dom.className = "hs-explained"
      for (const line of new Set(lines)) {
        const row = document.createElement("div")
        row.textContent = line
        dom.append(row)
      }
      return {dom}
    },
  }
})

export const names: Extension = [declaredField, autocompletion({override: [complete], icons: false}), explain]
