/// Reducer for recordings of runs on real robots: one is asked for, opens as a run of its own, and ends. Pure.

import {locateProblem} from "../program/program.ts"
import {setVisible} from "../state/arrangement.ts"
import type {ServiceMessage} from "../state/messages/messages.ts"
import {noPreview} from "../state/messages/preview.ts"
import {reduceWhy} from "../state/messages/why_state.ts"
import type {RecordingEvent} from "../state/page_events.ts"
import type {PageState} from "../state/page_state.ts"
import {isDriving} from "../state/robot_ownership.ts"
import {clearRoom} from "../state/runs/room_state.ts"
import {isActive, nextRun} from "../state/runs/run_state.ts"
import {beginRun} from "../state/runs/run_tree.ts"
import {sending, still, type Transition} from "../state/transition.ts"
import {words} from "../words/index.ts"
import {withoutRefusedRun} from "./run_tree_reducer.ts"

/// Whether a recording can be opened: not while a real robot drives, whose run would end.
export const mayOpenRecording = (state: PageState): boolean => state.link === "open" && !isDriving(state)

export function reduceRecording(state: PageState, {of}: RecordingEvent): Transition {
  if (!mayOpenRecording(state)) {
    const {notConnected, driving} = words.recordings
    const message = state.link === "open" ? driving : notConnected
    return still({...state, notice: {kind: "refusal", message, hint: ""}})
  }
  const run = state.runs + 1
  const asked: PageState = {
    ...state,
    run: nextRun(state.run, {kind: "run-pressed", connected: true, run}),
    runs: run,
    replay: run,
    clock: "going",
    notice: null,
  }
  // On the open floor below a real robot it begins in the middle, and in a room where that begins.
  const room = state.room.world?.open !== true
  return sending(asked, {op: "replay", run, ...(of === null ? {} : {of}), room})
}

type Replayed = Extract<ServiceMessage, {readonly op: "replayed"}>
type RunEnd = Extract<ServiceMessage, {readonly op: "state"; readonly state: "ended"}>

/// The recording is open: what follows is shown as a run of its own, of the recorded program.
export function beginReplay(state: PageState, {run, program, robot}: Replayed): PageState {
  if (!isActive(state.run) || state.run.run !== run) return state
  const isOther = program !== state.document.program.text
  return {
    ...state,
    room: {...clearRoom(state.room, run), source: program, preview: noPreview},
    runTree: beginRun(state.runTree, state, {run, from: null, text: program, seed: null, recorded: robot}),
    why: reduceWhy(state.why, {kind: "closed"}).state,
    lines: [],
    findings: {...state.findings, run: []},
    // There its program is offered when another one is open.
    tab: isOther ? "runs" : state.tab === "problems" ? "console" : state.tab,
    region: state.size === "phone" ? "room" : state.region,
    arrangement: setVisible(state.arrangement, "room", true),
  }
}

/// A recording has come to its end, or could not be shown. Its problems have places in the recorded program.
export function endReplay(state: PageState, {run, ended, problems}: RunEnd): PageState {
  if (ended === "refused") {
    const notice = {kind: "refusal", message: words.recordings.refused, hint: ""} as const
    return {...withoutRefusedRun(state, run), notice}
  }
  const {program} = state.document
  if (state.room.source !== program.text) return state
  const found = problems.map(problem => locateProblem(program, problem, "run"))
  return {...state, findings: {...state.findings, run: found}}
}
