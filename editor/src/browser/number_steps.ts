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

/// More than the error of a logarithm of a power of ten.
const roundingError = 1e-9

/// The step of numbers with a point that are 0.1 or more: 0.05 m/s is a change of speed that one can see.
const decimalStep = 0.05

/// The least step.
const finest = 0.001

/// How much one step changes a number: 1 for a whole number, which may be an angle or a count; 0.05 for others, and half of the first digit's place where that is less.
export function stepOf(literal: string): number {
  if (!literal.includes(".")) return 1
  const size = Math.abs(Number(literal))
  if (size === 0) return decimalStep
  return Math.max(finest, Math.min(decimalStep, 0.5 * 10 ** Math.floor(Math.log10(size))))
}

/// Pixels of the pointer's way for one step, and steps after which they become larger.
const perStep = 4
const evenSteps = 10

/// How many steps a way of the pointer stands for: one for each few pixels at first, then with the square of the distance.
export function stepsOfWay(pixels: number): number {
  const even = Math.trunc(Math.abs(pixels) / perStep)
  const further = Math.max(0, even - evenSteps)
  return Math.sign(pixels) * (even + Math.floor((further * further) / evenSteps))
}

/// The literal so many steps further.
export function withSteps(literal: string, steps: number): string {
  const step = stepOf(literal)
  const digits = Math.max(digitsOf(literal), Math.ceil(-Math.log10(step) - roundingError))
  const value = Number(literal) + steps * step
  const text = value.toFixed(Math.max(0, digits))
  const short = digits > digitsOf(literal) ? text.replace(/(\.\d+?)0+$/, "$1") : text
  return Number(short) === 0 ? short.replace("-", "") : short
}

/// A literal as it stands in a text: a negative one in parentheses.
export const inText = (literal: string): string => (literal.startsWith("-") ? `(${literal})` : literal)
