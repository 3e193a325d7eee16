/// Patterns of events and commands, such as `Bumper _ Pressed` and `Velocity >0 _`, as the values of a form. Pure.
/// `channel_patterns.py` of the service matches them.

import {robot} from "@rosy/codegen/robot"

/// What a value has to be: anything, one word of a choice or another than it, or a number that is compared.
export type ValuePattern =
  | {readonly kind: "any"}
  | {readonly kind: "is" | "is-not"; readonly word: string}
  | {readonly kind: "equal" | "unequal" | "more" | "less"; readonly number: number}

export interface ChannelPattern {
  readonly channel: string
  readonly values: readonly ValuePattern[]
}

/// What can be said about a value: one of these words, a number, or nothing.
export type ValueForm = readonly string[] | "number" | "any"

export const anything: ValuePattern = {kind: "any"}

const channels: {
  readonly [of in "event" | "command"]: {readonly [name: string]: readonly (readonly string[] | string)[]}
} = robot.channelValues

export const channelNames = (of: "event" | "command"): readonly string[] => Object.keys(channels[of])

export function valueForms(of: "event" | "command", channel: string): readonly ValueForm[] {
  return (channels[of][channel] ?? []).map(kind =>
    typeof kind !== "string" ? kind : kind === "Double" ? "number" : "any",
  )
}

/// `null` for what this robot does not have.
export function readPattern(text: string, of: "event" | "command"): ChannelPattern | null {
  const [channel = "", ...words] = text.trim().split(/\s+/)
  if (!Object.hasOwn(channels[of], channel)) return null
  const forms = valueForms(of, channel)
  if (words.length > forms.length) return null
  const values = forms.map((form, i) => readValue(words[i] ?? "_", form))
  return values.some(value => value === null) ? null : {channel, values: values.flatMap(value => value ?? [])}
}

function readValue(word: string, form: ValueForm): ValuePattern | null {
  if (word === "_") return anything
  if (typeof form !== "string") {
    const [kind, name] = word.startsWith("!") ? (["is-not", word.slice(1)] as const) : (["is", word] as const)
    return form.includes(name) ? {kind, word: name} : null
  }
  if (form === "any") return null
  const [, sign = "", digits = ""] = /^([<>!]?)(.+)$/.exec(word) ?? []
  const number = Number(digits)
  if (!Number.isFinite(number)) return null
  const kinds = {"<": "less", ">": "more", "!": "unequal"} as const
  return {kind: Object.hasOwn(kinds, sign) ? kinds[sign as keyof typeof kinds] : "equal", number}
}

export function writePattern({channel, values}: ChannelPattern): string {
  return [channel, ...values.map(writeValue)].join(" ")
}

function writeValue(value: ValuePattern): string {
  switch (value.kind) {
    case "any":
      return "_"
    case "is":
      return value.word
    case "is-not":
      return `!${value.word}`
    case "unequal":
      return `!${value.number}`
    case "equal":
      return `${value.number}`
    case "more":
      return `>${value.number}`
    case "less":
      return `<${value.number}`
  }
}

/// A channel with any values.
export function patternOf(of: "event" | "command", channel: string): ChannelPattern {
  return {channel, values: valueForms(of, channel).map(() => anything)}
}
