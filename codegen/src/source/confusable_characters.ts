/// Characters that look like those of Haskell and are others, and characters that cannot be seen: what a word processor writes.
///
/// In: a program and a part of it, such as what was just pasted. Out: those that have no meaning there, with what is meant. Comments and texts in quotation marks
/// are left alone, and so is what the program defines itself. The compiler's worker names the same characters where one is the cause of an error
/// (`Rosy.Worker.Explanation.ConfusableCharacters`), from whose tables those here are made.

import {confusableLetters, confusableSigns, unseenCharacters} from "./confusable_tables.generated.ts"
import {type Range, type Token, tokenAt} from "./lexer.ts"
import {isUnicodeSyntaxOn, lex} from "./top_level_items.ts"

export interface Confusable extends Range {
  readonly character: string
  /// What is written in its place; empty for a character that cannot be seen.
  readonly plain: string
  /// Its name in Unicode: a sentence of `languages/<tag>/sentences.json`.
  readonly name: {readonly id: string; readonly arguments: Readonly<Record<string, string>>}
}

/// The characters in `part` that look like others and have no meaning of their own.
export function confusablesIn(text: string, part: Range): readonly Confusable[] {
  if (!/[^\p{ASCII}]/u.test(text.slice(part.start, part.end))) return []
  return new Scan(text).found.filter(({start, end}) => start >= part.start && end <= part.end)
}

const doubleQuotes = "“”„‟«»‹›＂"
/// The signs that `UnicodeSyntax` gives a meaning.
const extensionSigns = "→⇒←∷∀"
const isUnseen = (c: string) => /\p{Cf}|[\u2028\u2029\u0085]/u.test(c) || (c >= "\uFE00" && c <= "\uFE0F")
/// Unicode's block "Halfwidth and Fullwidth Forms": the printable characters of ASCII in the width of a Chinese character.
const isFullWidth = (c: string) => c >= "\uFF01" && c <= "\uFF5E"
const halfWidth = (c: string) => String.fromCharCode(c.charCodeAt(0) - 0xfee0)
const letterFor = (c: string) => (isFullWidth(c) ? halfWidth(c) : confusableLetters.get(c))
const latin = (word: string) => [...word].map(c => letterFor(c) ?? c).join("")

function plainOf(c: string): string | undefined {
  if (isFullWidth(c)) return halfWidth(c)
  if (isUnseen(c)) return /[\u2028\u2029\u0085]/.test(c) ? "\n" : ""
  return confusableSigns.get(c)?.[0]
}

function nameOf(c: string): Confusable["name"] {
  const named = (id: string, given: Readonly<Record<string, string>> = {}) => ({id, arguments: given})
  const known = confusableSigns.get(c)?.[1] ?? unseenCharacters.get(c)
  if (isFullWidth(c)) return named("the full-width {letter}", {letter: halfWidth(c)})
  if (known !== undefined) return named(known)
  if (confusableLetters.has(c))
    return named(c < "\u0400" ? "the Greek letter {letter}" : "the Cyrillic letter {letter}", {letter: c})
  const code = (c.codePointAt(0) ?? 0).toString(16).toUpperCase().padStart(4, "0")
  return named("the character U+{code}", {code})
}

class Scan {
  readonly found: Confusable[] = []
  private readonly text: string
  private readonly words: ReadonlySet<string>
  /// Operators that the program defines.
  private readonly own: ReadonlySet<string>
  private readonly hasUnicodeSyntax: boolean

  constructor(text: string) {
    this.text = text
    this.words = new Set(text.match(/[A-Za-z][A-Za-z0-9_']*/g))
    this.own = operatorsOf(text)
    this.hasUnicodeSyntax = isUnicodeSyntaxOn(text)
    // GHC passes over a byte order mark at the beginning.
    for (let at = text.startsWith("\uFEFF") ? 1 : 0; at < text.length; ) {
      const token = tokenAt(text, at)
      this.addAll(at, token?.start ?? text.length)
      at = token === null ? text.length : this.pass(token)
    }
  }

  /// Takes a token; the result is where the text goes on, which may be behind the end of a text in curly quotation marks.
  private pass({kind, start, end}: Token): number {
    if (kind === "string" || kind === "comment" || kind === "pragma") return end
    if (kind === "operator") return this.passOperator(start, end)
    this.addWord(start, end)
    return end
  }

  private passOperator(start: number, end: number): number {
    const {text} = this
    const isDefined = this.own.has(text.slice(start, end))
    for (let at = start; at < end; at++) {
      const c = text[at] ?? ""
      const newline = text.indexOf("\n", at)
      const line = newline === -1 ? text.length : newline
      if (
        "—–".includes(c) &&
        text.slice(text.lastIndexOf("\n", at - 1) + 1, at).trim() === "" &&
        !isDefined
      ) {
        this.add(at, "--")
        return line
      }
      const closing = doubleQuotes.includes(c) ? /[“”„‟«»‹›＂"]/ : c === "‘" ? /[’‘]/ : null
      const length = closing === null ? -1 : text.slice(at + 1, line).search(closing)
      if (length !== -1) {
        const close = at + 1 + length
        const mark = c === "‘" && length === 1 ? "'" : '"'
        this.add(at, mark)
        if (text[close] !== '"') this.add(close, mark)
        return close + 1
      }
      if (isDefined || this.own.has(c) || (this.hasUnicodeSyntax && extensionSigns.includes(c))) continue
      this.addAll(at, at + 1)
    }
    return end
  }

  /// A name of nothing but letters that look Latin is a name in another language, unless the program has the Latin one, too.
  private addWord(start: number, end: number): void {
    const word = this.text.slice(start, end)
    if (/^\p{ASCII}*$/u.test(word)) return
    const isMixed = /[A-Za-z0-9]/.test(word)
    const isKnown = this.words.has(latin(word))
    for (let at = start; at < end; at++) {
      const c = this.text[at] ?? ""
      const plain = isUnseen(c) ? "" : letterFor(c)
      if (plain !== undefined && (isMixed || isKnown || isFullWidth(c) || isUnseen(c))) this.add(at, plain)
    }
  }

  private addAll(start: number, end: number): void {
    for (let at = start; at < end; at++) {
      const plain = plainOf(this.text[at] ?? "")
      if (plain !== undefined) this.add(at, plain)
    }
  }

  private add(start: number, plain: string): void {
    const character = this.text[start] ?? ""
    this.found.push({start, end: start + 1, character, plain, name: nameOf(character)})
  }
}

/// The operators that a program gives a meaning: by an equation, in brackets, or with a fixity.
function operatorsOf(text: string): ReadonlySet<string> {
  const inBrackets = [...text.matchAll(/\(([\p{S}\p{P}]+)\)/gu)].map(m => m[1] ?? "")
  const withFixity = [...text.matchAll(/^\s*infix[lr]?\b(.*)$/gm)].flatMap(
    m => (m[1] ?? "").match(/[\p{S}\p{P}]+/gu) ?? [],
  )
  const local = [
    ...text.matchAll(/(?:^[ \t]+|\b(?:where|let)[ \t]+)([^=|"\n]*[\s\w')\]])=(?![\p{S}\p{P}])/gmu),
  ].flatMap(m => (m[1] ?? "").match(/[\p{S}\p{P}]+/gu) ?? [])
  return new Set([...lex(text).items.map(({name}) => name), ...inBrackets, ...withFixity, ...local])
}
