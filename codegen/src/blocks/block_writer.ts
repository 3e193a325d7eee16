/// Conversion from the program model to serialized blocks.
///
/// Total, like reading: what no block can say becomes a raw block with the Haskell it stands for.

import {printDeclarationAlone, printExprAlone, printPatternAlone} from "../haskell/printer.ts"
import type {Declaration, Expr, Node, Pattern, Statement} from "../model/syntax_tree.ts"
import type {SavedBlock, SavedInput} from "../serialized_blocks.ts"
import {blockTypes} from "./block_registry.ts"
import type {BlockSpec, WrittenBlock} from "./spec/block_spec.ts"
import {textIn} from "./spec/block_spec.ts"
import {labelsOf} from "./spec/constructor_labels.ts"

/// Gives a block its id; called once per block, parents first.
export type NewId = (node: Node) => string

export class Writer {
  private readonly newId: NewId
  private readonly own: ReadonlySet<string>

  /// `own`: the names that the program defines, which hide those of the library.
  constructor(newId: NewId, own: ReadonlySet<string> = new Set()) {
    this.newId = newId
    this.own = own
  }

  declaration(node: Declaration): SavedBlock {
    for (const spec of specs.definition) {
      const written = spec.meaning.as === "definition" ? spec.meaning.write(node) : undefined
      if (written !== undefined) return this.block(spec.type, written, node)
    }
    return this.block(
      "raw_definition",
      {extra: {text: printDeclarationAlone({...node, comment: undefined})}},
      node,
    )
  }

  statement(node: Statement): SavedBlock {
    for (const spec of specs.step) {
      if (spec.calls !== undefined && this.own.has(spec.calls)) continue
      const written = spec.meaning.as === "step" ? spec.meaning.write(node) : undefined
      if (written !== undefined) return this.block(spec.type, written, node)
    }
    return this.block("step_do", {extra: {}}, node)
  }

  /// A hole has no block.
  expr(node: Expr): SavedBlock | undefined {
    if (node.kind === "hole") return undefined
    const call = this.stepCall(node)
    if (call !== undefined) return call
    for (const spec of specs.expression) {
      const written = spec.meaning.as === "expression" ? spec.meaning.write(node) : undefined
      if (written !== undefined) return this.block(spec.type, written, node)
    }
    return this.block("raw_expression", {extra: {text: printExprAlone(node)}}, node)
  }

  /// A call with steps of its own, like `replicateM_ 4 $ do …`, is the only step of a stack, so that it looks as it does among other steps.
  private stepCall(node: Expr): SavedBlock | undefined {
    const last =
      node.kind === "infix" && node.op === "$"
        ? node.right
        : node.kind === "apply"
          ? node.args[node.args.length - 1]
          : undefined
    if (last?.kind !== "do") return undefined
    const step: Statement = {kind: "statement", expr: node}
    const isCall = specs.step.some(
      ({calls, meaning}) =>
        calls !== undefined &&
        !this.own.has(calls) &&
        meaning.as === "step" &&
        meaning.write(step)?.stacks !== undefined,
    )
    return isCall ? this.block("do", {extra: {}, stacks: {S: [step]}}, node) : undefined
  }

  pattern(node: Pattern): SavedBlock {
    for (const spec of specs.pattern) {
      const written = spec.meaning.as === "pattern" ? spec.meaning.write(node) : undefined
      if (written !== undefined) return this.block(spec.type, written, node)
    }
    return this.block("raw_pattern", {extra: {text: printPatternAlone(node)}}, node)
  }

  private block(type: string, written: WrittenBlock, node: Node): SavedBlock {
    const block: SavedBlock = {type, id: this.newId(node)}
    if (Object.keys(written.extra).length > 0) block.extraState = written.extra
    const inputs: {[name: string]: SavedInput} = {}
    for (const [name, child] of Object.entries(written.sockets ?? {})) {
      const inner = isPattern(child) ? this.pattern(child) : this.expr(child)
      if (inner?.type === "pattern_any") inner.extraState = {what: partWord(written, name)}
      if (inner !== undefined) inputs[name] = {block: inner}
    }
    for (const [name, children] of Object.entries(written.stacks ?? {})) {
      const first = this.stack(children)
      if (first !== undefined) inputs[name] = {block: first}
    }
    if (Object.keys(inputs).length > 0) block.inputs = inputs
    const comment = (node as {comment?: string}).comment
    if (comment !== undefined && comment !== "") block.icons = {comment: {text: comment}}
    return block
  }

  private stack(nodes: readonly (Declaration | Statement)[]): SavedBlock | undefined {
    const blocks = nodes.map(n => (isStatement(n) ? this.statement(n) : this.declaration(n)))
    blocks.forEach((b, i) => {
      const below = blocks[i + 1]
      if (below !== undefined) b.next = {block: below}
    })
    return blocks[0]
  }
}

const specs: {readonly [as in BlockSpec["meaning"]["as"]]: readonly BlockSpec[]} = {
  definition: blockTypes.filter(s => s.meaning.as === "definition"),
  step: blockTypes.filter(s => s.meaning.as === "step"),
  expression: blockTypes.filter(s => s.meaning.as === "expression"),
  pattern: blockTypes.filter(s => s.meaning.as === "pattern"),
}

/// "any side" says more than "any thing".
function partWord(written: WrittenBlock, input: string): string {
  const index = /^A(\d+)$/.exec(input)?.[1]
  const parts = labelsOf(textIn(written.extra, "con")).parts
  return (index === undefined ? undefined : parts[Number(index)]) ?? "thing"
}

function isPattern(node: Expr | Pattern): node is Pattern {
  return node.kind === "wildcard" || node.kind.endsWith("-pattern")
}

function isStatement(node: Declaration | Statement): node is Statement {
  return node.kind === "bind" || node.kind === "let-statement" || node.kind === "statement"
}
