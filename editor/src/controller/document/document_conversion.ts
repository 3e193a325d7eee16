/// Conversion between project files, Haskell, blocks and the document that the page shows. Text and blocks are synchronized by codegen's `View`; each document has its
/// own, so that undo is exact.

import {
  type BlockProblem,
  type Inference,
  infer,
  type NodePlaces,
  newProject,
  newWorkspace,
  type Project,
  parseProject,
  type SavedBlock,
  type SavedWorkspace,
  saveProject,
  toHaskell,
} from "@rosy/codegen"
import {
  contradictionNotice,
  layoutOf,
  openView,
  type Reader,
  sameFixities,
  spansOf,
  syncBlocks,
  syncText,
  type View,
  workspaceOf,
} from "@rosy/codegen/reader"
import {withoutMark} from "@rosy/codegen/text-file"
import type {Document} from "../../program/history.ts"
import {
  blockFinding,
  type Definition,
  type Families,
  type Finding,
  mapRange,
  noFamilies,
  type Span,
  textRangeOf,
} from "../../program/program.ts"
import type {ChangeDesc} from "../../program/text_changes.ts"
import {parseJson} from "../../wire/decode.ts"
import type {WorldFile} from "../../worlds/world.ts"
import {readWorld} from "../../worlds/world_decoder.ts"
import {normalizeLineEndings, withLineEndingsOf} from "./line_endings.ts"

/// A program as it comes from a file.
export interface OpenedProject {
  readonly project: Project
  readonly document: Document
  readonly world: string | WorldFile | null
  readonly isNew: boolean
}

export type Opening =
  /// `notice` tells that the layout was damaged or said something else than the text; the program is complete.
  | {
      readonly kind: "opened"
      readonly opened: OpenedProject
      readonly notice: {readonly message: string; readonly hint: string} | undefined
    }
  | {readonly kind: "unreadable"; readonly message: string; readonly hint: string}

/// Letters of a program that the service takes (protocol §3).
export const longestProgram = 200_000

/// Opens the text of a project file; `null` when its program is refused.
export function readProject(
  reader: Reader,
  text: string,
  refused: (haskell: string) => boolean = () => false,
): Opening | null {
  const parsed = parseProject(text)
  if (!parsed.ok) return {kind: "unreadable", message: parsed.message, hint: parsed.hint}
  const {project} = parsed
  if (refused(project.haskell)) return null
  const view = openView(reader, normalizeLineEndings(project.haskell), project.layout)
  return {
    kind: "opened",
    notice: parsed.notice ?? contradictionNotice(view),
    opened: {
      project,
      document: analysedView(view),
      world: roomOf(project),
      isNew: false,
    },
  }
}

/// Whether a file is a room and no program: JSON that is no project.
export function isWorldFile(name: string, text: string): boolean {
  if (/\.(hs|rosy)$/i.test(name)) return false
  const value = parseJson(withoutMark(text))
  return typeof value === "object" && value !== null && !("rosy" in value)
}

/// Whether a file claims to be something else than a program, a project or a room, and is no project.
export function isForeign(name: string, text: string): boolean {
  return !/\.(hs|rosy|json)$/i.test(name) && parseJson(withoutMark(text)) === undefined
}

/// A room that cannot be read leaves the room as it is; the project file keeps it.
function roomOf({world: room}: Project): string | WorldFile | null {
  if (typeof room === "string") return room === "" ? null : room
  return readWorld(room).kind === "world" ? room : null
}

/// Opens plain Haskell from elsewhere. Any text is a program, if perhaps a broken one.
export function readHaskell(reader: Reader, name: string, text: string): OpenedProject {
  const project = {...newProject(name), haskell: text}
  return {
    project,
    document: analysedView(openView(reader, normalizeLineEndings(text))),
    world: null,
    isNew: false,
  }
}

/// The room of a new program: the service's default, without obstacles.
const plainRoom = "room"

/// A new program: `main` with an empty socket, in a plain room.
export function emptyProject(reader: Reader): OpenedProject {
  const printed = toHaskell(newWorkspace())
  const document = analysedView(openView(reader, printed.text))
  return {project: newProject(""), document, world: plainRoom, isNew: true}
}

/// The Haskell of the program as its file has it.
export function writeHaskell(project: Project, document: Document): string {
  return withLineEndingsOf(project.haskell, document.program.text)
}

/// The text of the project file for the program as it is. `places` are those of nodes of the diagram that were moved.
export function writeProject(
  project: Project,
  document: Document,
  name: string,
  room: string | WorldFile | null,
  places: NodePlaces = {},
): string {
  const {view} = document
  const moved = Object.keys(places).length === 0 ? {} : {diagram: places}
  return saveProject({
    ...project,
    name,
    ...(view === null
      ? {}
      : {
          haskell: withLineEndingsOf(project.haskell, view.text),
          layout: {...layoutOf(view), ...moved},
        }),
    ...(room === null ? {} : {world: room}),
  })
}

/// The document after an edit of the text. Types are inferred later, with `analysed`: inference takes longer than the time between two keys. `changes` leads from
/// the document's text to `text`.
export function withText(reader: Reader, document: Document, text: string, changes: ChangeDesc): Document {
  const view = document.view === null ? openView(reader, text) : syncText(reader, document.view, text)
  const fresh = documentOf(view, workspaceOf(view))
  const findings = document.findings.map(f =>
    f.range === null ? f : {...f, range: mapRange(changes, f.range)},
  )
  return {...fresh, program: {...fresh.program, families: document.program.families}, findings}
}

/// The document with what type inference tells of its blocks.
export function analysed(document: Document, inference: Inference): Document {
  const {blocks, definitions} = inference
  const families: Families = {
    get: block => definitions.get(block)?.family ?? blocks.get(block)?.family,
  }
  const program = {...document.program, families}
  // Problems of blocks that no longer say what the text says are not shown.
  const findings = inference.problems
    .map(p => blockFinding(program, p))
    .filter(
      f => f.block === null || document.dimmed.length === 0 || textRangeOf(program.spans, f.block) !== null,
    )
  return {...document, program, findings}
}

/// What an edit of the blocks leads to.
export type BlockEdit =
  | {readonly kind: "made"; readonly document: Document}
  /// The edit would have lost unfinished text of these definitions, or their new text would say something other than the blocks. The document is the one
  /// before, and shows its blocks anew.
  | {
      readonly kind: "refused"
      readonly reason: "unfinished-text" | "other-meaning"
      readonly document: Document
      readonly names: readonly string[]
    }

/// The document after the learner moved or changed blocks.
export function withBlocks(
  reader: Reader,
  document: Document,
  workspace: SavedWorkspace,
  inference: Inference,
): BlockEdit {
  const before = document.view ?? openView(reader, document.program.text)
  const view = syncBlocks(reader, before, workspace)
  if (view.refused !== undefined)
    return {
      kind: "refused",
      reason: view.inexpressible === true ? "other-meaning" : "unfinished-text",
      document: {...document, workspace: {...document.workspace}},
      names: view.refused,
    }
  const now = workspaceOf(view)
  // Text in a raw block may have become several definitions, an edit of dimmed blocks shows those of the text, another fixity regroups
  // operators elsewhere, and a comment may belong to another block: then the blocks are made anew.
  const isShown =
    sameDefinitions(now, workspace) &&
    !hasMerged(before, view) &&
    sameFixities(before.module, view.module) &&
    view.remade === undefined
  return {
    kind: "made",
    document: isShown ? analysed(documentOf(view, workspace), inference) : analysedView(view),
  }
}

/// The document with its blocks at other places, as the block view has moved them; the same document when it cannot have just these.
export function withPlaces(
  reader: Reader | null,
  document: Document,
  workspace: SavedWorkspace,
  inference: Inference,
): Document {
  if (reader === null) return document
  const edit = withBlocks(reader, document, workspace, inference)
  const {document: placed} = edit
  const isPlaced = placed.workspace === workspace && placed.program.text === document.program.text
  return edit.kind === "made" && isPlaced ? placed : document
}

/// Whether a definition with dimmed blocks has those of its text now.
function hasMerged(before: View, view: View): boolean {
  const dimmed = new Set(before.declarations.flatMap(d => (d.dimmed ? [d.block.id] : [])))
  return dimmed.size > 0 && view.declarations.some(d => !d.dimmed && dimmed.has(d.block.id))
}

/// Whether two workspaces have the same definitions and loose blocks, in any order.
function sameDefinitions(one: SavedWorkspace, other: SavedWorkspace): boolean {
  const ids = ({blocks}: SavedWorkspace) => blocks.blocks.flatMap(top => stackOf(top)).map(block => block.id)
  const [mine, others] = [ids(one), ids(other)]
  if (mine.length !== others.length) return false
  if (mine.every((id, i) => id === others[i])) return true
  return mine.sort().join(" ") === others.sort().join(" ")
}

function stackOf(top: SavedBlock): readonly SavedBlock[] {
  return top.next?.block === undefined ? [top] : [top, ...stackOf(top.next.block)]
}

/// What the page shows of a view, before its types are known.
export function unanalysed(view: View): Document {
  return documentOf(view, workspaceOf(view))
}

/// The same, with blocks that may be newer than the view's.
function documentOf(view: View, workspace: SavedWorkspace): Document {
  const spans = spansOf(view).spans.flatMap((s): Span[] =>
    s.block === undefined ? [] : [{start: s.start, end: s.end, block: s.block}],
  )
  const definitions = view.declarations.flatMap((shown): Definition[] => {
    const piece = view.module.pieces[shown.piece]
    if (piece === undefined || shown.block.id === undefined) return []
    const {start, end} = piece.core
    return piece.names.map(name => ({name, start, end, block: shown.block.id ?? ""}))
  })
  const dimmed = view.declarations.filter(d => d.dimmed).flatMap(d => d.block.id ?? [])
  const words = view.module.pieces
    .filter(piece => piece.words.length > 0)
    .map(piece => ({start: piece.core.start, words: piece.words}))
  const program = {text: view.text, spans, definitions, families: noFamilies, words}
  return {program, workspace, view, dimmed, findings: []}
}

function analysedView(view: View): Document {
  const document = unanalysed(view)
  return analysed(document, infer(document.workspace))
}

/// A problem of the compiler or of a run, for its block. A note puts no sign on a block.
export function blockProblem({severity, kind, block, message, hint}: Finding): readonly BlockProblem[] {
  return severity === "note" ? [] : [{severity, kind, block: block ?? undefined, message, hint}]
}
