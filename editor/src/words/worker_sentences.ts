/// Sentences of the worker in the chosen language: an id and its arguments become a text.
///
/// A language is a table, `languages/<tag>/sentences.json`, checked by `scripts/sentences.py`. English has none: every message carries its English text.

import type {Sentence} from "../wire/problem.generated.ts"
import {measures} from "./index.ts"

type Argument = Sentence["arguments"][string]

/// The content of `languages/<tag>/sentences.json`.
export interface SentenceTable {
  /// Around a type in a sentence, and around the type of a function. The placeholder is `{type}`.
  readonly type: string
  readonly function: string
  /// Between the last two names of a choice, and between things that follow one another.
  readonly alternative: string
  readonly sequence: string
  /// Small numbers as words, from 0.
  readonly numbers: readonly string[]
  /// Sentences by their id.
  readonly sentences: Readonly<Record<string, string>>
}

/// What is needed to put a sentence into a language. A pseudo-language makes its templates from the ids.
export type SentenceForms = Omit<SentenceTable, "sentences"> & {
  readonly template: (id: string) => string | undefined
}

export const formsOf = ({sentences, ...forms}: SentenceTable): SentenceForms => ({
  ...forms,
  template: id => (Object.hasOwn(sentences, id) ? sentences[id] : undefined),
})

let chosen: SentenceForms | null = null

/// Chooses the language, once, before anything is shown; `null` is English.
export function chooseSentences(forms: SentenceForms | null): void {
  chosen = forms
}

/// The sentence in the chosen language; the English text when it has no id or the language does not know it.
export function worded(sentence: Sentence | null, english: string): string {
  return (chosen !== null && sentence !== null ? put(chosen, sentence) : undefined) ?? english
}

/// A text of ours that is its own id: the title of a room of the gallery or of one of its goals, what an example teaches. Other texts stay as they are.
export const wordedText = (text: string): string => worded({id: text, arguments: {}}, text)

/// `{name}` or `{format name}`.
export const placeholder = /\{(?:([A-Za-z]+) )?([A-Za-z]+)\}/g

/// A sentence in a language; `undefined` when the language does not know it or an argument is missing.
export function put(forms: SentenceForms, sentence: Sentence): string | undefined {
  const template = forms.template(sentence.id)
  let isComplete = template !== undefined
  const text = template?.replace(placeholder, (_, format: string | undefined, name: string) => {
    const argument = Object.hasOwn(sentence.arguments, name) ? sentence.arguments[name] : undefined
    if (argument === undefined) isComplete = false
    return argument === undefined ? "" : formatted(forms, format, argument)
  })
  return isComplete ? text : undefined
}

const isList = (argument: Argument): argument is readonly string[] => Array.isArray(argument)

/// A sentence of the service in English, where a language lacks it within another sentence. It has no formats.
function english({id, arguments: given}: Sentence): string {
  return id.replace(placeholder, (whole, _, name: string) => {
    const argument = given[name]
    if (argument === undefined) return whole
    if (isList(argument)) return argument.join(", ")
    return typeof argument === "object" ? english(argument) : String(argument)
  })
}

function formatted(forms: SentenceForms, format: string | undefined, argument: Argument): string {
  if (typeof argument === "number")
    return (format === "count" ? forms.numbers[argument] : undefined) ?? measures.short(argument, 6)
  if (typeof argument === "string") return format === "a" ? typeIn(forms, argument) : argument
  if (!isList(argument)) return put(forms, argument) ?? english(argument)
  if (format === "then") return argument.map(type => typeIn(forms, type)).join(forms.sequence)
  if (format !== "or") return argument.join(", ")
  const names = argument.map(name => `‘${name}’`)
  const last = names.pop() ?? ""
  return names.length === 0 ? last : `${names.join(", ")}${forms.alternative}${last}`
}

function typeIn(forms: SentenceForms, type: string): string {
  return (isFunctionType(type) ? forms.function : forms.type).replace("{type}", () => type)
}

/// Whether an arrow stands outside of all brackets.
function isFunctionType(type: string): boolean {
  let depth = 0
  for (let at = 0; at < type.length; at++) {
    const character = type.charAt(at)
    if ("([".includes(character)) depth++
    else if (")]".includes(character)) depth--
    else if (depth === 0 && type.startsWith("->", at)) return true
  }
  return false
}
