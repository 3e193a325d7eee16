/// Reducer for the run tree: a stored run is shown again, or compared with the shown one. Pure.

import {noPreview} from "../preview/preview.ts"
import type {PageState} from "../state/page_state.ts"
import {isActive} from "../state/run_state.ts"
import {reduceWhy} from "../why/why_state.ts"
import {compareWith, takeRun, withoutRun} from "./run_tree.ts"

export type RunTreeEvent =
  /// A stored run is looked at again.
  | {readonly kind: "run-shown"; readonly run: number}
  /// A stored run is drawn over the shown one; `null` for none.
  | {readonly kind: "run-compared"; readonly run: number | null}

export function reduceRunTree(state: PageState, event: RunTreeEvent): PageState {
  if (event.kind === "run-compared") return {...state, runTree: compareWith(state.runTree, event.run)}
  // The room shows a program that runs until it ends.
  return isActive(state.run) ? state : showRun(state, event.run)
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
  const rest = {...state, runTree: withoutRun(state.runTree, run)}
  const {from} = refused
  return from === null || from.at === null || state.room.run !== run ? rest : showRun(rest, from.run, from.at)
}
