/// Numbers that are dragged: literals of a program, changed by sensible steps. Pure.

/// A number in a text: a literal without a sign, or a negative one in its parentheses.
export interface NumberPlace {
  readonly from: number
  readonly to: number
  readonly literal: string
}

const numbers = /\(-\d+(?:\.\d+)?\)|\d+(?:\.\d+)?/g

/// The number that a place of a line touches; `null` for none, within names, exponents, comments and texts.
export function numberAt(line: string, at: number): NumberPlace | null {
  for (const match of line.matchAll(numbers)) {
    const from = match.index
    const to = from + match[0].length
    if (at < from || at > to) continue
    const before = line.slice(0, from)
    const partOfMore = /[\w.']$/.test(before) || /^[\w.']/.test(line.slice(to))
    const isCode = !before.includes("--") && (before.match(/"/g)?.length ?? 0) % 2 === 0
    return partOfMore || !isCode ? null : {from, to, literal: match[0].replace(/[()]/g, "")}
  }
  return null
}

/// Digits behind the point that a number is written with; whole numbers stay whole, because they may be counts.
const digitsOf = (literal: string): number => /\.(\d+)/.exec(literal)?.[1]?.length ?? 0

/// Most digits behind the point of a step.
const finest = 3

/// How much one step changes a number: a fiftieth of it or less, and never more than its last digit but one; at least 1 for whole numbers.
export function stepOf(literal: string): number {
  const size = Math.abs(Number(literal))
  const magnitude = size === 0 ? -1 : Math.floor(Math.log10(size)) - 1
  if (!literal.includes(".")) return Math.max(1, 10 ** magnitude)
  return 10 ** Math.max(-finest, Math.min(magnitude, -digitsOf(literal)))
}

/// The literal so many steps further.
export function withSteps(literal: string, steps: number): string {
  const step = stepOf(literal)
  const digits = Math.max(digitsOf(literal), Math.round(-Math.log10(step)))
  const value = Number(literal) + steps * step
  const text = value.toFixed(Math.max(0, digits))
  const short = digits > digitsOf(literal) ? text.replace(/(\.\d+?)0+$/, "$1") : text
  return Number(short) === 0 ? short.replace("-", "") : short
}

/// A literal as it stands in a text: a negative one in parentheses.
export const inText = (literal: string): string => (literal.startsWith("-") ? `(${literal})` : literal)
