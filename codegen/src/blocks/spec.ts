/// What a kind of block is: its look and its meaning, side by side.

import type {BlockView} from "../api.ts"
import type {Declaration, Expr, Origin, Pattern, Statement} from "../model/tree.ts"
import type {Extra, Json} from "../saved.ts"

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
export interface Written {
  readonly extra: Extra
  readonly sockets?: {readonly [input: string]: Expr | Pattern}
  readonly stacks?: {readonly [input: string]: readonly (Declaration | Statement)[]}
}

/// `write` answers `undefined` for nodes that are another kind's; the first kind that accepts a node has it.
export type Meaning =
  | {readonly as: "expression"; read(r: Reader): Expr; write(node: Expr): Written | undefined}
  | {readonly as: "pattern"; read(r: Reader): Pattern; write(node: Pattern): Written | undefined}
  | {readonly as: "definition"; read(r: Reader): Declaration; write(node: Declaration): Written | undefined}
  | {readonly as: "step"; read(r: Reader): Statement; write(node: Statement): Written | undefined}

export interface BlockSpec extends BlockView {
  readonly meaning: Meaning
}

export function textIn(extra: Extra, key: string, otherwise = ""): string {
  const value = extra[key]
  return typeof value === "string" ? value : typeof value === "number" ? String(value) : otherwise
}

/// A number of sockets. Files may hold anything; a block has at most 60 of a kind.
export function countIn(extra: Extra, key: string, otherwise: number, least = 0): number {
  const value = extra[key]
  return typeof value === "number" && Number.isFinite(value)
    ? Math.max(least, Math.min(60, Math.floor(value)))
    : otherwise
}

export function listIn(extra: Extra, key: string): readonly Json[] {
  const value = extra[key]
  return Array.isArray(value) ? value.slice(0, 60) : []
}

export function objectsIn(extra: Extra, key: string): readonly Extra[] {
  return listIn(extra, key).map(v =>
    typeof v === "object" && v !== null && !Array.isArray(v) ? (v as Extra) : {},
  )
}

export function wordsIn(extra: Extra, key: string): string[] {
  return listIn(extra, key).filter(v => typeof v === "string")
}

/// For blocks whose only buttons are "more" and "fewer" of one kind of socket.
export function counting(
  key: string,
  otherwise: number,
  least: number,
): (extra: Extra, action: string) => Extra {
  return (extra, action) => {
    const now = countIn(extra, key, otherwise, least)
    return {...extra, [key]: action === "more" ? Math.min(60, now + 1) : Math.max(least, now - 1)}
  }
}

export const noButtons = (extra: Extra): Extra => extra
