/// Two languages that nobody speaks, made from English: one with accents and a third longer, one written from right
/// to left. On a page in one of them, what still reads as English is in no table, and what does not fit is cut off.

import * as blockly from "blockly/msg/en"
import {en as onBlocks} from "../../../languages/en/blocks/index.ts"
import {en} from "../../../languages/en/page/index.ts"
import type {Table} from "./language_table.ts"
import {measuresOf} from "./number_formats.ts"

/// Around the pieces that a sentence is given, while it is being disguised: they are the program's, and stay.
const [open, close] = ["\ue000", "\ue001"]

const plain = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ"
const marked = [..."åƀçđéƒĝĥîĵķļɱñöþǫŕšţûṽŵẋýžÅƁÇĐÉƑĜĤÎĴĶĻṀÑÖÞǪŔŠŢÛṼŴẊÝŽ"]
const accents = new Map([...plain].map((letter, at) => [letter, marked[at] ?? letter]))

function withAccents(text: string): string {
  const long = text.length < 4 ? "" : "~".repeat(Math.ceil(text.length * 0.3))
  return `${[...text].map(letter => accents.get(letter) ?? letter).join("")}${long}`
}

/// Every word is drawn from right to left (Unicode's "right-to-left override"); numbers are not, in any language.
const fromTheRight = (text: string) =>
  text.replace(/[^\s$%\d]*\p{L}[^\s$%]*/gu, word => `\u202e${word}\u202c`)

/// What is no word in a sentence: the pieces it was given, and where Blockly puts its own.
const fixed = new RegExp(`(${open}[^${close}]*${close}|%\\{[^}]*\\}|%\\d|\\$)`)

function disguised(text: string, disguise: (text: string) => string): string {
  return text
    .split(fixed)
    .map((part, at) => (at % 2 === 1 ? part.replaceAll(open, "").replaceAll(close, "") : disguise(part)))
    .join("")
}

/// The same table in disguise.
function inDisguise<T>(table: T, disguise: (text: string) => string): T {
  const change = (value: unknown): unknown => {
    if (typeof value === "string") return disguised(value, disguise)
    if (typeof value === "function")
      return (...pieces: readonly unknown[]) =>
        change(value(...pieces.map(p => (typeof p === "string" ? `${open}${p}${close}` : p))))
    if (Array.isArray(value)) return value.map(change)
    if (typeof value === "object" && value !== null)
      return Object.fromEntries(Object.entries(value).map(([name, inner]) => [name, change(inner)]))
    return value
  }
  return change(table) as T
}

const {default: _, ...english} = blockly

const table = (tag: string, direction: Table["direction"], disguise: (text: string) => string): Table => ({
  tag,
  direction,
  page: {...inDisguise(en, disguise), blockly: inDisguise(english, disguise)},
  measures: measuresOf("en"),
  blocks: inDisguise(onBlocks, disguise),
  sentences: {
    type: `${disguise("a")} ‘{type}’`,
    function: `${disguise("a function")} ‘{type}’`,
    alternative: ` ${disguise("or")} `,
    sequence: `, ${disguise("then")} `,
    numbers: [],
    template: id =>
      id
        .split(/(\{(?:[A-Za-z]+ )?[A-Za-z]+\})/)
        .map((part, at) => (at % 2 === 1 ? part : disguise(part)))
        .join(""),
  },
})

export const accented = table("en-XA", "ltr", withAccents)
export const mirrored = table("ar-XB", "rtl", fromTheRight)
