/// Synchronization after the text changed: the next view of a program from new text.
///
/// Unchanged definitions keep their blocks, changed ones are matched with what they were, a broken one keeps its last good blocks, dimmed.
/// Nothing that the learner placed moves.

import type {LaidOut} from "../../api.ts"
import {chain, readTree} from "../../blocks/block_reader.ts"
import {blockView} from "../../blocks/block_registry.ts"
import {foldedIn, isDrawableIn} from "../../blocks/folding.ts"
import {printDeclarationAlone} from "../../haskell/printer.ts"
import {causeOf} from "../../model/raw_reasons.ts"
import type {Declaration} from "../../model/syntax_tree.ts"
import type {BlockId, SavedBlock} from "../../serialized_blocks.ts"
import {hashOf} from "../../source/declaration_splitter.ts"
import type {Module, Piece} from "../module/module_pieces.ts"
import type {Reader} from "../module/module_reader.ts"
import {place} from "./block_placement.ts"
import type {BuiltBlocks} from "./block_tree.ts"
import {buildBlocks} from "./block_tree.ts"
import {partnersOf} from "./definition_matching.ts"
import {hashTree, transferIdentity} from "./tree_matching.ts"
import type {Shown, View, ViewOptions} from "./view.ts"
import {definedIn, pieceText} from "./view.ts"

/// How many definitions are remembered after they left the text.
const remembered = 40

/// The view of a text, with the blocks of a saved layout where they still fit.
export function openView(
  reader: Reader,
  text: string,
  layout: {readonly declarations: readonly LaidOut[]; readonly loose: readonly SavedBlock[]} = {
    declarations: [],
    loose: [],
  },
  options: ViewOptions = {},
): View {
  const nothing = reader.read("")
  const loose = layout.loose.filter(isDrawable)
  // Blocks that do not fit their own shapes would be lost on the page; theirs are made anew from the text.
  const usable = layout.declarations.filter(d => isDrawable(d.blocks))
  const old = usable.map(
    (d, i): Shown => ({name: d.name, piece: -1 - i, block: d.blocks, dimmed: false, spans: []}),
  )
  const from: View = {
    text: "",
    module: nothing,
    declarations: old,
    loose,
    gone: [],
    nextId: firstFree([...old.map(o => o.block), ...loose]),
  }
  const hashes = new Map(usable.map((d, i) => [old[i], d.hash]))
  return advance(
    reader,
    from,
    text,
    options,
    (shown, piece) => hashes.get(shown) === hashOf(pieceText(piece)),
    true,
  )
}

function isDrawable(block: SavedBlock): boolean {
  return isDrawableIn(block, blockView)
}

/// The view after the text was edited.
export function syncText(reader: Reader, view: View, text: string, options: ViewOptions = {}): View {
  if (text === view.text) return view
  return advance(reader, view, text, options, (shown, piece) => {
    const before = view.module.pieces[shown.piece]
    return before !== undefined && !shown.dimmed && before.declaration === piece.declaration
  })
}

export function advance(
  reader: Reader,
  view: View,
  text: string,
  options: ViewOptions,
  unchanged: (shown: Shown, piece: Piece) => boolean,
  isInOrder = false,
): View {
  const module = reader.read(text)
  const pieces = module.pieces.flatMap((piece, i) => (piece.declaration === undefined ? [] : [{piece, i}]))
  const {partners, left} = partnersOf(
    pieces.map(p => p.piece),
    view,
    unchanged,
    isInOrder,
  )
  let nextId = view.nextId
  const newId = (): BlockId => `t${nextId++}`
  const own = definedIn(module)
  const contradicted: string[] = []
  const shown = pieces.map(({piece, i}, n): Shown => {
    const partner = partners[n]
    const name = piece.names[0] ?? partner?.shown.name ?? "_"
    if (partner !== undefined && piece.broken) {
      // A definition that was never whole has the text of its error as a block; there is nothing better to keep.
      if (partner.shown.dimmed || !isBrokenIn(partner.shown.block))
        return {...partner.shown, name, piece: i, dimmed: true, spans: []}
    }
    if (partner?.same === true && partner.shown.spans.length > 0) return {...partner.shown, name, piece: i}
    const built = buildBlocks(piece, newId, own) as BuiltBlocks
    if (partner === undefined) return {name, piece: i, block: built.block, dimmed: false, spans: built.spans}
    const {block, ids} = transferIdentity(partner.shown.block, built.block)
    const agrees = partner.same && printsTheSame(partner.shown.block, built.block, module)
    // A place that may stay empty, as that of a pattern, has text and no block.
    const spans = built.spans.flatMap(s =>
      agrees && !ids.has(s.block) ? [] : [{...s, block: ids.get(s.block) ?? s.block}],
    )
    if (partner.same && !agrees) contradicted.push(name)
    const kept = agrees ? {...partner.shown.block} : block
    return {name, piece: i, block: kept, dimmed: false, spans}
  })
  const placed = place([...shown.map(s => s.block), ...view.loose], options.size)
  return {
    text,
    module,
    declarations: shown.map((s, i) => ({...s, block: placed[i] ?? s.block})),
    loose: view.loose,
    // Their numbers are of a text that is no more.
    gone: left.slice(0, remembered).map(s => ({...s, piece: -1})),
    nextId,
    ...(contradicted.length === 0 ? {} : {contradicted}),
  }
}

/// Whether a definition's blocks were read from broken text.
function isBrokenIn(block: SavedBlock): boolean {
  if (block.type === "raw_definition") return true
  if (block.type.startsWith("raw_") && causeOf(String(block.extraState?.reason)) === "broken") return true
  const inside = [...Object.values(block.inputs ?? {}).map(i => i.block), block.next?.block]
  return inside.some(b => b !== undefined && isBrokenIn(b))
}

/// Whether two block trees print the same definition. A saved tree comes from a file, so its hash is not trusted.
function printsTheSame(saved: SavedBlock, built: SavedBlock, module: Module): boolean {
  if (hashTree(saved, true) === hashTree(built, true)) return true
  const own = readTree(saved).declarations
  const read = readTree(built).declarations
  const print = (d: Declaration): string => printDeclarationAlone(d, module.fixities)
  return (
    own.length === read.length &&
    own.every((d, i) => print(d) === print(withoutInferred(read[i] as Declaration, d)))
  )
}

/// What the text says, without the signature and the classes that printing adds to blocks that lack them.
function withoutInferred(read: Declaration, own: Declaration): Declaration {
  if (read.kind === "function" && own.kind === "function" && own.signature === undefined) {
    const {signature: _, ...rest} = read
    return rest
  }
  if (read.kind === "data" && own.kind === "data" && own.deriving.every(c => read.deriving.includes(c)))
    return {...read, deriving: own.deriving}
  return read
}

/// The first number above all `t12` in use.
export function firstFree(blocks: readonly SavedBlock[]): number {
  let free = 1
  for (const block of blocks) {
    let own = freeAbove.get(block)
    if (own === undefined) {
      own = firstFreeIn(block)
      freeAbove.set(block, own)
    }
    free = Math.max(free, own)
  }
  return free
}

/// Of blocks with what follows them: a saved block does not change, and thousands of others are the same after an edit.
const freeAbove = new WeakMap<SavedBlock, number>()

function firstFreeIn(top: SavedBlock): number {
  let free = 1
  const visit = (b: SavedBlock): void => {
    const n = /^t(\d{1,9})$/.exec(b.id ?? "")?.[1]
    if (n !== undefined) free = Math.max(free, Number(n) + 1)
    for (const input of Object.values(b.inputs ?? {}))
      for (const first of [input.block, input.shadow]) if (first !== undefined) chain(first).forEach(visit)
    for (const first of Object.values(foldedIn(b.extraState))) chain(first).forEach(visit)
  }
  chain(top).forEach(visit)
  return free
}
