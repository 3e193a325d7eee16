/// What a definition's equation and a `case`'s alternative have in common: an answer, perhaps under conditions, perhaps with
/// definitions of its own.
///
/// Inputs of part `i`: `E<i>_0` the answer, or with conditions `C<i>_<g>` (stacked: `G<i>_<g>`) and `E<i>_<g>`, and `O<i>` for otherwise; `W<i>` the
/// definitions. The first answer keeps its name when conditions come and go.

import type {MenuEntry, Row} from "../../block_shape.ts"
import type {Expr, Guarded, Pattern, RightSide, Statement} from "../../model/syntax_tree.ts"
import type {Extra, Json} from "../../serialized_blocks.ts"
import {words} from "../../words/index.ts"
import type {Reader} from "../spec/block_spec.ts"
import {countIn, foldLabel, isFolded, listIn, shownParts} from "../spec/block_spec.ts"

export interface Part {
  readonly guards: number
  readonly otherwise: boolean
  readonly where: boolean
  /// The conditions that are a stack of questions, all of which must hold; they can also take a value apart.
  readonly stacked: readonly number[]
}

export function partOf(extra: Extra): Part {
  return {
    guards: countIn(extra, "guards", 0),
    otherwise: extra.otherwise !== false,
    where: extra.where === true,
    stacked: listIn(extra, "stacked").filter(g => typeof g === "number"),
  }
}

export function savedPart(part: Part): {readonly [key: string]: Json} {
  return {
    ...(part.guards > 0 ? {guards: part.guards, otherwise: part.otherwise} : {}),
    ...(part.stacked.length > 0 ? {stacked: [...part.stacked]} : {}),
    ...(part.where ? {where: true} : {}),
  }
}

/// `answer` is the word before an answer: "send", "is", "then". `which` names the part when there are several.
export function rightRows(i: number, part: Part, answer: string, what: string, which: string): Row[] {
  const rows: Row[] = []
  const more = {
    kind: "button",
    action: `more-guards.${i}`,
    text: "+",
    aria: words.answers.addACondition + which,
  } as const
  if (part.guards === 0)
    rows.push([
      {kind: "label", text: answer},
      {kind: "socket", name: `E${i}_0`, sort: "expression", aria: what + which},
      more,
    ])
  else {
    for (let g = 0; g < Math.min(part.guards, shownParts); g++) {
      const then: Row = [
        {kind: "label", text: answer},
        {
          kind: "socket",
          name: `E${i}_${g}`,
          sort: "expression",
          aria: words.answers.ifConditionHolds(what, g + 1) + which,
        },
      ]
      const asked = condition(i, g, part, which)
      // A stack ends its row.
      rows.push(...(part.stacked.includes(g) ? [asked, then] : [[...asked, ...then]]))
    }
    if (part.guards > shownParts) rows.push(foldLabel(part.guards))
    const last: Row = isFolded(part.guards, false)
      ? []
      : [
          ...(isFolded(part.guards, true) ? [] : [more]),
          {
            kind: "button",
            action: `fewer-guards.${i}`,
            text: "−",
            aria: words.answers.removeTheLastCondition + which,
          },
        ]
    rows.push(
      part.otherwise
        ? [
            {kind: "label", text: words.answers.otherwise},
            {kind: "label", text: answer},
            {kind: "socket", name: `O${i}`, sort: "expression", aria: words.answers.otherwise2(what) + which},
            ...last,
          ]
        : last,
    )
  }
  if (part.where)
    rows.push([
      {kind: "label", text: words.answers.where},
      {kind: "stack", name: `W${i}`, sort: "definition", aria: words.answers.definitionsUsed + which},
    ])
  return rows
}

function condition(i: number, g: number, part: Part, which: string): Row {
  const aria = words.answers.condition(g + 1) + which
  if (part.stacked.includes(g))
    return [
      {kind: "label", text: words.answers.ifAll},
      {kind: "stack", name: `G${i}_${g}`, sort: "step", aria},
    ]
  return [
    {kind: "label", text: words.answers.if},
    {kind: "socket", name: `C${i}_${g}`, sort: "expression", aria, hint: words.answers.condition2},
  ]
}

export function pressPart(part: Part, action: string): Part {
  if (isFolded(part.guards, action === "more-guards") && /guards|stacked/.test(action)) return part
  if (action === "more-guards") return {...part, guards: part.guards + 1}
  if (action === "fewer-guards") return {...part, guards: Math.max(0, part.guards - 1)}
  if (action === "where") return {...part, where: !part.where}
  if (action === "otherwise") return {...part, otherwise: !part.otherwise}
  // The last condition, as a stack of questions or as one.
  const last = part.guards - 1
  if (action !== "stacked" || last < 0) return part
  const others = part.stacked.filter(g => g !== last)
  return {...part, stacked: others.length < part.stacked.length ? others : [...others, last]}
}

/// What a part offers in its block's menu; `which` names the part when there are several.
export function partMenu(i: number, part: Part, which: string): MenuEntry[] {
  const entries: MenuEntry[] = [
    {
      action: `where.${i}`,
      text: part.where
        ? words.answers.removeOwnDefinitionsWhere(which)
        : words.answers.addOwnDefinitionsWhere(which),
    },
  ]
  if (part.guards === 0) return entries
  const stacked = part.stacked.includes(part.guards - 1)
  return [
    ...entries,
    {
      action: `otherwise.${i}`,
      text: part.otherwise ? words.answers.removeOtherwise(which) : words.answers.addOtherwise(which),
    },
    {
      action: `stacked.${i}`,
      text: stacked
        ? words.answers.askTheLastConditionAsOne(which)
        : words.answers.askTheLastConditionInSteps(which),
    },
  ]
}

export function readRight(r: Reader, i: number, part: Part): RightSide {
  const where = part.where ? r.definitions(`W${i}`) : []
  if (part.guards === 0) return {kind: "right", body: r.expr(`E${i}_0`), where}
  const branches: Guarded[] = []
  for (let g = 0; g < part.guards; g++) {
    const guards: Statement[] = part.stacked.includes(g)
      ? r.steps(`G${i}_${g}`)
      : [{kind: "statement", expr: r.expr(`C${i}_${g}`)}]
    if (guards.length === 0) {
      const input = `G${i}_${g}`
      r.problem(
        "hole",
        words.answers.thereIsNoConditionHereYet,
        words.answers.putAtLeastOneConditionIntoTheStack,
        input,
      )
      guards.push({kind: "statement", expr: {kind: "hole", from: {block: r.from.block, input}}})
    }
    branches.push({kind: "guarded", guards, body: r.expr(`E${i}_${g}`)})
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

type Stacks = {[input: string]: RightSide["where"] | readonly Statement[]}

/// The sockets and stacks of a right side, or `undefined` when no block has its shape.
export function writeRight(
  i: number,
  right: RightSide,
): {part: Part; sockets: {[input: string]: Expr | Pattern}; stacks: Stacks} | undefined {
  const where = right.where.length > 0
  const stacks: Stacks = where ? {[`W${i}`]: right.where} : {}
  const body = right.body
  if (!Array.isArray(body))
    return {
      part: {guards: 0, otherwise: true, where, stacked: []},
      sockets: {[`E${i}_0`]: body as Expr},
      stacks,
    }
  const branches: readonly Guarded[] = body
  const sockets: {[input: string]: Expr} = {}
  const last = branches[branches.length - 1]
  const otherwise = last !== undefined && branches.length > 1 && isOtherwise(last)
  const conditions = otherwise ? branches.slice(0, -1) : branches
  const stacked: number[] = []
  for (const [g, branch] of conditions.entries()) {
    const [guard] = branch.guards
    if (guard === undefined) return undefined
    if (branch.guards.length === 1 && guard.kind === "statement") sockets[`C${i}_${g}`] = guard.expr
    else {
      stacked.push(g)
      stacks[`G${i}_${g}`] = branch.guards
    }
    sockets[`E${i}_${g}`] = branch.body
  }
  if (conditions.length === 0) return undefined
  if (otherwise && last !== undefined) sockets[`O${i}`] = last.body
  return {part: {guards: conditions.length, otherwise, where, stacked}, sockets, stacks}
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
