/// What Haskell's string and character literals stand for. (Haskell 2010 report §2.6)

import {isNumberLiteral} from "../../haskell/lexemes.ts"

const named: readonly string[] =
  "NUL SOH STX ETX EOT ENQ ACK BEL BS HT LF VT FF CR SO SI DLE DC1 DC2 DC3 DC4 NAK SYN ETB CAN EM SUB ESC FS GS RS US SP".split(
    " ",
  )

const single: {readonly [letter: string]: string} = {
  a: "\x07",
  b: "\b",
  f: "\f",
  n: "\n",
  r: "\r",
  t: "\t",
  v: "\v",
  "\\": "\\",
  '"': '"',
  "'": "'",
}

const escapes = new RegExp(
  `\\\\(?:([abfnrtv\\\\"'])|\\^([@-_])|(\\d+)|o([0-7]+)|x([\\da-fA-F]+)|(${[...named].sort((a, b) => b.length - a.length).join("|")}|DEL)|(&)|(\\s+\\\\))`,
  "y",
)

/// The value of a literal in quotes, or `undefined` when it is malformed or holds what is no character.
function literalValue(text: string): string | undefined {
  const quote = text[0]
  if (text.length < 2 || (quote !== '"' && quote !== "'") || !text.endsWith(quote)) return undefined
  let value = ""
  let at = 1
  while (at < text.length - 1) {
    if (text[at] !== "\\") {
      if (text[at] === "\n" || text[at] === "\t") return undefined
      value += text[at]
      at++
      continue
    }
    escapes.lastIndex = at
    const found = escapes.exec(text)
    if (found === null || escapes.lastIndex > text.length - 1) return undefined
    at = escapes.lastIndex
    const [, letter, control, decimal, octal, hexadecimal, name] = found
    if (letter !== undefined) value += single[letter] ?? ""
    else if (control !== undefined) value += String.fromCharCode(control.charCodeAt(0) - 64)
    else if (name !== undefined) value += name === "DEL" ? "\x7f" : String.fromCharCode(named.indexOf(name))
    else {
      const code =
        decimal !== undefined
          ? Number(decimal)
          : octal !== undefined
            ? Number.parseInt(octal, 8)
            : hexadecimal !== undefined
              ? Number.parseInt(hexadecimal, 16)
              : undefined
      // A gap or `\&` stands for nothing.
      if (code === undefined) continue
      if (code > 0x10ffff || (code >= 0xd800 && code <= 0xdfff)) return undefined
      value += String.fromCodePoint(code)
    }
  }
  return /[\uD800-\uDBFF](?![\uDC00-\uDFFF])|(?<![\uD800-\uDBFF])[\uDC00-\uDFFF]/.test(value)
    ? undefined
    : value
}

export type Literal =
  | {readonly kind: "number"; readonly text: string}
  | {readonly kind: "string" | "character"; readonly value: string}

/// A literal of any kind, told by its first character; `undefined` for what blocks cannot spell.
export function readLiteral(text: string): Literal | undefined {
  const kind = text.startsWith('"') ? "string" : text.startsWith("'") ? "character" : "number"
  if (kind === "number") {
    const number = text.replace(/^- */, "-")
    return isNumberLiteral(number.replace(/^-/, "")) ? {kind, text: number} : undefined
  }
  const value = literalValue(text)
  return value === undefined ? undefined : {kind, value}
}
