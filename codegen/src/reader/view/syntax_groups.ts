/// Places of the composite nodes of a definition, to compare its tree with the one that GHC's parser has.
///
/// In: a definition as the reader found it. Out: places in its text, by the rules of `Rosy.Worker.Ghc.SyntaxGroups`: a call with all its arguments is one
/// node, a chain of operators another, and what brackets enclose anyhow is none.

import {childrenOf} from "../../model/child_nodes.ts"
import type {Node} from "../../model/syntax_tree.ts"
import {characterOffsets} from "../../source/character_offsets.ts"
import type {Range} from "../../source/lexer.ts"
import {tokens} from "../../source/lexer.ts"
import type {Piece} from "../module/module_pieces.ts"

export interface SyntaxGroups {
  readonly nodes: readonly Range[]
  /// Text that blocks keep to the letter: the nodes in it are GHC's alone.
  readonly texts: readonly Range[]
}

/// Undefined where the definition has no tree: as a whole it is text, or broken.
export function syntaxGroups({declaration, broken, spans}: Piece): SyntaxGroups | undefined {
  if (declaration === undefined || declaration.kind === "raw-declaration" || broken) return undefined
  const nodes: Range[] = []
  const texts: Range[] = []
  const spanOf = (node: Node): Range => spans.get(node) ?? {start: -1, end: -1}
  const visit = (node: Node): void => {
    if (isText(node)) texts.push(spanOf(node))
    else if (hasPlace(node)) nodes.push(spanOf(node))
    within(node)
  }
  /// Nodes that have no place of their own inside of this one.
  const within = (node: Node): void => {
    if (node.kind === "apply" || node.kind === "type-apply") {
      visitFunction(node.fn)
      if (node.kind === "apply") node.args.forEach(visit)
    } else if (node.kind === "infix" || node.kind === "infix-pattern" || node.kind === "negate")
      operandsOf(node).forEach(visitOperand(node))
    else childrenOf(node).forEach(visit)
  }
  const visitFunction = (fn: Node): void =>
    fn.kind === "apply" || fn.kind === "type-apply" ? within(fn) : visit(fn)
  /// What has no brackets of its own begins or ends where the chain does.
  const visitOperand =
    (chain: Node) =>
    (operand: Node): void => {
      const [outer, inner] = [spanOf(chain), spanOf(operand)]
      const isInChain = isChain(operand) && (inner.start === outer.start || inner.end === outer.end)
      if (isInChain) within(operand)
      else visit(operand)
    }
  /// A sign in front of a chain is in the chain; one in front of anything else is no node.
  const hasPlace = (node: Node): boolean =>
    node.kind === "negate"
      ? node.expr.kind === "infix" && spanOf(node.expr).end === spanOf(node).end
      : node.kind === "constructor-pattern"
        ? node.args.length > 0
        : grouping.has(node.kind)
  visit(declaration)
  return {nodes, texts}
}

const isChain = (node: Node): boolean => ["infix", "infix-pattern", "negate"].includes(node.kind)

const isText = (node: Node): boolean => ["raw", "raw-pattern", "raw-declaration"].includes(node.kind)

function operandsOf(chain: Node & {kind: "infix" | "infix-pattern" | "negate"}): readonly Node[] {
  return chain.kind === "negate" ? [chain.expr] : [chain.left, chain.right]
}

const grouping: ReadonlySet<Node["kind"]> = new Set<Node["kind"]>([
  "clause",
  "binding",
  "alternative",
  "apply",
  "type-apply",
  "infix",
  "lambda",
  "if",
  "branches",
  "case",
  "lambda-case",
  "let",
  "do",
  "typed",
  "record",
  "update",
  "infix-pattern",
  "as-pattern",
  "record-pattern",
  "view-pattern",
  "typed-pattern",
])

/// Whether the places that GHC reports of a definition are those of its tree. Both count from the start of its text. White space, comments and
/// semicolons at their ends do not count.
export function areSameGroups(text: string, {nodes, texts}: SyntaxGroups, theirs: readonly Range[]): boolean {
  const words = tokens(text).filter(t => t.kind !== "comment" && text.slice(t.start, t.end) !== ";")
  const keyOf = ({start, end}: Range): string => {
    const [first, behind] = [countBefore(words, t => t.start < start), countBefore(words, t => t.end <= end)]
    return `${first} ${behind}`
  }
  const isInText = ({start, end}: Range) => texts.some(t => t.start <= start && end <= t.end)
  const ours = new Set(nodes.map(keyOf))
  const reported = new Set(theirs.filter(r => !isInText(r)).map(keyOf))
  return ours.size === reported.size && [...ours].every(key => reported.has(key))
}

/// How many of the first items are like this; those behind them are not.
function countBefore<T>(items: readonly T[], isLike: (item: T) => boolean): number {
  let [low, high] = [0, items.length]
  while (low < high) {
    const middle = (low + high) >> 1
    if (isLike(items[middle] as T)) low = middle + 1
    else high = middle
  }
  return low
}

/// The places in a check's answer (`groups` in `protocol/README.md`): four numbers each.
export function placesOfGroups(text: string, numbers: readonly number[]): readonly Range[] {
  const offset = characterOffsets(text)
  const places: Range[] = []
  let line = 1
  for (let i = 0; i < numbers.length; i += 4) {
    const [down = 0, column = 1, lines = 0, endColumn = 1] = numbers.slice(i, i + 4)
    line += down
    places.push({start: offset(line, column), end: offset(line + lines, endColumn)})
  }
  return places
}
