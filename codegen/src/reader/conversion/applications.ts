/// Operators, sections, tuples and applications: from syntax to model. Chains get their fixities and applications become flat.

import {fixityOf} from "../../haskell/fixity.ts"
import type {Cause} from "../../model/raw_reasons.ts"
import type {Expr} from "../../model/syntax_tree.ts"
import type {Range} from "../../source/lexer.ts"
import type {Piece} from "./operator_chains.ts"
import {flatten, isTypeArgument, operatorOf} from "./operator_chains.ts"
import type {Link} from "./operator_resolution.ts"
import {resolve} from "./operator_resolution.ts"
import type {Syntax} from "./parse_tree.ts"
import {child, onlyNamed, withoutParens} from "./parse_tree.ts"
import type {Reading} from "./reading.ts"
import {rawExpr} from "./reading.ts"

export function readChain(node: Syntax, r: Reading): Expr | Cause {
  const pieces: Piece[] = []
  const problem = flatten(node, pieces, r.context)
  if (problem !== undefined) return problem
  const [only] = pieces
  if (pieces.length === 1 && only?.kind === "operand") return readApplication(only.parts, r)
  const links = pieces.map((p): Link<Expr> => {
    if (p.kind !== "operand") return p
    if (p.parts.some(part => r.context.isMask(part))) r.context.whole = "broken"
    const made = readApplication(p.parts, r)
    return {kind: "operand", value: typeof made === "string" ? rawExpr(p, made, r) : made}
  })
  const over = (from: number, to: number): Range => ({
    start: pieces[from]?.start ?? node.start,
    end: pieces[to]?.end ?? node.end,
  })
  const infix = (op: string, left: Expr, right: Expr, from: number, to: number): Expr => {
    const [l, r2] = [bounded(left, r), bounded(right, r)]
    const made = r.context.at(over(from, to), {kind: "infix", op, left: l, right: r2} as const)
    r.context.depths.set(made, 1 + Math.max(depthOf(l, r), depthOf(r2, r)))
    return made
  }
  const group = (first: number, behind: number): Expr | undefined =>
    resolve<Expr>(links.slice(first, behind), r.context.fixities, {
      infix: (op, left, right, from, to) => infix(op, left, right, first + from, first + to),
      negate: (expr, from, to) =>
        r.context.at(
          over(first + from, first + to),
          expr.kind === "number" && !expr.text.startsWith("-")
            ? ({kind: "number", text: `-${expr.text}`} as const)
            : ({kind: "negate", expr} as const),
        ),
    })
  // Where a fixity is not known, what stands behind `$` may still be a part of its own.
  const groupFrom = (first: number): Expr | undefined => {
    const made = group(first, links.length)
    if (made !== undefined) return made
    const dollar = links.findIndex((l, i) => i > first && l.kind === "operator" && l.op === "$")
    if (
      dollar < 0 ||
      !hasUnknownFixity(links.slice(dollar), r) ||
      !bindsTighter(links.slice(first, dollar), r)
    )
      return undefined
    const left = group(first, dollar)
    if (left === undefined) return undefined
    const right = groupFrom(dollar + 1) ?? rawExpr(over(dollar + 1, links.length - 1), "operators", r)
    return infix("$", left, right, first, links.length - 1)
  }
  return groupFrom(0) ?? "operators"
}

function hasUnknownFixity(links: readonly Link<Expr>[], r: Reading): boolean {
  return links.some(l => l.kind === "operator" && Number.isNaN(fixityOf(l.op, r.context.fixities).precedence))
}

/// Whether all operators certainly bind tighter than `$`.
function bindsTighter(links: readonly Link<Expr>[], r: Reading): boolean {
  return links.every(l => l.kind !== "operator" || fixityOf(l.op, r.context.fixities).precedence > 0)
}

/// Nested operators of a chain: a longer one keeps its innermost part as text.
const maximumChain = 80

function depthOf(e: Expr, r: Reading): number {
  return r.context.depths.get(e) ?? 0
}

function bounded(e: Expr, r: Reading): Expr {
  const span = depthOf(e, r) < maximumChain ? undefined : r.context.spans.get(e)
  return span === undefined ? e : rawExpr(span, "deep", r)
}

function readApplication(parts: readonly Syntax[], r: Reading): Expr | Cause {
  const [head, ...rest] = parts
  if (head === undefined) return "expression"
  if (rest.length > 0 && !isGivenToCall(parts, r)) r.context.whole = "broken"
  let fn: Expr
  let args = rest
  const types = parts.map(isTypeArgument).lastIndexOf(true)
  if (types > 0) {
    const end = parts[types]?.end ?? head.end
    const typed = readTypeApplication(parts.slice(0, types), parts[types], r)
    fn = typed ?? rawExpr({start: head.start, end}, "typeApplication", r)
    args = parts.slice(types + 1)
  } else {
    const made = r.convert(head)
    if (typeof made === "string" && args.length === 0) return made
    fn = typeof made === "string" ? rawExpr(head, made, r) : made
  }
  if (args.length === 0) return fn
  const last = args[args.length - 1] ?? head
  // `(f x) y` is `f x y`.
  const [of, before] = fn.kind === "apply" ? [fn.fn, fn.args] : [fn, []]
  return r.context.at({start: head.start, end: last.end}, {
    kind: "apply",
    fn: of,
    args: [...before, ...args.map(a => r.expression(a))],
  } as const)
}

/// Expressions that an application has without brackets only with the extension BlockArguments.
const blockArguments = new Set([
  "do",
  "lambda",
  "lambda_case",
  "lambda_cases",
  "case",
  "conditional",
  "let_in",
  "multi_way_if",
])

/// Whether GHC reads the parts as one call. The grammar also goes on with a call on lines that are further left than the steps or alternatives above
/// them, and that may be unfinished text: a part with an error is no argument, and steps are none before others. As the last argument they say the
/// same in every dialect.
function isGivenToCall(parts: readonly Syntax[], {context}: Reading): boolean {
  if (parts.some(part => context.isMask(part))) return false
  return (
    context.extensions.has("BlockArguments") ||
    !parts.slice(0, -1).some(part => blockArguments.has(part.type))
  )
}

/// `f x @Int`; undefined for other forms of types as arguments.
function readTypeApplication(
  parts: readonly Syntax[],
  argument: Syntax | undefined,
  r: Reading,
): Expr | undefined {
  const [head] = parts
  const written = argument?.type === "type_application" ? onlyNamed(argument) : undefined
  if (head === undefined || written === undefined) return undefined
  const type = withoutParens(written)
  const fn = readApplication(parts, r)
  if (typeof fn === "string") return undefined
  return r.context.at({start: head.start, end: written.end}, {
    kind: "type-apply",
    fn,
    type: r.context.at(type, {kind: "type", text: r.context.typeText(type)} as const),
  } as const)
}

/// The items of a tuple, with a gap where a section leaves one open.
export function readTupleItems(node: Syntax, r: Reading): Expr[] {
  const items: Expr[] = []
  let isOpen = true
  const close = (end: number): void => {
    if (isOpen) items.push(r.context.at({start: end, end}, {kind: "gap"} as const))
    isOpen = true
  }
  for (const c of node.children)
    if (c.field === "element" && c.named) {
      items.push(r.expression(c))
      isOpen = false
    } else if (c.type === "," || c.type === ")") close(c.start)
  return items
}

export function readSection(node: Syntax, r: Reading): Expr | Cause {
  const side = node.type === "left_section" ? "left" : "right"
  const operand = child(node, side === "left" ? "left_operand" : "right_operand")
  const operator =
    child(node, "operator") ?? node.children.find(c => c.named && c !== operand && c.field === undefined)
  if (operand === undefined || operator === undefined) return "expression"
  const op = operatorOf(operator, r.context)
  return op === undefined
    ? "name"
    : r.context.at(node, {kind: "section", op, side, operand: r.expression(operand)})
}
