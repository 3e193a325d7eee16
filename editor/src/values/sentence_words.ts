/// Wording of an explanation in the learner's language: a sentence as pieces of text, code, and names of functions.

import type {why as english} from "../../../languages/en/page/why.ts"
import type {Sentence} from "../wire/explanation.generated.ts"
import type {Measures} from "../words/number_formats.ts"

export type WhyWords = typeof english

/// `cause` is the name of the function that leads one step back; `firing` is the number of its firing. A command leads to why it was sent.
export type Piece =
  | {readonly kind: "text" | "code" | "function"; readonly text: string}
  | {readonly kind: "cause"; readonly text: string; readonly firing: number}
  | {readonly kind: "command"; readonly text: string; readonly type: string; readonly time: number}

const text = (words: string): Piece => ({kind: "text", text: words})
const code = (haskell: string): Piece => ({kind: "code", text: haskell})
const named = (name: string): Piece => ({kind: "function", text: name})

/// The pieces of a text with slots; a slot without a value is left out.
export function fill(template: string, slots: {readonly [name: string]: readonly Piece[]}): readonly Piece[] {
  return template
    .split(/%\{(\w+)\}/)
    .flatMap((part, i) => (i % 2 === 1 ? (slots[part] ?? []) : part === "" ? [] : [text(part)]))
}

export function pieces(said: Sentence, words: WhyWords, measures: Measures): readonly Piece[] {
  const at = (time: number | null) => [text(measures.seconds(time ?? 0, 2))]
  const joined = (all: readonly (readonly Piece[])[], last: string): readonly Piece[] =>
    all.flatMap((one, i) => (i === 0 ? one : [text(i === all.length - 1 ? last : ", "), ...one]))
  const gap = (said.since ?? 0) - (said.time ?? 0)
  const one = (type: string) =>
    fill(beginsWithVowel.test(type) ? words.oneBeforeVowel : words.one, {type: [code(type)]})
  const outputs = said.gave.map(({to, value, type}): readonly Piece[] => {
    if (to === "done") return [code("Done")]
    if (to === "call") return [text(words.aCall)]
    if (to === "feedback") return [text(words.feedback)]
    if (value === "" || value === "_") return one(type)
    if (to === "command" && type !== "" && said.time !== null)
      return [{kind: "command", text: value, type, time: said.time}]
    return [code(to === "memory" || to === "param" ? storedValue(type, value) : value)]
  })
  const inputs = said.values.map(value => [code(value)])
  return fill(words.sentences[said.id], {
    time: at(said.time),
    since: at(said.since),
    until: at(said.until),
    function: [named(said.function)],
    other: [said.cause === null ? named(said.other) : {kind: "cause", text: said.other, firing: said.cause}],
    functions: joined(
      said.functions.map(name => [named(name)]),
      words.and,
    ),
    value: [code(said.value)],
    number: [text(`${said.number ?? ""}`)],
    type: [code(said.type)],
    command: [said.type === "" ? text(words.aCommand) : code(said.type)],
    one: one(said.type),
    types: joined(said.types.map(one), words.or),
    first: [code(said.values[0] ?? "")],
    last: [code(said.values.at(-1) ?? "")],
    Done: [code("Done")],
    simulate: [code("simulate")],
    asked: [text(measures.short(said.asked ?? 0, 2))],
    limit: [text(measures.short(said.limit ?? 0, 2))],
    inputs: inputs.length === 0 ? [] : fill(words.inputs, {list: joined(inputs, words.and)}),
    outputs: outputs.length === 0 ? [text(words.nothing)] : joined(outputs, words.and),
    happened: happened(said.value, words),
    earlier: said.time === null ? [text(words.lastNone)] : fill(words.lastAt, {time: at(said.time)}),
    gap: gap < 1e-9 ? [text(words.sameInstant)] : fill(words.later, {gap: [text(measures.seconds(gap, 2))]}),
  })
}

/// A message, as Haskell shows it, as a clause.
function happened(value: string, words: WhyWords): readonly Piece[] {
  const [event = "", place = "", state = "", ...more] = value.split(" ")
  const clauses: Readonly<Record<string, string>> = words.happened
  const places: Readonly<Record<string, string>> = words.places
  const clause = clauses[`${event} ${state}`]
  const where = places[place]
  if (clause !== undefined && where !== undefined && more.length === 0)
    return fill(clause, {place: [text(where)]})
  return event === "Odometry" ? [text(words.motion)] : fill(words.came, {value: [code(value)]})
}

/// The name of a letter may begin with a vowel as well: `an M1`.
const beginsWithVowel = /^[AEIO]|^[FLMNRSX]\d/

/// A memory or a parameter as Haskell writes it, from its type and the value in it.
export function storedValue(type: string, value: string): string {
  const wrapper = type.split(" ")[0] ?? type
  const isArgument = /^[("[]/.test(value) || !/\s|^-/.test(value)
  return `${wrapper} ${isArgument ? value : `(${value})`}`
}

const longFraction = String.raw`\d+\.\d+e-\d+|\d+\.\d{5,}(?![\de])`
const longFractions = new RegExp(String.raw`\(-(${longFraction})\)|${longFraction}`, "g")

/// A value with fractions cut to four digits: `(-0.8200000000000001)` is `(-0.82)`, `(-6.1e-5)` is `(-0.0001)`.
export function shortFractions(haskell: string): string {
  return haskell.replace(longFractions, (number: string, negative: string | undefined) => {
    const value = Number(Number(negative ?? number).toFixed(4))
    const digits = Number.isInteger(value) ? `${value}.0` : `${value}`
    return negative !== undefined && value !== 0 ? `(-${digits})` : digits
  })
}

/// A sentence as one text, with functions in `**` and code in backquotes.
export function asText(all: readonly Piece[]): string {
  return all
    .map(piece =>
      piece.kind === "text"
        ? piece.text
        : piece.kind === "code" || piece.kind === "command"
          ? `\`${shortFractions(piece.text)}\``
          : `**${piece.text}**`,
    )
    .join("")
}
