/// A sentence as id and arguments (`protocol/README.md` §1.1), and its decoder. `words/worker_sentences.ts` puts it into a language.

import {type Decoder, list, Mismatch, number, object, optional, string} from "./decode.ts"

/// A number with a fraction is a measure. A sentence in a sentence is worded in the same language.
export type Argument = string | number | readonly string[] | Sentence

export interface Sentence {
  /// The sentence in English, with its placeholders.
  readonly id: string
  readonly arguments: Readonly<Record<string, Argument>>
}

const argument: Decoder<Argument> = (value, path) =>
  typeof value === "string"
    ? string(value, path)
    : typeof value === "number"
      ? number(value, path)
      : Array.isArray(value)
        ? list(string)(value, path)
        : sentence(value, path)

const argumentsByName: Decoder<Sentence["arguments"]> = (value, path) => {
  if (typeof value !== "object" || value === null || Array.isArray(value))
    throw new Mismatch(path, "an object of arguments")
  return Object.fromEntries(
    Object.entries(value).map(([name, inner]) => [name, argument(inner, `${path}.${name}`)]),
  )
}

export const sentence: Decoder<Sentence> = object(get => ({
  id: get("id", string),
  arguments: get("arguments", optional(argumentsByName, {})),
}))

/// The sentences of a problem; `null` for a text that is not translated.
export interface ProblemSentences {
  readonly message: Sentence | null
  readonly hint: Sentence | null
}

export const problemSentences: Decoder<ProblemSentences> = object(get => ({
  message: get("message", optional(sentence, null)),
  hint: get("hint", optional(sentence, null)),
}))

export const untranslated: ProblemSentences = {message: null, hint: null}
