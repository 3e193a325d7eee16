/// Between project files, Haskell, blocks and the document that the page shows: codegen's answers in the page's
/// words. Both views are kept in step by codegen's `View`; a document carries its own, so that undo is exact.

import {
  type BlockProblem,
  type Inference,
  infer,
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
  layoutOf,
  openView,
  type Reader,
  spansOf,
  syncBlocks,
  syncText,
  type View,
  workspaceOf,
} from "@rosy/codegen/reader"
import {parseJson} from "../state/decode.ts"
import type {Document} from "../state/history.ts"
import {
  type Definition,
  type Finding,
  mover,
  type Program,
  rangeMoved,
  type Span,
  textOf,
} from "../state/program.ts"
import {readWorld} from "../worlds/read.ts"
import type {WorldFile} from "../worlds/world.ts"
import {asInFile, oneKindOfLine} from "./lines.ts"

/// A program as it comes from a file.
export interface OpenedProject {
  readonly project: Project
  readonly document: Document
  readonly world: string | WorldFile | null
}

export type Opening =
  | {readonly kind: "opened"; readonly opened: OpenedProject}
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
  return {
    kind: "opened",
    opened: {
      project,
      document: analysedView(openView(reader, oneKindOfLine(project.haskell), project.layout)),
      world: roomOf(project),
    },
  }
}

/// Whether a file is a room and no program: JSON that is no project.
export function isWorldFile(name: string, text: string): boolean {
  if (/\.(hs|rosy)$/i.test(name)) return false
  const value = parseJson(text.replace(/^\uFEFF/, ""))
  return typeof value === "object" && value !== null && !("rosy" in value)
}

/// Whether a file claims to be something else than a program, a project or a room, and is no project.
export function isForeign(name: string, text: string): boolean {
  return !/\.(hs|rosy|json)$/i.test(name) && parseJson(text.replace(/^\uFEFF/, "")) === undefined
}

/// A room that cannot be read leaves the room as it is; the project file keeps it.
function roomOf({world: room}: Project): string | WorldFile | null {
  if (typeof room === "string") return room === "" ? null : room
  return readWorld(room).kind === "world" ? room : null
}

/// Opens plain Haskell from elsewhere. Any text is a program, if perhaps a broken one.
export function readHaskell(reader: Reader, name: string, text: string): OpenedProject {
  const project = {...newProject(name), haskell: text}
  return {project, document: analysedView(openView(reader, oneKindOfLine(text))), world: null}
}

/// A new program: `main` with an empty socket.
export function emptyProject(reader: Reader): OpenedProject {
  const printed = toHaskell(newWorkspace())
  return {project: newProject(""), document: analysedView(openView(reader, printed.text)), world: null}
}

/// The Haskell of the program as its file has it.
export function writeHaskell(project: Project, document: Document): string {
  return asInFile(project.haskell, document.program.text)
}

/// The text of the project file for the program as it is.
export function writeProject(
  project: Project,
  document: Document,
  name: string,
  room: string | WorldFile | null,
): string {
  const {view} = document
  return saveProject({
    ...project,
    name,
    ...(view === null ? {} : {haskell: asInFile(project.haskell, view.text), layout: layoutOf(view)}),
    ...(room === null ? {} : {world: room}),
  })
}

/// The document after the learner typed. What types tell of it follows with `analysed`: they cost more than the
/// time between two keys.
export function withText(reader: Reader, document: Document, text: string): Document {
  const view = document.view === null ? openView(reader, text) : syncText(reader, document.view, text)
  const fresh = documentOf(view, workspaceOf(view))
  const move = mover(document.program.text, text)
  const findings = document.findings.map(f =>
    f.range === null ? f : {...f, range: rangeMoved(move, f.range)},
  )
  return {...fresh, program: {...fresh.program, families: document.program.families}, findings}
}

/// The document with what type inference tells of its blocks.
export function analysed(document: Document, inference: Inference): Document {
  const families = Object.fromEntries(
    [...inference.blocks, ...inference.definitions].map(([block, {family}]) => [block, family]),
  )
  const program = {...document.program, families}
  // What is wrong with blocks that no longer say what the text says is nobody's problem.
  const findings = inference.problems
    .map(p => findingOf(program, p))
    .filter(f => f.block === null || document.dimmed.length === 0 || textOf(program.spans, f.block) !== null)
  return {...document, program, findings}
}

/// The document after the learner moved or changed blocks.
export function withBlocks(
  reader: Reader,
  document: Document,
  workspace: SavedWorkspace,
  inference: Inference,
): Document {
  const before = document.view ?? openView(reader, document.program.text)
  const view = syncBlocks(reader, before, workspace)
  const now = workspaceOf(view)
  // Text in a raw block may have become several definitions: then the blocks are made anew from the text.
  return sameDefinitions(now, workspace)
    ? analysed(documentOf(view, workspace), inference)
    : analysedView(view)
}

function sameDefinitions(one: SavedWorkspace, other: SavedWorkspace): boolean {
  const ids = (workspace: SavedWorkspace) =>
    workspace.blocks.blocks
      .flatMap(top => stackOf(top))
      .map(block => block.id)
      .sort()
      .join(" ")
  return ids(one) === ids(other)
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
  const program = {text: view.text, spans, definitions, families: {}, words}
  return {program, workspace, view, dimmed, findings: []}
}

function analysedView(view: View): Document {
  const document = unanalysed(view)
  return analysed(document, infer(document.workspace))
}

function findingOf(program: Program, problem: BlockProblem): Finding {
  const block = problem.block ?? null
  return {
    severity: problem.severity,
    kind: problem.kind,
    from: "blocks",
    message: problem.message,
    hint: problem.hint,
    ghc: "",
    function: null,
    time: null,
    inputs: [],
    fixes: [],
    block,
    range: block === null ? null : textOf(program.spans, block),
  }
}

/// A problem of the compiler or of a run, for its block.
export function blockProblem(finding: Finding): BlockProblem {
  return {
    severity: finding.severity,
    kind: finding.kind,
    block: finding.block ?? undefined,
    message: finding.message,
    hint: finding.hint,
  }
}
