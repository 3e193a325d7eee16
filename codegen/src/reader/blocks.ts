/// A definition read from text as a tree of blocks, and which text each block stands for.

import {blockView} from "../blocks/language.ts"
import {Writer} from "../blocks/write.ts"
import {childrenOf} from "../model/children.ts"
import type {Node} from "../model/tree.ts"
import type {BlockId, SavedBlock} from "../saved.ts"
import type {Range} from "./lexer.ts"
import type {Piece} from "./module.ts"
import {reasons} from "./reasons.ts"

/// A stretch of a definition's text, counted from its start, and the block (or empty socket) it belongs to.
export interface BlockSpan extends Range {
  readonly block: BlockId
  readonly input: string | undefined
}

export interface Built {
  readonly block: SavedBlock
  readonly spans: readonly BlockSpan[]
}

export function buildBlocks(piece: Piece, newId: () => BlockId): Built | undefined {
  const {declaration} = piece
  if (declaration === undefined) return undefined
  const nodes = new Map<BlockId, Node>()
  const writer = new Writer(node => {
    const id = newId()
    nodes.set(id, node)
    return id
  })
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
  return {block, spans}
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
