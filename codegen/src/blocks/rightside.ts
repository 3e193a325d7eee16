/// What a definition's equation and a `case`'s alternative have in common: an answer, perhaps under conditions, perhaps with
/// definitions of its own.
///
/// Inputs of part `i`: `E<i>_0` the answer, or with conditions `C<i>_<g>` and `E<i>_<g>`, and `O<i>` for otherwise; `W<i>` the
/// definitions. The first answer keeps its name when conditions come and go.

import type {Expr, Guarded, Pattern, RightSide, Statement} from "../model/tree.ts"
import type {Extra, Json} from "../saved.ts"
import type {Row} from "../shape.ts"
import type {Reader} from "./spec.ts"
import {countIn} from "./spec.ts"

export interface Part {
  readonly guards: number
  readonly otherwise: boolean
  readonly where: boolean
}

export function partOf(extra: Extra): Part {
  return {
    guards: countIn(extra, "guards", 0),
    otherwise: extra.otherwise !== false,
    where: extra.where === true,
  }
}

export function savedPart(part: Part): {readonly [key: string]: Json} {
  return {
    ...(part.guards > 0 ? {guards: part.guards, otherwise: part.otherwise} : {}),
    ...(part.where ? {where: true} : {}),
  }
}

/// `answer` is the word before an answer: "send", "is", "then".
export function rightRows(i: number, part: Part, answer: string, what: string): Row[] {
  const rows: Row[] = []
  const more = {kind: "button", action: `more-guards.${i}`, text: "+", aria: "add a condition"} as const
  if (part.guards === 0)
    rows.push([
      {kind: "label", text: answer},
      {kind: "socket", name: `E${i}_0`, sort: "expression", aria: what},
      more,
    ])
  else {
    for (let g = 0; g < part.guards; g++)
      rows.push([
        {kind: "label", text: "if"},
        {
          kind: "socket",
          name: `C${i}_${g}`,
          sort: "expression",
          aria: `condition ${g + 1}`,
          hint: "condition",
        },
        {kind: "label", text: answer},
        {kind: "socket", name: `E${i}_${g}`, sort: "expression", aria: `${what} if condition ${g + 1} holds`},
      ])
    const last: Row = [
      more,
      {kind: "button", action: `fewer-guards.${i}`, text: "−", aria: "remove the last condition"},
    ]
    rows.push(
      part.otherwise
        ? [
            {kind: "label", text: "otherwise"},
            {kind: "label", text: answer},
            {kind: "socket", name: `O${i}`, sort: "expression", aria: `${what} otherwise`},
            ...last,
          ]
        : last,
    )
  }
  if (part.where)
    rows.push([
      {kind: "label", text: "where"},
      {kind: "stack", name: `W${i}`, sort: "definition", aria: "definitions used here"},
    ])
  return rows
}

export function pressPart(part: Part, action: string): Part {
  if (action === "more-guards") return {...part, guards: Math.min(60, part.guards + 1)}
  if (action === "fewer-guards") return {...part, guards: Math.max(0, part.guards - 1)}
  return action === "where" ? {...part, where: !part.where} : part
}

export function readRight(r: Reader, i: number, part: Part): RightSide {
  const where = part.where ? r.definitions(`W${i}`) : []
  if (part.guards === 0) return {kind: "right", body: r.expr(`E${i}_0`), where}
  const branches: Guarded[] = []
  for (let g = 0; g < part.guards; g++) {
    const condition: Statement = {kind: "statement", expr: r.expr(`C${i}_${g}`)}
    branches.push({kind: "guarded", guards: [condition], body: r.expr(`E${i}_${g}`)})
  }
  if (part.otherwise) {
    const otherwise: Statement = {
      kind: "statement",
      expr: {kind: "variable", name: "otherwise", from: r.from},
    }
    branches.push({kind: "guarded", guards: [otherwise], body: r.expr(`O${i}`)})
  }
  return {kind: "right", body: branches, where}
}

/// The sockets and stacks of a right side, or `undefined` when its guards are more than plain conditions.
export function writeRight(
  i: number,
  right: RightSide,
):
  | {part: Part; sockets: {[input: string]: Expr | Pattern}; stacks: {[input: string]: RightSide["where"]}}
  | undefined {
  const where = right.where.length > 0
  const stacks = where ? {[`W${i}`]: right.where} : {}
  const body = right.body
  if (!Array.isArray(body))
    return {part: {guards: 0, otherwise: true, where}, sockets: {[`E${i}_0`]: body as Expr}, stacks}
  const branches: readonly Guarded[] = body
  const sockets: {[input: string]: Expr} = {}
  const last = branches[branches.length - 1]
  const otherwise = last !== undefined && branches.length > 1 && isOtherwise(last)
  const conditions = otherwise ? branches.slice(0, -1) : branches
  for (const [g, branch] of conditions.entries()) {
    const [guard] = branch.guards
    if (branch.guards.length !== 1 || guard?.kind !== "statement") return undefined
    sockets[`C${i}_${g}`] = guard.expr
    sockets[`E${i}_${g}`] = branch.body
  }
  if (conditions.length === 0) return undefined
  if (otherwise && last !== undefined) sockets[`O${i}`] = last.body
  return {part: {guards: conditions.length, otherwise, where}, sockets, stacks}
}

function isOtherwise(g: Guarded): boolean {
  const [guard] = g.guards
  return (
    g.guards.length === 1 &&
    guard?.kind === "statement" &&
    guard.expr.kind === "variable" &&
    guard.expr.name === "otherwise"
  )
}
