/// Reducer for the run tree: a stored run is shown again, or compared with the shown one. A run that goes on is paused and stored meanwhile. Pure.

import {noFixPreviews} from "../state/messages/fix_previews.ts"
import {noPreview} from "../state/messages/preview.ts"
import {reduceWhy} from "../state/messages/why_state.ts"
import type {RunTreeEvent} from "../state/page_events.ts"
import type {PageState} from "../state/page_state.ts"
import {isActive} from "../state/runs/run_state.ts"
import {
  compareWith,
  nodeOf,
  type RunNode,
  type ShownRun,
  takeRun,
  twinOf,
  withoutRun,
} from "../state/runs/run_tree.ts"
import {sending, still, type Transition} from "../state/transition.ts"

export function reduceRunTree(state: PageState, event: RunTreeEvent): Transition {
  if (event.kind === "run-compared") return still({...state, runTree: compareWith(state.runTree, event.run)})
  if (!mayShowRuns(state)) return still(state)
  const shown = showRun(state, event.run)
  // As when a run is looked back at, its clock stands until it is resumed.
  return shown !== state && isActive(state.run) && state.clock === "going"
    ? sending({...shown, clock: "standing"}, {op: "pause"})
    : still(shown)
}

/// Whether another run can be shown: not before the first picture of a run that begins, nor while a real robot drives, which does not wait.
export function mayShowRuns({run, robots, runTree, room}: PageState): boolean {
  if (!isActive(run)) return true
  if (run.kind !== "running" || robots.held !== null) return false
  return room.run !== run.run ? nodeOf(runTree, run.run) !== undefined : room.recording.length > 0
}

/// The run that goes on while the room shows another one; `null` when there is none.
export function awayRun({run, runTree}: Pick<PageState, "run" | "runTree">): RunNode | null {
  const node = isActive(run) ? nodeOf(runTree, run.run) : undefined
  return node === undefined || node.kept === null ? null : node
}

/// The page with the run that goes on in its room again, at its newest moment.
export function returnToRun(state: PageState): PageState {
  const away = awayRun(state)
  return away === null ? state : showRun(state, away.run)
}

/// Applies what the service tells of a run that is stored: its last frame arrives after another run was chosen, or it is the twin of a real one.
export function inStoredRun(
  state: PageState,
  run: number,
  apply: (state: PageState) => Transition,
): Transition {
  const node = nodeOf(state.runTree, run)
  const stored = node?.kept
  const isTwin = node?.twin === "simulated"
  const isOwn = state.run.kind !== "ready" && state.run.run === run
  if (stored == null || !(isTwin || isOwn)) return apply(state)
  const {room, lines, runTree} = state
  const told = apply({...state, ...stored})
  const kept: ShownRun = {room: told.state.room, lines: told.state.lines}
  const nodes = runTree.nodes.map(node => (node.run === run ? {...node, kept} : node))
  // Only the real robot is heard.
  const effects = isTwin ? [] : told.effects
  return {effects, state: {...told.state, room, lines, runTree: {...runTree, nodes}}}
}

/// The page with a stored run in its room, at its end or at a moment, s.
function showRun(state: PageState, run: number, at: number | null = null): PageState {
  const {room, lines} = state
  const taken = takeRun(state.runTree, {room, lines}, run)
  if (taken === null) return state
  const {kept, text, seed} = taken.node
  return {
    ...state,
    runTree: taken.tree,
    // A preview compares the program with the newest run, which the service repeats.
    room: {
      ...kept.room,
      world: room.world,
      held: null,
      lookedAt: at,
      preview: {...noPreview, ran: run === newestRun(state) ? text : null},
      fixPreviews: noFixPreviews,
    },
    seed,
    lines: kept.lines,
    why: reduceWhy(state.why, {kind: "closed"}).state,
    findings: {...state.findings, run: []},
  }
}

const newestRun = ({runTree}: PageState) => runTree.nodes.at(-1)?.run

/// The page after a run was refused: it is no part of the tree, and the run that it was to continue is shown again.
export function withoutRefusedRun(state: PageState, run: number): PageState {
  const refused = state.runTree.nodes.find(node => node.run === run)
  if (refused === undefined) return state
  const twin = twinOf(state.runTree, run)
  const tree = twin === undefined ? state.runTree : withoutRun(state.runTree, twin.run)
  const rest = {...state, runTree: withoutRun(tree, run)}
  const {from} = refused
  return from === null || from.at === null || state.room.run !== run ? rest : showRun(rest, from.run, from.at)
}
