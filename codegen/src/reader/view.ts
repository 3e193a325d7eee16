/// A program as text and as blocks at once, and how an edit of one side reaches the other.
///
/// A view is a value. `syncText` makes the next one from new text: unchanged definitions keep their blocks, changed ones are matched
/// with what they were, a broken one keeps its last good blocks, dimmed. `syncBlocks` makes the next one from new blocks: only definitions that
/// say something else are printed. Nothing that the learner placed moves.

import type {LaidOut, PrintedProgram} from "../api.ts"
import {blockView} from "../blocks/language.ts"
import {chain, readTree} from "../blocks/read.ts"
import {hashOf} from "../haskell/split.ts"
import {hasUnknowns} from "../model/holes.ts"
import type {Declaration} from "../model/tree.ts"
import type {BlockId, SavedBlock, SavedWorkspace} from "../saved.ts"
import {withSignatures} from "../workspace/haskell.ts"
import {solve} from "../workspace/infer.ts"
import type {BlockSpan, Built} from "./blocks.ts"
import {buildBlocks} from "./blocks.ts"
import type {Module, Piece, Reader} from "./module.ts"
import type {Size} from "./place.ts"
import {place} from "./place.ts"
import {carryOver, hashTree, likeness} from "./trees.ts"
import {writeBack} from "./writeback.ts"

/// One definition, as text and as blocks.
export interface Shown {
  /// What the layout calls it: the first name it defines, or `_`.
  readonly name: string
  /// Its number in `module.pieces`.
  readonly piece: number
  readonly block: SavedBlock
  /// Its text is broken; these are the blocks it had before.
  readonly dimmed: boolean
  /// Which text each block stands for, counted from the definition's start. Empty while dimmed.
  readonly spans: readonly BlockSpan[]
}

export interface View {
  readonly text: string
  readonly module: Module
  /// In the order of the text.
  readonly declarations: readonly Shown[]
  /// Blocks that belong to no definition.
  readonly loose: readonly SavedBlock[]
  /// Definitions that left the text lately; their blocks come back if they do.
  readonly gone: readonly Shown[]
  /// The next new block is called `t` and this number.
  readonly nextId: number
}

export interface ViewOptions {
  /// How large a block is on the page; without it, sizes are guessed.
  readonly size?: (block: SavedBlock) => Size
}

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
  const old = layout.declarations.map(
    (d, i): Shown => ({name: d.name, piece: -1 - i, block: d.blocks, dimmed: false, spans: []}),
  )
  const from: View = {
    text: "",
    module: nothing,
    declarations: old,
    loose: layout.loose,
    gone: [],
    nextId: firstFree([...old.map(o => o.block), ...layout.loose]),
  }
  const hashes = new Map(layout.declarations.map((d, i) => [old[i], d.hash]))
  return advance(
    reader,
    from,
    text,
    options,
    (shown, piece) => hashes.get(shown) === hashOf(pieceText(piece)),
  )
}

/// The view after the text was edited.
export function syncText(reader: Reader, view: View, text: string, options: ViewOptions = {}): View {
  if (text === view.text) return view
  return advance(reader, view, text, options, (shown, piece) => {
    const before = view.module.pieces[shown.piece]
    return before !== undefined && !shown.dimmed && before.declaration === piece.declaration
  })
}

/// The definition with the comment above it, as the layout's hash counts it.
export function pieceText(piece: Piece): string {
  return piece.slice.slice((piece.remark ?? piece.core).start - piece.start, piece.core.end - piece.start)
}

function advance(
  reader: Reader,
  view: View,
  text: string,
  options: ViewOptions,
  unchanged: (shown: Shown, piece: Piece) => boolean,
): View {
  const module = reader.read(text)
  const pieces = module.pieces.flatMap((piece, i) => (piece.declaration === undefined ? [] : [{piece, i}]))
  const {partners, left} = partnersOf(
    pieces.map(p => p.piece),
    view,
    unchanged,
  )
  let nextId = view.nextId
  const newId = (): BlockId => `t${nextId++}`
  const shown = pieces.map(({piece, i}, n): Shown => {
    const partner = partners[n]
    const name = piece.names[0] ?? partner?.shown.name ?? "_"
    if (partner !== undefined && piece.broken) {
      // A definition that was never whole has its text as its block; there is nothing better to keep.
      if (partner.shown.dimmed || partner.shown.block.type !== "raw_definition")
        return {...partner.shown, name, piece: i, dimmed: true, spans: []}
    }
    if (partner?.same === true && partner.shown.spans.length > 0) return {...partner.shown, name, piece: i}
    const built = buildBlocks(piece, newId) as Built
    if (partner === undefined) return {name, piece: i, block: built.block, dimmed: false, spans: built.spans}
    const {block, ids} = carryOver(partner.shown.block, built.block)
    const spans = built.spans.map(s => ({...s, block: ids.get(s.block) ?? s.block}))
    const kept = partner.same ? {...partner.shown.block} : block
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
  }
}

interface Partner {
  readonly shown: Shown
  /// Its text is what it was.
  readonly same: boolean
}

/// For each definition of the new text the one that it was: by its text, then by its name, then by its place among the others.
function partnersOf(
  pieces: readonly Piece[],
  view: View,
  unchanged: (shown: Shown, piece: Piece) => boolean,
): {partners: readonly (Partner | undefined)[]; left: readonly Shown[]} {
  const free = new Set([...view.declarations, ...view.gone])
  const partners: (Partner | undefined)[] = pieces.map(() => undefined)
  const byName = new Map<string, Shown[]>()
  for (const s of free) byName.set(s.name, [...(byName.get(s.name) ?? []), s])
  const take = (i: number, shown: Shown, same: boolean): void => {
    free.delete(shown)
    partners[i] = {shown, same}
  }
  const named = (piece: Piece): Shown[] => byName.get(piece.names[0] ?? "_")?.filter(s => free.has(s)) ?? []
  pieces.forEach((piece, i) => {
    const found = named(piece).find(s => unchanged(s, piece))
    if (found !== undefined) take(i, found, true)
  })
  pieces.forEach((piece, i) => {
    const [found] = partners[i] === undefined && piece.names.length > 0 ? named(piece) : []
    if (found !== undefined) take(i, found, false)
  })
  // A definition whose name was edited stands between the same neighbours.
  const current = view.declarations
  pieces.forEach((piece, i) => {
    if (partners[i] !== undefined) return
    const above = i === 0 ? -1 : current.indexOf(partners[i - 1]?.shown as Shown)
    if (i > 0 && above === -1) return
    const candidate = current[above + 1]
    if (candidate === undefined || !free.has(candidate)) return
    if (piece.broken || isLike(piece, candidate)) take(i, candidate, false)
  })
  return {partners, left: [...free]}
}

function isLike(piece: Piece, shown: Shown): boolean {
  let n = 0
  const built = buildBlocks(piece, () => `n${n++}`)
  return built !== undefined && likeness(shown.block, built.block) >= 0.4
}

/// The view after blocks were edited: `workspace` is all that is on the page now.
export function syncBlocks(reader: Reader, view: View, workspace: SavedWorkspace): View {
  const tops = workspace.blocks.blocks
  const loose = tops.filter(b => blockView(b.type)?.meaning.as !== "definition")
  const now = tops
    .filter(b => blockView(b.type)?.meaning.as === "definition")
    .flatMap(top => chain(top).map((b, i) => alone(b, top, i)))
  const byId = new Map(view.declarations.map(s => [s.block.id, s]))
  const found = new Map<Shown, SavedBlock>()
  const added: SavedBlock[] = []
  for (const b of now) {
    const shown = byId.get(b.id)
    if (shown === undefined || found.has(shown)) added.push(b)
    else found.set(shown, b)
  }
  const changed = view.declarations.filter(s => {
    const b = found.get(s)
    // The very same value says the same; to compare thousands of blocks at each edit would be felt.
    return b === undefined || (b !== s.block && hashTree(b, true) !== hashTree(s.block, true))
  })
  const nextId = Math.max(view.nextId, firstFree(tops))
  if (changed.length === 0 && added.length === 0)
    return {
      ...view,
      loose,
      nextId,
      declarations: view.declarations.map(s => ({...s, block: found.get(s) ?? s.block})),
    }

  const declared = printable(workspace, view)
  const edits = new Map<number, Declaration | undefined>()
  for (const s of changed) {
    const b = found.get(s)
    edits.set(s.piece, b === undefined ? undefined : declared(b, view.module.pieces[s.piece]))
  }
  const text = writeBack(view.module, {pieces: edits, added: added.map(b => declared(b, undefined))})
  const kept = view.declarations.flatMap(s => {
    const b = found.get(s)
    return b === undefined ? [] : [{...s, block: b, dimmed: s.dimmed && !changed.includes(s)}]
  })
  return settle(reader, {...view, loose, nextId}, text, kept, added, new Set(changed))
}

/// The new text is read for its places; the blocks stay what the learner made them.
function settle(
  reader: Reader,
  view: View,
  text: string,
  kept: readonly Shown[],
  added: readonly SavedBlock[],
  changed: ReadonlySet<Shown>,
): View {
  const module = reader.read(text)
  const pieces = module.pieces.flatMap((piece, i) => (piece.declaration === undefined ? [] : [{piece, i}]))
  const touched = new Set([...changed].map(s => s.block.id))
  const fresh = added.map((block): Shown => ({name: "_", piece: -1, block, dimmed: false, spans: []}))
  const last = kept[kept.length - 1]
  const beforeMain = last !== undefined && view.module.pieces[last.piece]?.names[0] === "main"
  const order = beforeMain ? [...kept.slice(0, -1), ...fresh, last] : [...kept, ...fresh]
  const said = (s: Shown, piece: Piece | undefined): boolean =>
    piece !== undefined &&
    (s.dimmed ||
      (!touched.has(s.block.id) && s.piece !== -1
        ? sameText(view.module.pieces[s.piece], piece)
        : saysTheSame(s.block, piece)))
  if (order.length !== pieces.length || !order.every((s, k) => said(s, pieces[k]?.piece))) {
    // A text block held something other than one definition, or what was broken swallows its neighbour: the text decides
    // what there is now.
    const from: View = {
      ...view,
      declarations: order.map(s => ({...s, name: nameOf(s.block) ?? s.name, piece: -1})),
    }
    return advance(reader, from, text, {}, () => false)
  }
  let n = 0
  const declarations = order.map((s, k): Shown => {
    const {piece, i} = pieces[k] as {piece: Piece; i: number}
    const name = piece.names[0] ?? "_"
    if (s.dimmed) return {...s, name, piece: i}
    if (s.spans.length > 0 && !touched.has(s.block.id)) return {...s, name, piece: i}
    const built = buildBlocks(piece, () => `n${n++}`)
    const ids = built === undefined ? new Map<string, string>() : carryOver(s.block, built.block).ids
    const spans = (built?.spans ?? []).flatMap(x => {
      const block = ids.get(x.block)
      return block === undefined ? [] : [{...x, block}]
    })
    return {name, piece: i, block: s.block, dimmed: false, spans}
  })
  return {...view, text, module, declarations}
}

function sameText(before: Piece | undefined, now: Piece): boolean {
  const core = (p: Piece) => p.slice.slice(p.core.start - p.start, p.core.end - p.start)
  return (
    before !== undefined && before.declaration?.kind === now.declaration?.kind && core(before) === core(now)
  )
}

/// A block and the text that was printed from it are about one and the same definition.
function saysTheSame(block: SavedBlock, {declaration: read}: Piece): boolean {
  const [own] = readTree(block).declarations
  if (own === undefined || read === undefined || own.kind !== read.kind) return false
  return own.kind !== "raw-declaration" || (read.kind === "raw-declaration" && own.text === read.text)
}

/// A block's definition as it should be printed: with the inferred type where there was no text before, as it was where there was.
function printable(
  workspace: SavedWorkspace,
  view: View,
): (block: SavedBlock, piece: Piece | undefined) => Declaration {
  let signed: ReadonlyMap<BlockId | undefined, Declaration> | undefined
  const inferred = (id: BlockId | undefined): Declaration | undefined => {
    if (signed === undefined) {
      const solved = solve({...workspace, header: headerOf(view)})
      const all = withSignatures(solved.read.program, solved).declarations
      signed = new Map(all.map(d => [d.from?.block, d]))
    }
    return signed.get(id)
  }
  const elsewhere = new Set(
    view.module.pieces.flatMap(p =>
      p.declaration?.kind === "raw-declaration" && /^[^=]*::/.test(p.declaration.text)
        ? (p.declaration.text.split("::")[0] ?? "").split(",").map(n => n.trim().replace(/^\((.*)\)$/, "$1"))
        : [],
    ),
  )
  return (block, piece) => {
    const [own] = readTree(block).declarations
    if (own === undefined) return {kind: "raw-declaration", text: ""}
    // Text that was complete without a signature stays so; one that had empty sockets could not have it yet.
    const was = piece?.declaration
    const hadNone = was?.kind === "function" && was.signature === undefined && !hasUnknowns(was)
    if (own.kind !== "function" || own.signature !== undefined || hadNone || elsewhere.has(own.name))
      return own
    return inferred(block.id) ?? own
  }
}

/// A definition of a stack by itself; those below the first get places of their own.
function alone(block: SavedBlock, top: SavedBlock, i: number): SavedBlock {
  if (i === 0 && block.next === undefined) return block
  const {next: _, ...rest} = block
  return i === 0 ? rest : {...rest, x: top.x ?? 0, y: (top.y ?? 0) + 80 * i}
}

function nameOf(block: SavedBlock): string | undefined {
  const [d] = readTree(block).declarations
  return d?.kind === "function" || d?.kind === "data" || d?.kind === "synonym" ? d.name : undefined
}

/// The first number above all `t12` in use.
function firstFree(blocks: readonly SavedBlock[]): number {
  let free = 1
  const visit = (b: SavedBlock): void => {
    const n = /^t(\d{1,9})$/.exec(b.id ?? "")?.[1]
    if (n !== undefined) free = Math.max(free, Number(n) + 1)
    for (const input of Object.values(b.inputs ?? {})) {
      if (input.block !== undefined) visit(input.block)
      if (input.shadow !== undefined) visit(input.shadow)
    }
    if (b.next?.block !== undefined) visit(b.next.block)
  }
  blocks.forEach(visit)
  return free
}

// --- What the page and the project file need ---------------------------------------------------------------------

/// All blocks, as Blockly loads them.
export function workspaceOf(view: View): SavedWorkspace {
  const header = headerOf(view)
  return {
    ...(header === "" ? {} : {header}),
    blocks: {languageVersion: 0, blocks: [...view.declarations.map(s => s.block), ...view.loose]},
  }
}

/// What the text says above its definitions.
function headerOf(view: View): string {
  return view.module.pieces
    .flatMap(p => (p.kind === "header" ? [p.slice] : []))
    .join("")
    .trim()
}

/// The layout to save beside the text.
export function layoutOf(view: View): {declarations: LaidOut[]; loose: readonly SavedBlock[]} {
  return {
    declarations: view.declarations.map(s => {
      const piece = view.module.pieces[s.piece]
      // Blocks of a broken text do not say what it says.
      const hash = piece === undefined || s.dimmed ? "" : hashOf(pieceText(piece))
      return {name: s.name, hash, blocks: s.block}
    }),
    loose: view.loose,
  }
}

/// The text with the place of each block in it, for `blockAt`, `spanOf` and `spanOfSocket`.
export function spansOf(view: View): PrintedProgram {
  const spans = view.declarations.flatMap(s => {
    const start = view.module.pieces[s.piece]?.core.start ?? 0
    return s.spans.map(x => ({start: start + x.start, end: start + x.end, block: x.block, input: x.input}))
  })
  return {text: view.text, spans}
}
