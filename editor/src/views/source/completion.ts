/// Completion: the compiler's suggestions for the cursor position, best first; until it has answered, and where the program cannot be parsed, names known to the page.
/// Ready blocks of the toolbox are offered as snippets.

import {
  acceptCompletion,
  autocompletion,
  type Completion,
  type CompletionContext,
  type CompletionResult,
  closeCompletion,
  completionKeymap,
  completionStatus,
  selectedCompletion,
  selectedCompletionIndex,
  snippetCompletion,
  startCompletion,
} from "@codemirror/autocomplete"
import {type Extension, Prec, StateEffect, StateField} from "@codemirror/state"
import {type Command, type EditorView, keymap} from "@codemirror/view"
import {type KnownName, knownNames, preludeNames, tokens} from "@rosy/codegen"
import type {Declaration, Suggestion, TypesAtPlaces} from "../../wire/worker.generated.ts"

export interface CompilerInfo {
  readonly declared: readonly Declaration[]
  /// The types of places in `text`.
  readonly types: TypesAtPlaces & {readonly text: string}
}

export const setCompilerInfo = StateEffect.define<CompilerInfo>()

export const compilerInfo = StateField.define<CompilerInfo>({
  create: () => ({declared: [], types: {text: "", names: [], at: []}}),
  update(value, transaction) {
    for (const effect of transaction.effects) if (effect.is(setCompilerInfo)) return effect.value
    return value
  },
})

const allKnownNames: readonly KnownName[] = knownNames()
const byName = new Map<string, KnownName[]>()
for (const n of allKnownNames) byName.set(n.name, [...(byName.get(n.name) ?? []), n])

/// What every program knows under a name: a type and a constructor may share one.
export function namesNamed(name: string): readonly KnownName[] {
  return byName.get(name) ?? []
}

/// The type of a value by its name; the program's own names come first.
export function typeOfName(declared: readonly Declaration[], name: string): string | undefined {
  return declared.find(d => d.name === name)?.type ?? namesNamed(name).find(n => n.kind !== "type")?.type
}

export const compilerInfoField: Extension = compilerInfo

export interface Completer {
  /// What can stand at an offset of a text; `null` when it is unknown.
  /// `later` is called when the answer is known after all.
  fitting(text: string, offset: number, later: () => void): Promise<{names: readonly Suggestion[]} | null>
  /// Pieces of Haskell to put in, with a word for each.
  snippets(): readonly {readonly label: string; readonly code: string}[]
  readonly fromToolbox: string
}

/// CodeMirror's words for what a completion is.
const kinds: Record<KnownName["kind"], string> = {value: "function", constructor: "class", type: "type"}

const keywordOptions: readonly Completion[] = "case data do else if in let newtype of then type where"
  .split(" ")
  .map(label => ({label, type: "keyword", boost: -20}))

/// The Prelude's names that no program of a learner wants: they read and write files and the terminal, fail, or look inside of numbers.
/// Offered last, after everything else.
const obscure = new Set(
  (
    "appendFile asTypeOf decodeFloat encodeFloat errorWithoutStackTrace exponent floatDigits floatRadix floatRange getChar " +
    "getContents getLine interact ioError isDenormalized isIEEE isInfinite isNaN isNegativeZero lex mapAndUnzipM mfilter print " +
    "putChar putStr putStrLn readFile readIO readList readLn readParen reads readsPrec scaleFloat seq showChar showList " +
    "showParen showString shows showsPrec significand undefined userError writeFile error"
  ).split(" "),
)
const prelude = new Set(preludeNames().map(n => n.name))

/// Rosy's own names before the Prelude's.
const knownOptions: readonly Completion[] = allKnownNames.map(n => ({
  label: n.name,
  detail: n.kind === "type" ? "type" : n.type,
  type: kinds[n.kind],
  boost: obscure.has(n.name) ? -60 : prelude.has(n.name) ? -14 : -10,
}))

/// What can stand there as it is comes before what needs an input first, and what hardly anybody wants last; within each, in the compiler's order. (CodeMirror sorts by how well the letters fit, then by
/// boosts from -99 to 99, then by `sortText`.)
export function ranked(names: readonly Suggestion[]): readonly Completion[] {
  return names.map(({name, type, takes}, i) => ({
    label: name,
    detail: type,
    type: /^\p{Lu}/u.test(name) ? "class" : "function",
    boost: obscure.has(name) ? -60 : takes === 0 ? 60 : 45 - 2 * Math.min(takes, 10),
    sortText: String(i).padStart(4, "0"),
  }))
}

async function complete(context: CompletionContext, completer: Completer): Promise<CompletionResult | null> {
  const word = context.matchBefore(/[\p{L}_][\p{L}\p{N}_']*/u)
  if (word === null && !context.explicit) return null
  const text = context.state.doc.toString()
  const words = tokens(text)
  const here = words.find(t => t.start < context.pos && context.pos <= t.end)
  if (here?.kind === "comment" || here?.kind === "string" || here?.kind === "number") return null
  const answer = await completer.fitting(text, context.pos, () => {
    if (context.view !== undefined) askAgain(context.view)
  })
  if (context.aborted) return null
  // After `::` on its line a type is wanted, elsewhere a value.
  const line = context.state.doc.lineAt(context.pos)
  const wantsType = /::[^=|]*$/.test(line.text.slice(0, context.pos - line.from))
  const fits = ranked(answer?.names ?? [])
  const own = context.state
    .field(compilerInfo)
    .declared.filter(d => /^\p{Lu}/u.test(d.name) === wantsType || !wantsType)
    .map((d): Completion => ({label: d.name, detail: d.type, type: "function", boost: 0}))
  const offered = new Set(fits.map(o => o.label))
  const named = new Set([...offered, ...own.map(o => o.label), ...allKnownNames.map(n => n.name)])
  const local = [
    ...new Set(
      words
        .filter(t => (t.kind === "name" || t.kind === "type") && t !== here)
        .map(t => text.slice(t.start, t.end)),
    ),
  ]
    .filter(name => !named.has(name) && name !== "_" && (!wantsType || /^\p{Lu}/u.test(name)))
    .map((label): Completion => ({label, type: "variable", boost: -1}))
  const others = [...own, ...knownOptions.filter(o => (o.type === "type") === wantsType)].filter(
    o => !offered.has(o.label),
  )
  const pieces = wantsType
    ? []
    : completer.snippets().map(s => snippet(s.label, s.code, completer.fromToolbox))
  return {
    from: word?.from ?? context.pos,
    options: [
      ...fits,
      ...local,
      ...others,
      ...(wantsType ? [] : keywordOptions),
      ...(context.explicit ? pieces : []),
    ],
    validFor: /^[\p{L}\p{N}_']*$/u,
  }
}

/// The compiler's answer came after general names were offered: the list is made again with it, unless an entry further down is selected.
function askAgain(view: EditorView) {
  if (completionStatus(view.state) === "active" && (selectedCompletionIndex(view.state) ?? 0) <= 0)
    startCompletion(view)
}

/// An open place becomes a field to go through with Tab.
function snippet(label: string, code: string, section: string): Completion {
  let n = 0
  const template = code
    .replace(/[{}$\\]/g, "\\$&")
    .replace(/(?<![\p{L}\p{N}_'])_(?![\p{L}\p{N}_'])/gu, () => `\${${++n}:_}`)
  return snippetCompletion(template, {
    label,
    detail: code.split("\n")[0] ?? "",
    type: "text",
    section: {name: section, rank: 1},
    boost: -30,
  })
}

/// Enter takes what is chosen, but not for a word that stands there already: who has typed it to its end wants the next line. Nor does it put `where` for a
/// new `here`: what only has these letters somewhere is taken only by a choice in the list.
const takeUnlessWritten: Command = view => {
  const chosen = selectedCompletion(view.state)
  const {head} = view.state.selection.main
  const line = view.state.doc.lineAt(head)
  const word = /[\p{L}_][\p{L}\p{N}_']*$/u.exec(line.text.slice(0, head - line.from))?.[0] ?? ""
  // A complete name of the standard vocabulary stays even if a longer one is offered first; an entry chosen further down the list is taken.
  const unasked = selectedCompletionIndex(view.state) === 0
  const whole = allKnownNames.some(n => n.name === word)
  const goesOn = chosen?.label.toLowerCase().startsWith(word.toLowerCase()) === true
  const written =
    chosen !== null && isPlain(chosen) && (chosen.label === word || (unasked && (whole || !goesOn)))
  if (!written) return acceptCompletion(view)
  closeCompletion(view)
  return false
}

/// A snippet puts in more than its label.
const isPlain = ({apply}: Completion) => apply === undefined

export const completion = (completer: Completer): Extension => [
  autocompletion({
    override: [context => complete(context, completer)],
    icons: false,
    defaultKeymap: false,
  }),
  Prec.highest(
    keymap.of([
      {key: "Enter", run: takeUnlessWritten},
      {key: "Tab", run: acceptCompletion},
      ...completionKeymap.filter(({key}) => key !== "Enter"),
    ]),
  ),
]
