/// Reducer for the program: opening, changes, undo, storage; a changed text goes to the compiler. Pure.

import {areMadeOfBlocks, type CompilerReading, otherwiseGrouped} from "../program/compiler_groups.ts"
import {type Document, recordChange, redo, undo} from "../program/history.ts"
import {type Definition, type Finding, mapFix, mapRange} from "../program/program.ts"
import {type ChangeDesc, changesBetween} from "../program/text_changes.ts"
import {newestBefore, unreadDefinitions, withEdit} from "../program/unread_texts.ts"
import {withoutLesson} from "../state/lesson_state.ts"
import {reduceWhy} from "../state/messages/why_state.ts"
import type {DocumentEvent, Opened} from "../state/page_events.ts"
import type {Notice, PageState} from "../state/page_state.ts"
import {clearRoom} from "../state/runs/room_state.ts"
import {isActive, nextRun} from "../state/runs/run_state.ts"
import {noRuns} from "../state/runs/run_tree.ts"
import {type Effect, sending, still, type Transition, unreachable} from "../state/transition.ts"
import {refusedSockets} from "../state/visible_findings.ts"

/// Applies a change of the program, of its name, or of what is stored of it.
export function reduceDocumentEvent(state: PageState, event: DocumentEvent): Transition {
  switch (event.kind) {
    case "opened":
      return openProgram(state, event.opened)
    case "followed":
      return followProgram(state, event)
    case "text-typed":
      return still({...state, pendingText: event.text})
    case "program-changed": {
      const {numberDrag: drag} = state
      const history = recordChange(state.history, state.document, event.by, event.at, drag)
      const numberDrag = drag === null ? null : "changing"
      const unread = withEdit(state.unread, state.document, event.document, event.by)
      return changeTo({...state, history, numberDrag, unread}, event.document, event.changes)
    }
    case "analysed":
      return still(state.document === event.before ? withAnalysed(state, event.document) : state)
    case "undo-pressed": {
      const back = undo(state.history, state.document)
      return back === null ? still(state) : changeTo({...state, history: back.history}, back.document)
    }
    case "redo-pressed": {
      const on = redo(state.history, state.document)
      return on === null ? still(state) : changeTo({...state, history: on.history}, on.document)
    }
    case "nodes-moved":
      return still({...state, diagram: {...state.diagram, places: event.places}, saved: "changed"})
    case "renamed":
      return still({...state, name: event.name, saved: "changed"})
    case "stored":
      return still({
        ...state,
        saved: event.ok ? "saved" : "failed",
        notice: event.ok ? state.notice : {kind: "not-saved", gone: goneOf(state.notice)},
      })
    case "number-drag":
      return still({
        ...state,
        numberDrag: event.going ? "begun" : null,
        // What follows is another step.
        history: event.going ? state.history : {...state.history, last: null},
      })
    default:
      return unreachable(event)
  }
}

/// The programs that the notice in sight says are gone: a notice in its place says it as well.
const goneOf = (notice: Notice | null): readonly string[] =>
  notice?.kind === "made-way" || notice?.kind === "not-saved" ? notice.gone : []

/// Opens another program. Its run, room and messages start anew.
function openProgram(state: PageState, opened: Opened): Transition {
  const room = clearRoom(state.room, state.robots.held === null ? null : state.runs)
  const fresh: PageState = {
    ...state,
    name: opened.name,
    saved: "saved",
    document: opened.document,
    diagram: {...state.diagram, chosen: null, places: opened.places ?? {}},
    pendingText: null,
    history: opened.history,
    unread: [],
    // Where a program without a room of its own is opened is its room from then on.
    worldName: opened.world ?? state.worldName,
    replacedRoom: opened.replacedRoom ?? (opened.world === null ? state.replacedRoom : null),
    run: nextRun(state.run, {kind: "reset-pressed"}),
    room,
    runTree: noRuns,
    why: reduceWhy(state.why, {kind: "closed"}).state,
    lines: [],
    findings: {compiler: [], run: []},
    accepted: false,
    selected: null,
    welcome: opened.welcome ? "fresh" : "over",
    welcoming: opened.isFirstVisit === true,
    refused: null,
    speed: opened.isNew ? 1 : state.speed,
    dialog: opened.isFirst ? state.dialog : null,
    notice: null,
    lessons: opened.inLesson ? state.lessons : withoutLesson(state.lessons),
  }
  const asked = check(fresh)
  if (state.link !== "open") return still(asked.state)
  // Choosing a room ends a run; without a room of its own a project gets the room as it was, reset.
  const ready =
    opened.world === null ? ({op: "reset"} as const) : ({op: "world", world: opened.world} as const)
  const left: Effect[] =
    state.lessons.open === null || opened.inLesson
      ? []
      : [{kind: "send", message: {op: "lesson", step: null}}]
  return {state: asked.state, effects: [...left, {kind: "send", message: ready}, ...asked.effects]}
}

/// Shows the program as another tab stored it.
function followProgram(state: PageState, event: DocumentEvent & {kind: "followed"}): Transition {
  const history = recordChange(state.history, state.document, "command", event.at)
  const unread = withEdit(state.unread, state.document, event.document, "command")
  const {state: changed, effects} = changeTo({...state, history, unread}, event.document)
  const {name, world, replacedRoom} = event
  const diagram = {...changed.diagram, places: event.places ?? {}}
  const followed = {...changed, diagram, name, replacedRoom, saved: "saved"} as const
  const sameWorld = world === null || JSON.stringify(world) === JSON.stringify(state.worldName)
  // A run in this tab goes on in the room that it has.
  if (sameWorld || isActive(state.run)) return {state: followed, effects}
  const room: Effect[] = state.link === "open" ? [{kind: "send", message: {op: "world", world}}] : []
  return {state: {...followed, worldName: world, runTree: noRuns}, effects: [...room, ...effects]}
}

/// The finding at the place that its text has after the changes.
const moved =
  (changes: ChangeDesc) =>
  (finding: Finding): Finding =>
    finding.range === null
      ? finding
      : {
          ...finding,
          range: mapRange(changes, finding.range),
          fixes: finding.fixes.map(f => mapFix(changes, f)),
        }

/// Makes another document the program. What the last run said was about the old one.
function changeTo(state: PageState, document: Document, edit?: ChangeDesc): Transition {
  const changed: PageState = {...state, document, pendingText: null, saved: "changed"}
  if (document.program.text === state.document.program.text) return still(changed)
  const changes = edit ?? changesBetween(state.document.program.text, document.program.text)
  return check({
    ...changed,
    // What the compiler said stands, moved along, until it has read the new text: marks do not flicker while typing.
    findings: {compiler: state.findings.compiler.map(moved(changes)), run: []},
  })
}

/// Takes edits of blocks back when the compiler groups what they have written in another way than the blocks, or cannot parse it although it could parse the
/// program before; `null` when there is nothing to take back. All edits since go back with them, and cannot be made again by Redo. Text that is being typed
/// stays; what was edited as text since comes back by Undo.
export function withoutMisreading(state: PageState, answer: CompilerReading): Transition | null {
  const {document, pendingText} = state
  if (pendingText !== null) return null
  const unread = unreadDefinitions(document, state.unread)
  const misread = otherwiseGrouped(document, unread, answer)
  const back = misread.length > 0 ? misread : answer.groups === null ? unreadable(state, unread) : []
  if (back.length === 0) return null
  const before = newestBefore(state.history.past, state.unread, back)
  if (before === null) return null
  const isTextLost = wereFollowedByText(state, back)
  const past = [...state.history.past.slice(0, before.at), ...(isTextLost ? [document] : [])]
  const kind = misread.length > 0 ? "grouped-otherwise" : "unreadable-edit"
  const notice = {kind, names: back.map(d => d.name)} as const
  return changeTo({...state, history: {past, future: [], last: null}, unread: [], notice}, before.document)
}

/// The unread definitions for which the compiler cannot parse the program: none when it could not before, or text was edited since, in a block or beside them.
function unreadable(state: PageState, unread: readonly Definition[]): readonly Definition[] {
  if (wereFollowedByText(state, unread)) return []
  const before = newestBefore(state.history.past, state.unread, unread)
  if (before === null || !state.parsed.includes(before.document.program.text)) return []
  return areMadeOfBlocks(state.document, unread, before.document) ? unread : []
}

function wereFollowedByText({unread}: PageState, definitions: readonly Definition[]): boolean {
  const names = new Set(definitions.map(d => d.name))
  return unread.some(u => u.isFollowedByText && names.has(u.name))
}

/// The document with its inferred types. A refused text may have been analysed only after its run.
function withAnalysed(state: PageState, document: Document): PageState {
  const isRefused = state.refused?.text === document.program.text
  return {...state, document, refused: isRefused ? refusedSockets(document) : state.refused}
}

/// Asks the compiler about the text as it is now.
export function check(state: PageState): Transition {
  const id = state.checks + 1
  const asked = {...state, checks: id}
  if (state.link !== "open" || state.document.program.text === "") return still(asked)
  return sending(asked, {op: "check", id, source: state.document.program.text})
}
