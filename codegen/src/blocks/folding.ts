/// Folding of long blocks: parts beyond those that a block draws are kept in its `extraState`.
///
/// `extraState.folded` maps an input's name to the block in it. Steps of a stack beyond the drawn ones have the names `S+200`, `S+201`, … of
/// their place in stack `S`. Folded blocks are part of the program like all others: they are read, inferred, renamed and printed.

import type {BlockView} from "../api.ts"
import type {Row} from "../block_shape.ts"
import type {BlockId, Extra, SavedBlock, SavedInput} from "../serialized_blocks.ts"
import {words} from "../words/index.ts"

/// Steps or definitions of one stack that are drawn.
const shownSteps = 200

type Folded = {readonly [input: string]: SavedBlock}

/// The folded inputs of a block.
export function foldedIn(extra: Extra | undefined): Folded {
  const folded = extra?.folded
  return typeof folded === "object" && folded !== null && !Array.isArray(folded)
    ? (folded as unknown as Folded)
    : {}
}

/// The name of the input that holds the step of a stack at a place.
function stepInput(stack: string, place: number): string {
  return `${stack}+${place}`
}

/// The steps of a stack that are folded.
export function foldedSteps(extra: Extra | undefined, stack: string): readonly SavedBlock[] {
  const folded = foldedIn(extra)
  const steps: SavedBlock[] = []
  for (let i = shownSteps; ; i++) {
    const step = folded[stepInput(stack, i)]
    if (step === undefined) return steps
    steps.push(step)
  }
}

/// A row for the folded steps of each stack.
export function withFoldedSteps(rows: readonly Row[], extra: Extra): readonly Row[] {
  if (extra.folded === undefined) return rows
  return rows.flatMap(row => {
    const last = row[row.length - 1]
    const count = last?.kind === "stack" ? foldedSteps(extra, last.name).length : 0
    return count === 0 ? [row] : [row, [{kind: "label", text: words.program.andMore(count)} as const]]
  })
}

/// A block and all in it with long lists folded. `holders` receives for each folded block the block that now holds it.
export function fold(
  block: SavedBlock,
  view: (type: string) => BlockView | undefined,
  holders: Map<BlockId, BlockId> = new Map(),
): SavedBlock {
  const given = Object.entries(block.inputs ?? {})
  const inputs: {[name: string]: SavedInput} = {}
  const folded: {[name: string]: SavedBlock} = {...foldedIn(block.extraState)}
  const drawn = given.some(([name]) => /\d\d/.test(name)) ? drawnInputs(block, view) : undefined
  for (const [name, input] of given) {
    if (input.block === undefined) {
      inputs[name] = input
      continue
    }
    const steps = stackOf(input.block).map(s => fold(alone(s), view, holders))
    steps.slice(shownSteps).forEach((s, i) => {
      folded[stepInput(name, shownSteps + i)] = s
    })
    const first = stacked(steps.slice(0, shownSteps))
    if (first === undefined) inputs[name] = input
    else if (drawn === undefined || drawn.has(name)) inputs[name] = {...input, block: first}
    else folded[name] = first
  }
  const result: SavedBlock = {...block, ...(block.inputs === undefined ? {} : {inputs})}
  if (Object.keys(folded).length > 0)
    result.extraState = {...block.extraState, folded: folded as unknown as Extra}
  const {id} = block
  if (id !== undefined)
    for (const inner of Object.values(folded)) everyId(inner, innerId => holders.set(innerId, id))
  return result
}

function stacked(blocks: readonly SavedBlock[]): SavedBlock | undefined {
  return blocks.reduceRight<SavedBlock | undefined>(
    (below, block) => (below === undefined ? block : {...block, next: {block: below}}),
    undefined,
  )
}

function drawnInputs(
  block: SavedBlock,
  view: (type: string) => BlockView | undefined,
): Set<string> | undefined {
  const shape = view(block.type)?.shape(block.extraState ?? {})
  return (
    shape &&
    new Set(
      shape.rows.flatMap(row =>
        row.flatMap(i => (i.kind === "socket" || i.kind === "stack" ? [i.name] : [])),
      ),
    )
  )
}

/// A block and all in it without folds: every part in an input of its own.
export function unfold(block: SavedBlock): SavedBlock {
  const {folded: _, ...extra} = block.extraState ?? {}
  const inputs: {[name: string]: SavedInput} = {}
  for (const [name, input] of Object.entries(block.inputs ?? {}))
    inputs[name] = input.block === undefined ? input : {...input, block: unfold(input.block)}
  for (const [name, inner] of Object.entries(foldedIn(block.extraState)))
    inputs[name] = {block: unfold(inner)}
  const result: SavedBlock = {...block}
  if (block.extraState !== undefined) result.extraState = extra
  if (Object.keys(inputs).length > 0) result.inputs = inputs
  if (block.next?.block !== undefined) result.next = {...block.next, block: unfold(block.next.block)}
  return result
}

/// Nesting of blocks that a layout may have. What is made from text stays far below (`reader/conversion/conversion_context.ts`).
const maximumNesting = 300

/// Whether a block tree can be drawn: bounded nesting, and every input exists in the shape of its block.
export function isDrawableIn(
  first: SavedBlock,
  view: (type: string) => BlockView | undefined,
  depth = 0,
): boolean {
  if (depth > maximumNesting) return false
  const steps = stackOf(first)
  if (steps.length > 2 * shownSteps) return false
  return steps.every(block => {
    const given = Object.entries(block.inputs ?? {})
    const drawn = given.some(([name]) => /\d\d/.test(name)) ? drawnInputs(block, view) : undefined
    return (
      given.every(
        ([name, {block: inner}]) =>
          (drawn === undefined || drawn.has(name)) &&
          (inner === undefined || isDrawableIn(inner, view, depth + 1)),
      ) && Object.values(foldedIn(block.extraState)).every(inner => isDrawableIn(inner, view, depth + 1))
    )
  })
}

function everyId(first: SavedBlock, found: (id: BlockId) => void): void {
  for (const block of stackOf(first)) {
    if (block.id !== undefined) found(block.id)
    for (const {block: inner} of Object.values(block.inputs ?? {}))
      if (inner !== undefined) everyId(inner, found)
    for (const inner of Object.values(foldedIn(block.extraState))) everyId(inner, found)
  }
}

function stackOf(first: SavedBlock): SavedBlock[] {
  const blocks: SavedBlock[] = []
  for (let b: SavedBlock | undefined = first; b !== undefined; b = b.next?.block) blocks.push(b)
  return blocks
}

function alone({next: _, ...block}: SavedBlock): SavedBlock {
  return block
}
