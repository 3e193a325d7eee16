/// A function's type as text: where its arguments and its result stand, and insertions that leave every other character as it is.

import {isAtomicType} from "../haskell/type_text.ts"
import {tokens} from "../source/lexer.ts"

export interface Range {
  readonly start: number
  readonly end: number
}

export interface SignatureParts {
  /// Without the arrows and the space around them.
  readonly arguments: readonly Range[]
  readonly result: Range
}

/// A tuple's place, and those of its parts.
export interface TupleParts {
  readonly whole: Range
  readonly of: readonly Range[]
}

/// The parts of a type such as `Ord a => a -> Maybe b`; undefined where it is quantified.
export function signatureParts(text: string): SignatureParts | undefined {
  if (/\bforall\b|∀/u.test(text)) return undefined
  const comments = tokens(text).filter(token => token.kind === "comment" || token.kind === "string")
  const ends: {at: number; length: number}[] = []
  let depth = 0
  let start = 0
  for (let i = 0; i < text.length; i++) {
    const skipped = comments.find(comment => comment.start === i)
    if (skipped !== undefined) {
      i = skipped.end - 1
      continue
    }
    const c = text[i] ?? ""
    if ("([{".includes(c)) depth++
    else if (")]}".includes(c)) depth--
    else if (depth === 0) {
      const arrow = /^(?:=>|⇒)/.exec(text.slice(i, i + 2))
      if (arrow !== null) {
        start = i + arrow[0].length
        ends.length = 0
        i = start - 1
      }
      const step = /^(?:->|→)/.exec(text.slice(i, i + 2))
      if (step !== null) {
        ends.push({at: i, length: step[0].length})
        i += step[0].length - 1
      }
    }
  }
  const parts: Range[] = []
  for (const {at, length} of ends) {
    parts.push(trimmed(text, start, at, comments))
    start = at + length
  }
  return {arguments: parts, result: trimmed(text, start, text.length, comments)}
}

/// The parts of a type that is a tuple of at least two.
export function tupleParts(text: string, whole: Range): TupleParts | undefined {
  if (text[whole.start] !== "(" || text[whole.end - 1] !== ")") return undefined
  const comments = tokens(text).filter(token => token.kind === "comment")
  const commas: number[] = []
  let depth = 0
  for (let i = whole.start; i < whole.end; i++) {
    const comment = comments.find(({start}) => start === i)
    if (comment !== undefined) {
      i = comment.end - 1
      continue
    }
    const c = text[i] ?? ""
    if ("([{".includes(c)) depth++
    else if (")]}".includes(c)) depth--
    else if (c === "," && depth === 1) commas.push(i)
    if (depth === 0 && i < whole.end - 1) return undefined
  }
  if (commas.length === 0) return undefined
  const starts = [whole.start, ...commas].map(at => at + 1)
  const ends = [...commas, whole.end - 1]
  return {whole, of: starts.map((start, i) => trimmed(text, start, ends[i] ?? start, comments))}
}

/// A range without space and comments around it.
function trimmed(text: string, start: number, end: number, comments: readonly Range[]): Range {
  for (let moved = true; moved; ) {
    moved = false
    while (start < end && /\s/.test(text[start] ?? "")) start++
    while (end > start && /\s/.test(text[end - 1] ?? "")) end--
    for (const comment of comments) {
      if (comment.start === start && comment.end <= end) [start, moved] = [comment.end, true]
      if (comment.end === end && comment.start >= start && start < end) [end, moved] = [comment.start, true]
    }
  }
  return {start, end}
}

export const textOf = (text: string, {start, end}: Range): string => text.slice(start, end)

/// A type as an argument of another one.
const bracketed = (type: string): string => (isAtomicType(type) ? type : `(${type})`)

/// With one more argument before all others, or behind them.
export function withArgument(text: string, parts: SignatureParts, type: string, first: boolean): string {
  const at = first ? (parts.arguments[0] ?? parts.result).start : parts.result.start
  return `${text.slice(0, at)}${type} -> ${text.slice(at)}`
}

/// With `Either` around an argument and another type.
export function withAlternative(text: string, argument: Range, type: string): string {
  const {start, end} = argument
  return `${text.slice(0, start)}Either ${bracketed(textOf(text, argument))} ${bracketed(type)}${text.slice(end)}`
}

/// With one more part in the result, or in a part of it; `flat` where that is a tuple already. Brackets around it become those of the tuple.
export function withResultPart(
  text: string,
  {result}: Pick<SignatureParts, "result">,
  type: string,
  flat: boolean,
): string {
  const {start, end} = result
  const now = textOf(text, result)
  const isBracketed = now.startsWith("(") && isAtomicType(now) && tupleParts(text, result) === undefined
  const inside = isBracketed && now !== "()" ? now.slice(1, -1) : now
  return flat
    ? `${text.slice(0, end - 1)}, ${type}${text.slice(end - 1)}`
    : `${text.slice(0, start)}(${inside}, ${type})${text.slice(end)}`
}

/// Without an argument and the arrow behind it.
export function withoutArgument(text: string, parts: SignatureParts, i: number): string {
  const from = parts.arguments[i]
  const next = parts.arguments[i + 1] ?? parts.result
  return from === undefined ? text : text.slice(0, from.start) + text.slice(next.start)
}

/// With another text in the place of an argument.
export function withReplaced(text: string, {start, end}: Range, by: string): string {
  return text.slice(0, start) + by + text.slice(end)
}

/// Without one part of a tuple. Of two the other one stays alone; `isArgument` is that of another type, such as `Maybe`.
export function withoutTuplePart(
  text: string,
  {whole, of}: TupleParts,
  i: number,
  isArgument: boolean,
): string {
  if (of.length === 2) {
    const other = of[1 - i]
    const alone = other === undefined ? "" : textOf(text, other)
    return withReplaced(text, whole, isArgument ? bracketed(alone) : alone)
  }
  const [cut, before, after] = [of[i], of[i - 1], of[i + 1]]
  if (cut === undefined) return text
  return before === undefined
    ? withReplaced(text, {start: cut.start, end: after?.start ?? cut.end}, "")
    : withReplaced(text, {start: before.end, end: cut.end}, "")
}
