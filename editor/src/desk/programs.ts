/// Between project files, blocks and the program that the page shows: codegen's answers in the page's words.

import {
  type BlockProblem,
  closeProject,
  type Inference,
  newProject,
  newWorkspace,
  type Opened,
  openProject,
  type Project,
  parseProject,
  type SavedBlock,
  type SavedWorkspace,
  saveProject,
  toHaskell,
} from "@rosy/codegen"
import {decode} from "../state/decode.ts"
import type {Document} from "../state/history.ts"
import {type World, world} from "../state/messages.ts"
import {type Finding, type Program, type Span, textOf} from "../state/program.ts"

/// A program as it comes from a file.
export interface OpenedProject {
  readonly project: Project
  readonly workspace: SavedWorkspace
  readonly world: string | World | null
}

export type Opening =
  | {readonly kind: "opened"; readonly opened: OpenedProject}
  | {readonly kind: "unreadable"; readonly message: string; readonly hint: string}

export function readProject(text: string): Opening {
  const parsed = parseProject(text)
  if (!parsed.ok) return {kind: "unreadable", message: parsed.message, hint: parsed.hint}
  const {project} = parsed
  const room = typeof project.world === "string" ? project.world : decode(world, project.world)
  return {
    kind: "opened",
    opened: {
      project,
      workspace: withRaw(openProject(project)),
      // A room that cannot be read leaves the room as it is; the project file keeps it.
      world: typeof room === "string" ? (room === "" ? null : room) : room.kind === "ok" ? room.value : null,
    },
  }
}

/// Text without blocks of its own is shown as raw blocks, so that it is seen and nothing of it is lost.
function withRaw({workspace, changed}: Opened): SavedWorkspace {
  if (changed.length === 0) return workspace
  const raw = changed.map(({text}): SavedBlock => ({type: "raw_definition", extraState: {text: text.trim()}}))
  return {blocks: {...workspace.blocks, blocks: [...workspace.blocks.blocks, ...raw]}}
}

export function emptyProject(): OpenedProject {
  return {project: newProject(""), workspace: newWorkspace(), world: null}
}

/// The text of the project file for the blocks as they are.
export function writeProject(
  project: Project,
  workspace: SavedWorkspace,
  name: string,
  room: string | World | null,
): string {
  const closed = closeProject({...project, name}, workspace)
  return saveProject({...closed, ...(room === null ? {} : {world: room as Project["world"]})})
}

/// The program that the blocks are, and what is wrong with them.
export function documentOf(workspace: SavedWorkspace, inference: Inference): Document {
  const printed = toHaskell(workspace)
  const spans = printed.spans.flatMap((s): Span[] =>
    s.block === undefined ? [] : [{start: s.start, end: s.end, block: s.block}],
  )
  const definitions = [...inference.definitions].flatMap(([block, {name}]) => {
    const range = textOf(spans, block)
    return range === null ? [] : [{name, block, ...range}]
  })
  const families = Object.fromEntries([...inference.blocks].map(([block, {family}]) => [block, family]))
  const program = {text: printed.text, spans, definitions, families}
  return {program, workspace, findings: inference.problems.map(p => findingOf(program, p))}
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
