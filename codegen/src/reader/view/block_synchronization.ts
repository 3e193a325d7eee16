/// Synchronization after blocks changed: the next view of a program from a workspace. Only definitions that say something else are written.
///
/// A definition whose text has a syntax error shows its last whole blocks, dimmed. An edit of those is applied to the readable parts of the text, and the
/// unfinished part stays. Where that is not possible the whole edit is refused.

import {chain, readTree} from "../../blocks/block_reader.ts"
import {blockView} from "../../blocks/block_registry.ts"
import {hasUnknowns} from "../../model/holes.ts"
import {causeOf} from "../../model/raw_reasons.ts"
import type {Declaration} from "../../model/syntax_tree.ts"
import type {BlockId, SavedBlock, SavedWorkspace} from "../../serialized_blocks.ts"
import {derivable} from "../../types/environment/declared_types.ts"
import {derivingNeeds, withSignatures} from "../../workspace/inference/code_generation.ts"
import {InferenceSession} from "../../workspace/inference/inference_session.ts"
import {inferWorkspace} from "../../workspace/inference/workspace_inference.ts"
import type {Module, Piece} from "../module/module_pieces.ts"
import {sameFixities} from "../module/module_pieces.ts"
import type {Reader} from "../module/module_reader.ts"
import type {ExactCount} from "../printing/exact_texts.ts"
import {exactTexts} from "../printing/exact_texts.ts"
import {meaningOf} from "../printing/model_parts.ts"
import {writeBack} from "../printing/text_patches.ts"
import {mergeTrees} from "./block_merge.ts"
import {buildBlocks} from "./block_tree.ts"
import {isSaidBy, isUnfinished, textsIn} from "./correspondence.ts"
import type {Renames} from "./export_list.ts"
import {renamedExports, renamesBetween} from "./export_list.ts"
import {advance, firstFree} from "./text_synchronization.ts"
import {hashTree, transferIdentity} from "./tree_matching.ts"
import type {Shown, View} from "./view.ts"
import {definedIn, headerOf, pieceText, workspaceOf} from "./view.ts"

/// The view after blocks were edited: `workspace` is all that is on the page now. Its `refused` names definitions with unfinished text that the edit
/// would have lost, or definitions that the new text would not say as the blocks do; then nothing else is changed. `count`, when given, counts how the changed definitions were written.
export function syncBlocks(
  reader: Reader,
  before: View,
  workspace: SavedWorkspace,
  {count}: {readonly count?: ExactCount} = {},
): View {
  const {refused: _, inexpressible: __, remade: ___, ...view} = before
  const tops = workspace.blocks.blocks
  const loose = tops.filter(b => blockView(b.type)?.meaning.as !== "definition")
  const now = tops
    .filter(b => blockView(b.type)?.meaning.as === "definition")
    .flatMap(top => chain(top).map((b, i) => alone(b, top, i)))
  const {found, added} = pairedWith(view, now)
  const changed = view.declarations.filter(s => {
    const b = found.get(s)
    // The very same value says the same; to compare thousands of blocks at each edit would be felt.
    return b === undefined || (b !== s.block && hashTree(b, true) !== hashTree(s.block, true))
  })
  let nextId = Math.max(view.nextId, firstFree(tops))
  const newId = (): BlockId => `t${nextId++}`
  const refused: string[] = []
  for (const s of changed) {
    const b = found.get(s)
    if (b === undefined || !s.dimmed) continue
    const outside = [...now, ...loose].filter(other => other !== b)
    const merged = mergedWithText(view, s, b, outside, newId)
    if (merged === undefined) refused.push(s.name)
    else found.set(s, merged)
  }
  if (refused.length > 0) return {...view, refused}
  if (changed.length === 0 && added.length === 0)
    return {
      ...view,
      loose,
      nextId,
      declarations: view.declarations.map(s => ({...s, block: found.get(s) ?? s.block})),
    }

  const putBack = earlierView(view, now)
  if (putBack !== undefined)
    return {
      ...withBlocks(putBack, now),
      loose,
      gone: view.gone,
      nextId: Math.max(nextId, putBack.nextId),
      earlier: earlierOf(view),
    }

  // A type whose values the edit shows or compares for the first time derives the class, in the text and in its blocks.
  const deriving = derivingOf(reader, view, workspace)
  for (const s of view.declarations) {
    const b = found.get(s)
    const classes = b === undefined || s.dimmed ? undefined : deriving.get(b.id)
    if (b === undefined || classes === undefined) continue
    found.set(s, withClasses(b, classes))
    if (!changed.includes(s)) changed.push(s)
  }
  const declared = printable(workspace, view)
  const edits = new Map<number, Declaration | undefined>()
  for (const s of changed) {
    const b = found.get(s)
    edits.set(s.piece, b === undefined ? undefined : declared(b, view.module.pieces[s.piece]))
  }
  const renames = renamesBetween(
    changed.flatMap(s => {
      const [before, now] = [view.module.pieces[s.piece]?.declaration, edits.get(s.piece)]
      return before === undefined || now === undefined ? [] : [[before, now] as const]
    }),
  )
  const module = withRenamedExports(view.module, renames)
  const completed = added.map(b => {
    const classes = deriving.get(b.id)
    return classes === undefined ? b : withClasses(b, classes)
  })
  const fresh = completed.map(b => declared(b, undefined))
  const text = writeBack(module, {
    pieces: edits,
    exact: exactTexts(reader, view.module, edits, count),
    added: fresh,
  })
  const kept = view.declarations.flatMap(s => {
    const b = found.get(s)
    return b === undefined ? [] : [{...s, block: b, dimmed: s.dimmed && !changed.includes(s)}]
  })
  const settled = settle(reader, {...view, loose, nextId}, text, kept, completed, new Set(changed))
  const unwritten = [
    ...changed.map(s => ({
      block: found.get(s),
      declaration: edits.get(s.piece),
      before: view.module.pieces[s.piece],
    })),
    ...completed.map((block, i) => ({block, declaration: fresh[i], before: undefined})),
  ].filter(edit => !isWritten(settled, edit))
  if (unwritten.length === 0)
    return {...settled, ...(deriving.size === 0 ? {} : {remade: true}), earlier: earlierOf(view)}
  return {...view, refused: unwritten.map(({block}) => (block && nameOf(block)) ?? "_"), inexpressible: true}
}

/// The blocks that show a definition of the view, and those that are new.
function pairedWith(
  view: View,
  blocks: readonly SavedBlock[],
): {readonly found: Map<Shown, SavedBlock>; readonly added: readonly SavedBlock[]} {
  const byId = new Map(view.declarations.map(s => [s.block.id, s]))
  const found = new Map<Shown, SavedBlock>()
  const added: SavedBlock[] = []
  for (const b of blocks) {
    const shown = byId.get(b.id)
    if (shown === undefined || found.has(shown)) added.push(b)
    else found.set(shown, b)
  }
  return {found, added}
}

/// Edits of the blocks whose blocks can be put back.
const mostEarlier = 20

function earlierOf(view: View): readonly View[] {
  const {earlier = [], ...bare} = view
  return [bare, ...earlier].slice(0, mostEarlier)
}

/// The latest view whose definitions are those of the workspace again, after an undo or when a block was moved away and back.
function earlierView({earlier = []}: View, now: readonly SavedBlock[]): View | undefined {
  const byId = new Map(now.map(b => [b.id, b]))
  const known = new Map<SavedBlock, boolean>()
  const isBack = ({block}: Shown): boolean => {
    const b = byId.get(block.id)
    if (b === undefined || b === block) return b === block
    const same = known.get(block) ?? hashTree(b, true) === hashTree(block, true)
    known.set(block, same)
    return same
  }
  return earlier.find(e => e.declarations.length === now.length && e.declarations.every(isBack))
}

/// A view with the same definitions at other places on the page.
function withBlocks(view: View, now: readonly SavedBlock[]): View {
  const byId = new Map(now.map(b => [b.id, b]))
  const declarations = view.declarations.map((s): Shown => {
    const block = byId.get(s.block.id) ?? s.block
    const {ids} = transferIdentity(block, s.block)
    return {...s, block, spans: s.spans.map(x => ({...x, block: ids.get(x.block) ?? x.block}))}
  })
  return {...view, declarations}
}

const sessions = new WeakMap<Reader, InferenceSession>()

/// Classes that types of the program derive once the workspace is as it is now, by the block of the type; only of types that need more than before the edit.
function derivingOf(
  reader: Reader,
  view: View,
  workspace: SavedWorkspace,
): ReadonlyMap<BlockId | undefined, readonly string[]> {
  const mayNeed = (d: Declaration) => d.kind === "data" && derivable.some(c => !d.deriving.includes(c))
  if (!workspace.blocks.blocks.some(b => readTree(b).declarations.some(mayNeed))) return new Map()
  const session = sessions.get(reader) ?? new InferenceSession()
  sessions.set(reader, session)
  const header = headerOf(view)
  const needs = (of: SavedWorkspace) =>
    new Map(
      derivingNeeds(session.inferWorkspace({...of, header})).map(({type, classes}) => [
        type.from?.block,
        classes,
      ]),
    )
  const now = needs(workspace)
  if (now.size === 0) return now
  const before = needs(workspaceOf(view))
  return new Map([...now].filter(([id, classes]) => classes.some(c => before.get(id)?.includes(c) !== true)))
}

function withClasses(block: SavedBlock, classes: readonly string[]): SavedBlock {
  return {...block, extraState: {...block.extraState, deriving: [...classes]}}
}

/// Whether the new text says what an edited block says. Where the edit was in text that blocks keep to the letter, the text decides what there is now.
function isWritten(
  settled: View,
  {
    block,
    declaration,
    before,
  }: {
    readonly block: SavedBlock | undefined
    readonly declaration: Declaration | undefined
    readonly before: Piece | undefined
  },
): boolean {
  if (block === undefined || declaration === undefined) return true
  const known = before?.declaration === undefined ? [] : textsIn(before.declaration)
  if (
    before?.broken === true ||
    isUnfinished(declaration) ||
    textsIn(declaration).some(text => !known.includes(text))
  )
    return true
  const shown = settled.declarations.find(s => s.block.id === block.id)
  const name = nameOf(block)
  const piece =
    settled.module.pieces[shown?.piece ?? -1] ??
    settled.module.pieces.find(p => name !== undefined && p.names[0] === name)
  const read = piece?.declaration
  // What has become too long for blocks is text as a whole.
  if (read?.kind === "raw-declaration" && causeOf(read.reason) === "large") return true
  return piece !== undefined && isSaidBy(declaration, piece)
}

/// The blocks of a definition's unfinished text with an edit of its last whole blocks; undefined where they do not go together.
function mergedWithText(
  view: View,
  shown: Shown,
  edited: SavedBlock,
  outside: readonly SavedBlock[],
  newId: () => BlockId,
): SavedBlock | undefined {
  const piece = view.module.pieces[shown.piece]
  const built = piece === undefined ? undefined : buildBlocks(piece, newId, definedIn(view.module))
  if (built === undefined) return undefined
  return mergeTrees(shown.block, edited, transferIdentity(shown.block, built.block).block, outside)
}

/// The module with a header that exports renamed definitions by their new names.
function withRenamedExports(module: Module, renames: Renames): Module {
  if (renames.types.size + renames.values.size === 0) return module
  const pieces = module.pieces.map(p =>
    p.kind === "header" ? {...p, slice: renamedExports(p.slice, renames)} : p,
  )
  return {...module, pieces}
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
  const agrees = (s: Shown, piece: Piece | undefined): boolean =>
    piece !== undefined &&
    (s.dimmed ||
      (!touched.has(s.block.id) && s.piece !== -1
        ? sameText(view.module.pieces[s.piece], piece)
        : saysTheSame(s.block, piece)))
  if (order.length !== pieces.length || !order.every((s, k) => agrees(s, pieces[k]?.piece))) {
    // A text block held something other than one definition, or what was broken swallows its neighbour: the text decides
    // what there is now.
    const from: View = {
      ...view,
      declarations: order.map(s => ({...s, name: nameOf(s.block) ?? s.name, piece: -1})),
    }
    return {...advance(reader, from, text, {}, () => false), remade: true}
  }
  let n = 0
  let nextId = view.nextId
  const own = definedIn(module)
  let remade: true | undefined
  const regroups = !sameFixities(view.module, module)
  const declarations = order.map((s, k): Shown => {
    const {piece, i} = pieces[k] as {piece: Piece; i: number}
    const name = piece.names[0] ?? "_"
    if (s.dimmed) return {...s, name, piece: i}
    const before = view.module.pieces[s.piece]
    const isTouched = touched.has(s.block.id) || s.piece === -1
    const remake = (): Shown | undefined => {
      const built = buildBlocks(piece, () => `t${nextId++}`, own)
      if (built === undefined) return undefined
      remade = true
      const {block, ids} = transferIdentity(s.block, built.block)
      const spans = built.spans.map(x => ({...x, block: ids.get(x.block) ?? x.block}))
      return {name, piece: i, block, dimmed: false, spans}
    }
    // With another fixity the operators of a definition group in another way, and a comment behind a definition that was deleted is now above this one.
    const isOther =
      !isTouched &&
      before !== undefined &&
      ((regroups && saysOther(before, piece)) || pieceText(before) !== pieceText(piece))
    const other = isOther ? remake() : undefined
    if (other !== undefined) return other
    if (s.spans.length > 0 && !isTouched) return {...s, name, piece: i}
    const built = buildBlocks(piece, () => `n${n++}`, own)
    // A comment that the edit has left in the text belongs to another block now.
    if (built !== undefined && commentsOf(built.block) !== commentsOf(s.block)) {
      const again = remake()
      if (again !== undefined) return again
    }
    const ids = built === undefined ? new Map<string, string>() : transferIdentity(s.block, built.block).ids
    const spans = (built?.spans ?? []).flatMap(x => {
      const block = ids.get(x.block)
      return block === undefined ? [] : [{...x, block}]
    })
    return {name, piece: i, block: s.block, dimmed: false, spans}
  })
  return {...view, text, module, declarations, nextId, ...(remade === undefined ? {} : {remade})}
}

/// The words of all comments on a definition's blocks.
function commentsOf(block: SavedBlock): string {
  const below = [...Object.values(block.inputs ?? {}).map(i => i.block), block.next?.block]
  const inner = below.flatMap(b => (b === undefined ? [] : commentsOf(b)))
  return [block.icons?.comment?.text ?? "", ...inner].join(" ").replace(/\s+/g, " ").trim()
}

function saysOther(before: Piece | undefined, now: Piece): boolean {
  return (
    before?.declaration !== undefined &&
    now.declaration !== undefined &&
    meaningOf(before.declaration) !== meaningOf(now.declaration)
  )
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
      const solved = inferWorkspace({...workspace, header: headerOf(view)})
      const all = withSignatures(solved.read.program, solved).declarations
      signed = new Map(all.map(d => [d.from?.block, d]))
    }
    return signed.get(id)
  }
  const elsewhere = new Set(
    view.module.pieces.flatMap(p =>
      p.declaration?.kind === "raw-declaration" && /^[^=]*(?:::|∷)/.test(p.declaration.text)
        ? (p.declaration.text.split(/::|∷/)[0] ?? "")
            .split(",")
            .map(n => n.trim().replace(/^\((.*)\)$/, "$1"))
        : [],
    ),
  )
  return (block, piece) => {
    const [own] = readTree(block).declarations
    if (own === undefined) return {kind: "raw-declaration", text: ""}
    // Text that was complete without a signature stays so; one that had empty sockets could not have it yet.
    const was = piece?.declaration
    // What is unfinished gets no type: it would be the type of a part.
    if (piece?.broken === true) return own
    const hadNone = was?.kind === "function" && was.signature === undefined && !hasUnknowns(was)
    // The block of `main` always knows its type; text that does not say it stays so.
    if (
      own.kind === "function" &&
      own.name === "main" &&
      was?.kind === "function" &&
      was.signature === undefined
    )
      return {...own, signature: undefined}
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
