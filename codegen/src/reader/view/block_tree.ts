/// Block tree of a definition that was read from text, with the text span of each block.

import {blockView} from "../../blocks/block_registry.ts"
import {Writer} from "../../blocks/block_writer.ts"
import {fold} from "../../blocks/folding.ts"
import {childrenOf} from "../../model/child_nodes.ts"
import {reasons} from "../../model/raw_reasons.ts"
import type {Node} from "../../model/syntax_tree.ts"
import type {BlockId, SavedBlock} from "../../serialized_blocks.ts"
import type {Range} from "../../source/lexer.ts"
import type {Piece} from "../module/module_pieces.ts"

/// A stretch of a definition's text, counted from its start, and the block (or empty socket) it belongs to.
export interface BlockSpan extends Range {
  readonly block: BlockId
  readonly input: string | undefined
}

export interface BuiltBlocks {
  readonly block: SavedBlock
  readonly spans: readonly BlockSpan[]
}

/// `own`: the names that the program defines.
export function buildBlocks(
  piece: Piece,
  newId: () => BlockId,
  own: ReadonlySet<string> = new Set(),
): BuiltBlocks | undefined {
  const {declaration} = piece
  if (declaration === undefined) return undefined
  const nodes = new Map<BlockId, Node>()
  const writer = new Writer(node => {
    const id = newId()
    nodes.set(id, node)
    return id
  }, own)
  const block = writer.declaration(declaration)
  const text = piece.slice.slice(piece.core.start - piece.start, piece.core.end - piece.start)
  const spans: BlockSpan[] = []
  const visit = (b: SavedBlock): void => {
    const node = nodes.get(b.id ?? "")
    const span = node === undefined ? undefined : piece.spans.get(node)
    if (b.id !== undefined && node !== undefined && span !== undefined) {
      spans.push({...span, block: b.id, input: undefined})
      spans.push(...emptySockets(b, node, piece))
      if (b.type.startsWith("raw_") && !node.kind.startsWith("raw"))
        b.extraState = {
          text: exactly(text, span),
          reason: node.kind === "function" ? reasons.guards : reasons.expression,
        }
    }
    for (const input of Object.values(b.inputs ?? {}))
      for (let inner = input.block; inner !== undefined; inner = inner.next?.block) visit(inner)
  }
  visit(block)
  // A folded block is not drawn: its text belongs to the block that holds it.
  const holders = new Map<BlockId, BlockId>()
  const folded = fold(block, blockView, holders)
  if (holders.size === 0) return {block: folded, spans}
  const drawn = (id: BlockId): BlockId => {
    const holder = holders.get(id)
    return holder === undefined ? id : drawn(holder)
  }
  return {
    block: folded,
    spans: spans.map(s => (holders.has(s.block) ? {...s, block: drawn(s.block), input: undefined} : s)),
  }
}

/// A hole in the text has no block; it is the socket of the block around it.
function emptySockets(block: SavedBlock, node: Node, piece: Piece): BlockSpan[] {
  const holes = childrenOf(node).filter(c => c.kind === "hole")
  if (holes.length === 0) return []
  const sockets: string[] = []
  for (const row of blockView(block.type)?.shape(block.extraState ?? {}).rows ?? [])
    for (const item of row)
      if (item.kind === "socket" && block.inputs?.[item.name]?.block === undefined) sockets.push(item.name)
  if (sockets.length !== holes.length) return []
  return holes.flatMap((hole, i) => {
    const span = piece.spans.get(hole)
    return span === undefined ? [] : [{...span, block: block.id ?? "", input: sockets[i]}]
  })
}

/// The text of a node that the model can say and blocks cannot, moved to the margin.
function exactly(text: string, span: Range): string {
  const column = span.start - (text.lastIndexOf("\n", span.start - 1) + 1)
  const [first = "", ...others] = text.slice(span.start, span.end).split(/\r?\n/)
  const least = Math.min(
    column,
    ...others.filter(l => l.trim() !== "").map(l => l.length - l.trimStart().length),
  )
  return [first, ...others.map(l => l.slice(Math.min(least, l.length - l.trimStart().length)))].join("\n")
}
