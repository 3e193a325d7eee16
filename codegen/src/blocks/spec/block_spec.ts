/// Specification of one kind of block: its shape and its meaning.

import type {BlockView} from "../../api.ts"
import type {Item} from "../../block_shape.ts"
import type {Declaration, Expr, Origin, Pattern, Statement} from "../../model/syntax_tree.ts"
import type {Extra, Json} from "../../serialized_blocks.ts"
import {words} from "../../words/index.ts"

/// Gives a block's `read` its children as model nodes. An empty socket reads as a hole (a wildcard, for patterns).
export interface Reader {
  readonly extra: Extra
  readonly from: Origin
  expr(input: string): Expr
  pattern(input: string): Pattern
  definitions(stack: string): Declaration[]
  steps(stack: string): Statement[]
  /// A problem of this block itself: first what, then why or what to do.
  problem(kind: string, message: string, hint: string, input?: string): void
}

/// A block without its place: what `write` makes of a node.
export interface WrittenBlock {
  readonly extra: Extra
  readonly sockets?: {readonly [input: string]: Expr | Pattern}
  readonly stacks?: {readonly [input: string]: readonly (Declaration | Statement)[]}
}

/// `write` answers `undefined` for nodes that are another kind's; the first kind that accepts a node has it.
export type Meaning =
  | {readonly as: "expression"; read(r: Reader): Expr; write(node: Expr): WrittenBlock | undefined}
  | {readonly as: "pattern"; read(r: Reader): Pattern; write(node: Pattern): WrittenBlock | undefined}
  | {
      readonly as: "definition"
      read(r: Reader): Declaration
      write(node: Declaration): WrittenBlock | undefined
    }
  | {readonly as: "step"; read(r: Reader): Statement; write(node: Statement): WrittenBlock | undefined}

export interface BlockSpec extends BlockView {
  readonly meaning: Meaning
  /// The function of the library that the block calls. Where a program defines that name itself, its calls are written as other blocks.
  readonly calls?: string
  /// The block stands for Haskell that is typed; the toolbox does not offer it.
  readonly onlyFromText?: true
}

export function textIn(extra: Extra, key: string, otherwise = ""): string {
  const value = extra[key]
  return typeof value === "string" ? value : typeof value === "number" ? String(value) : otherwise
}

/// Parts of one kind that a block draws: items, inputs, equations, cases, fields. Further ones are folded (`folding.ts`).
export const shownParts = 60

/// A label that stands for the parts that are not drawn.
export function foldLabel(count: number): readonly Item[] {
  return count <= shownParts ? [] : [{kind: "label", text: words.program.andMore(count - shownParts)}]
}

/// Largest count that is believed: a damaged file may hold any number.
const maximumCount = 100_000

/// A number of sockets.
export function countIn(extra: Extra, key: string, otherwise: number, least = 0): number {
  const value = extra[key]
  return typeof value === "number" && Number.isFinite(value)
    ? Math.max(least, Math.min(maximumCount, Math.floor(value)))
    : otherwise
}

export function listIn(extra: Extra, key: string): readonly Json[] {
  const value = extra[key]
  return Array.isArray(value) ? value : []
}

export function objectsIn(extra: Extra, key: string): readonly Extra[] {
  return listIn(extra, key).map(v =>
    typeof v === "object" && v !== null && !Array.isArray(v) ? (v as Extra) : {},
  )
}

export function stringsIn(extra: Extra, key: string): string[] {
  return listIn(extra, key).filter(v => typeof v === "string")
}

/// Whether buttons leave a list alone: its last part is not drawn, or would not be.
export function isFolded(count: number, isAdding: boolean): boolean {
  return count > shownParts || (isAdding && count === shownParts)
}

/// For blocks whose only buttons are "more" and "fewer" of one kind of socket.
export function counting(
  key: string,
  otherwise: number,
  least: number,
): (extra: Extra, action: string) => Extra {
  return (extra, action) => {
    const now = countIn(extra, key, otherwise, least)
    return isFolded(now, action === "more")
      ? extra
      : {...extra, [key]: action === "more" ? now + 1 : Math.max(least, now - 1)}
  }
}

export const noButtons = (extra: Extra): Extra => extra
