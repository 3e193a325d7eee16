/// Conversion from serialized blocks to the program model.
///
/// Total: whatever a file holds, a program comes out; what is missing or strange is a hole or a piece of raw Haskell, and
/// a problem on its block.

import type {BlockProblem} from "../api.ts"
import type {Declaration, Expr, Pattern, Program, Statement} from "../model/syntax_tree.ts"
import type {BlockId, SavedBlock, SavedWorkspace} from "../serialized_blocks.ts"
import {words} from "../words/index.ts"
import {blockView} from "./block_registry.ts"
import {foldedIn, foldedSteps} from "./folding.ts"
import type {BlockSpec, Reader} from "./spec/block_spec.ts"

/// A tree of blocks that belongs to no definition: an expression, a pattern or steps.
export type Loose =
  | {readonly kind: "expression"; readonly block: BlockId; readonly expr: Expr}
  | {readonly kind: "pattern"; readonly block: BlockId; readonly pattern: Pattern}
  | {readonly kind: "steps"; readonly block: BlockId; readonly steps: readonly Statement[]}

export interface ReadWorkspace {
  readonly program: Program
  readonly loose: readonly Loose[]
  readonly problems: readonly BlockProblem[]
  readonly header: string | undefined
}

export interface ReadTree {
  readonly declarations: readonly Declaration[]
  readonly loose: Loose | undefined
  readonly problems: readonly BlockProblem[]
}

/// Deeper trees are cut. Layouts deeper than 300 are not opened (`folding.ts`).
const deepest = 400

/// With `known`, trees of the very same saved blocks are read only once.
export function readWorkspace(
  workspace: SavedWorkspace,
  known?: WeakMap<SavedBlock, ReadTree>,
): ReadWorkspace {
  const declarations: Declaration[] = []
  const loose: Loose[] = []
  const problems: BlockProblem[] = []
  for (const block of inOrder(workspace.blocks.blocks)) {
    const tree = known?.get(block) ?? readTree(block)
    known?.set(block, tree)
    declarations.push(...tree.declarations)
    if (tree.loose !== undefined) loose.push(tree.loose)
    problems.push(...tree.problems)
  }
  return {program: {kind: "program", declarations}, loose, problems, header: workspace.header}
}

/// Definitions in the order in which the workspace keeps them, with `main` last, as Haskell programs have it.
export function inOrder(blocks: readonly SavedBlock[]): readonly SavedBlock[] {
  return [...blocks.filter(b => b.type !== "main"), ...blocks.filter(b => b.type === "main")]
}

/// One block that stands on the workspace, with all it carries.
export function readTree(block: SavedBlock): ReadTree {
  const reading = new Reading()
  const as = blockView(block.type)?.meaning.as
  if (as === "definition")
    return {declarations: reading.definitions(block), loose: undefined, problems: reading.problems}
  const id = block.id ?? ""
  const loose: Loose | undefined =
    as === "expression"
      ? {kind: "expression", block: id, expr: reading.expr(block)}
      : as === "pattern"
        ? {kind: "pattern", block: id, pattern: reading.pattern(block)}
        : as === "step"
          ? {kind: "steps", block: id, steps: reading.steps(block)}
          : undefined
  // An empty socket of a loose block is no problem of its own; the whole block is.
  const problems: BlockProblem[] = [
    {
      severity: "warning",
      kind: "loose",
      block: id,
      message:
        loose === undefined ? words.program.thisBlockIsOfAKind : words.program.thisBlockBelongsToNoFunctionSo,
      hint:
        loose === undefined
          ? words.program.itMayComeFromANewerVersion
          : words.program.putItIntoASocketOrThrow,
    },
  ]
  return {declarations: [], loose, problems}
}

class Reading {
  readonly problems: BlockProblem[] = []
  private depth = 0
  /// The drawn block that holds the folded one that is read; nodes made from folded blocks belong to it.
  private holder: BlockId | undefined
  /// Comments of expressions and patterns; the definition or step around them takes them over.
  private remarks: string[] = []

  definitions(first: SavedBlock): Declaration[] {
    return chain(first).map(block => {
      const spec = blockView(block.type)
      if (spec?.meaning.as !== "definition") {
        this.strange(block)
        return {kind: "raw-declaration", text: "", from: {block: this.idOf(block)}}
      }
      const meaning = spec.meaning
      return this.remarked(block, () => meaning.read(this.reader(block)))
    })
  }

  steps(first: SavedBlock): Statement[] {
    return chain(first).map(block => {
      const spec = blockView(block.type)
      if (spec?.meaning.as !== "step") {
        this.strange(block)
        return {kind: "statement", expr: this.hole(this.idOf(block), undefined)}
      }
      const meaning = spec.meaning
      return this.remarked(block, () => meaning.read(this.reader(block)))
    })
  }

  expr(block: SavedBlock): Expr {
    const spec = blockView(block.type)
    if (spec?.meaning.as !== "expression") {
      this.strange(block)
      return this.hole(this.idOf(block), undefined)
    }
    this.remark(block)
    return spec.meaning.read(this.reader(block))
  }

  pattern(block: SavedBlock): Pattern {
    const spec = blockView(block.type)
    if (spec?.meaning.as !== "pattern") {
      this.strange(block)
      return {kind: "wildcard", from: {block: this.idOf(block)}}
    }
    this.remark(block)
    return spec.meaning.read(this.reader(block))
  }

  private idOf(block: SavedBlock): BlockId {
    return this.holder ?? block.id ?? ""
  }

  private reader(block: SavedBlock): Reader {
    const id = this.idOf(block)
    const folded = foldedIn(block.extraState)
    const child = (input: string) =>
      block.inputs?.[input]?.block ?? block.inputs?.[input]?.shadow ?? folded[input]
    const isFolded = (input: string) => block.inputs?.[input] === undefined && folded[input] !== undefined
    const held = <T>(isHeld: boolean, go: () => T): T => {
      const {holder} = this
      if (isHeld) this.holder ??= id
      const result = go()
      this.holder = holder
      return result
    }
    const within = <T>(go: () => T, otherwise: () => T): T => {
      if (this.depth > deepest) return otherwise()
      this.depth++
      try {
        return go()
      } finally {
        this.depth--
      }
    }
    return {
      extra: block.extraState ?? {},
      from: {block: id},
      expr: input => {
        const inner = child(input)
        return inner === undefined
          ? this.empty(block, input)
          : within(
              () => held(isFolded(input), () => this.expr(inner)),
              () => this.hole(id, input),
            )
      },
      pattern: input => {
        const inner = child(input)
        const wildcard: Pattern = {kind: "wildcard", from: {block: id, input}}
        return inner === undefined
          ? wildcard
          : within(
              () => held(isFolded(input), () => this.pattern(inner)),
              () => wildcard,
            )
      },
      definitions: input => {
        const inner = child(input)
        return inner === undefined
          ? []
          : within(
              () => [
                ...held(isFolded(input), () => this.definitions(inner)),
                ...held(true, () => foldedSteps(block.extraState, input).flatMap(s => this.definitions(s))),
              ],
              () => [],
            )
      },
      steps: input => {
        const inner = child(input)
        return inner === undefined
          ? []
          : within(
              () => [
                ...held(isFolded(input), () => this.steps(inner)),
                ...held(true, () => foldedSteps(block.extraState, input).flatMap(s => this.steps(s))),
              ],
              () => [],
            )
      },
      problem: (kind, message, hint, input) => {
        this.problems.push({severity: "error", kind, block: id, input, message, hint})
      },
    }
  }

  private empty(block: SavedBlock, input: string): Expr {
    this.problems.push({
      severity: "error",
      kind: "hole",
      block: this.idOf(block),
      input,
      message: words.program.somethingIsMissing,
      hint: words.program.fillTheEmptySocket(socketWords(blockView(block.type), block, input)),
    })
    return this.hole(this.idOf(block), input)
  }

  private hole(block: BlockId, input: string | undefined): Expr {
    return {kind: "hole", from: {block, input}}
  }

  private strange(block: SavedBlock): void {
    this.problems.push({
      severity: "error",
      kind: "unknown-block",
      block: this.idOf(block),
      message: words.program.thisBlockDoesNotBelong,
      hint: words.program.takeItOutAndPutAnother,
    })
  }

  private remark(block: SavedBlock): void {
    const text = block.icons?.comment?.text
    if (text !== undefined && text.trim() !== "") this.remarks.push(text)
  }

  private remarked<T extends Declaration | Statement>(block: SavedBlock, read: () => T): T {
    const outer = this.remarks
    this.remarks = []
    this.remark(block)
    const node = read()
    const remarks = this.remarks
    this.remarks = outer
    return remarks.length === 0 ? node : {...node, comment: remarks.join("\n")}
  }
}

/// A block and those stacked below it.
export function chain(first: SavedBlock): SavedBlock[] {
  const blocks: SavedBlock[] = []
  for (let b: SavedBlock | undefined = first; b !== undefined; b = b.next?.block) blocks.push(b)
  return blocks
}

function socketWords(spec: BlockSpec | undefined, block: SavedBlock, input: string): string {
  for (const row of spec?.shape(block.extraState ?? {}).rows ?? [])
    for (const item of row) if (item.kind === "socket" && item.name === input) return item.aria
  return words.program.aBlock
}
