/// Reducer for a run: Run, Stop, Reset, the clock, looking back, the learner's input in the room. Pure.

import {setVisible} from "../state/arrangement.ts"
import {noPreview} from "../state/messages/preview.ts"
import {reduceWhy} from "../state/messages/why_state.ts"
import type {RunEvent} from "../state/page_events.ts"
import type {PageState} from "../state/page_state.ts"
import {isDriving} from "../state/robot_ownership.ts"
import {companionsOf} from "../state/runs/companions.ts"
import {emptyLog} from "../state/runs/firing_log.ts"
import {clearRoom, roomUntil, shownFrame} from "../state/runs/room_state.ts"
import {isActive, nextRun} from "../state/runs/run_state.ts"
import {
  beginRun,
  beginTwins,
  nodeOf,
  originOf,
  type RunOrigin,
  storeShown,
  twinOf,
} from "../state/runs/run_tree.ts"
import {sending, still, type Transition, unreachable} from "../state/transition.ts"
import {returnToRun} from "./run_tree_reducer.ts"

/// Applies a press of Run, Stop or Reset, a change of the clock, or the learner's input in the room.
export function reduceRunEvent(state: PageState, event: RunEvent): Transition {
  switch (event.kind) {
    case "run-pressed":
      return start(state, event.seed ?? state.seed)
    case "stop-pressed": {
      if (!isActive(state.run)) return still(state)
      const stopped = {...state, run: nextRun(state.run, event)}
      return state.run.kind === "waiting" ? still(stopped) : sending(stopped, {op: "stop"})
    }
    case "reset-pressed": {
      const room = clearRoom(state.room, state.robots.held === null ? null : state.runs)
      const run = nextRun(state.run, event)
      const why = reduceWhy(state.why, {kind: "closed"}).state
      return sending(
        {
          ...state,
          run,
          room,
          runTree: storeShown(state.runTree, state),
          why,
          lines: [],
          findings: {...state.findings, run: []},
        },
        {op: "reset"},
      )
    }
    case "looked-back": {
      const last = state.room.frame?.time ?? 0
      // The end of the run is now: from there the picture goes on.
      const lookedAt = event.time === null || event.time >= last ? null : event.time
      const looking = {...state, room: {...state.room, lookedAt}}
      // A real robot does not wait while its run is looked back at.
      const stands =
        lookedAt !== null && state.clock === "going" && isActive(state.run) && state.robots.held === null
      return stands ? sending({...looking, clock: "standing"}, {op: "pause"}) : still(looking)
    }
    case "continue-pressed":
      return continueRun(state)
    case "hand":
      return state.run.kind === "running" && state.robots.held === null
        ? sending(present(state), {op: "input", ...event.hand})
        : still(state)
    case "safety-switched": {
      const switched = {...state, safety: {on: event.on, since: null}}
      return state.link === "open" ? sending(switched, {op: "safety", on: event.on}) : still(switched)
    }
    case "pause-pressed":
      return isActive(state.run) && state.clock === "going" && !isDriving(state)
        ? sending({...state, clock: "standing"}, {op: "pause"})
        : still(state)
    case "resume-pressed":
      return state.clock === "standing"
        ? sending({...present(state), clock: "going"}, {op: "resume"})
        : still(state)
    case "forward-pressed":
      return isActive(state.run) && state.clock === "standing"
        ? sending(present(state), {op: "forward"})
        : still(state)
    case "speed-chosen": {
      const chosen = {...state, speed: event.speed}
      return isActive(state.run) ? sending(chosen, {op: "speed", speed: event.speed}) : still(chosen)
    }
    case "values-shown":
      return observing(state, {...state, valuesShown: event.shown})
    case "diagram-pointed":
      return observing(state, {
        ...state,
        diagram: {...state.diagram, isPointedAt: event.isPointedAt},
      })
    case "function-graphed": {
      const tab = event.function === null ? state.tab : "charts"
      return observing(state, {...state, tab, graphed: event.function})
    }
    default:
      return unreachable(event)
  }
}

/// Shows the newest moment of the run that goes on again.
function present(state: PageState): PageState {
  const returned = returnToRun(state)
  return {...returned, room: {...returned.room, lookedAt: null}}
}

/// A new run of the open program; without a connection it waits.
function start(state: PageState, seed: number | null, from?: RunOrigin): Transition {
  const connected = state.link === "open"
  const isReal = state.robots.held !== null
  // The real run is the newest one: what the robot reports after it has its number.
  const twin = isReal && state.robots.twin && state.robots.room !== null ? state.runs + 1 : null
  const run = (twin ?? state.runs) + 1
  const {text} = state.document.program
  const begun = {run, from: from ?? originOf(state.runTree, state.room.run, text), text, seed}
  const runTree =
    twin !== null
      ? beginTwins(state.runTree, state, begun, twin)
      : isReal
        ? state.runTree
        : beginRun(state.runTree, state, begun)
  const started: PageState = {
    ...state,
    run: nextRun(state.run, {kind: "run-pressed", connected, run}),
    runs: run,
    seed,
    clock: "going",
    room: {
      ...clearRoom(state.room, run),
      source: text,
      preview: {...noPreview, ran: isReal ? null : text},
    },
    runTree,
    why: reduceWhy(state.why, {kind: "closed"}).state,
    lines: [],
    findings: {...state.findings, run: []},
    welcome: state.welcome === "fresh" ? "ran" : "over",
    welcoming: false,
    tab: state.tab === "problems" ? "console" : state.tab,
    notice: null,
    region: state.size === "phone" ? "room" : state.region,
    // A real robot is not run without its picture in sight.
    arrangement: setVisible(state.arrangement, "room", true),
  }
  return connected ? sending(started, runMessage(started, run)) : still(started)
}

/// Runs are recorded for questions; frames have the firings only while their values may be seen.
export const observeMessage = (state: PageState) =>
  ({op: "observe", on: true, ...(seesFirings(state) ? {frames: true} : {})}) as const

const seesFirings = ({valuesShown, diagram, graphed}: PageState) =>
  valuesShown || diagram.isPointedAt || graphed !== null

/// The log of firings begins anew when the service begins to send them, and is empty when it does not.
function observing(before: PageState, after: PageState): Transition {
  if (seesFirings(before) === seesFirings(after)) return still(after)
  const firings = {...emptyLog, isWhole: after.room.frame === null}
  const chosen = {...after, room: {...after.room, firings}}
  return after.link === "open" ? sending(chosen, observeMessage(chosen)) : still(chosen)
}

/// Whether the shown run can go on from the moment that is looked at.
export function mayContinue({room, robots, link, runTree}: PageState): boolean {
  const isRecorded = nodeOf(runTree, room.run)?.recorded !== undefined
  return room.lookedAt !== null && room.run !== null && !isRecorded && robots.held === null && link === "open"
}

/// A new run that begins with the shown one up to the moment that is looked at. The service repeats that part at once.
function continueRun(state: PageState): Transition {
  const frame = shownFrame(state.room)
  const {run: of} = state.room
  if (!mayContinue(state) || frame === null || of === null) return still(state)
  const from = nodeOf(state.runTree, of) === undefined ? undefined : {run: of, at: frame.time}
  const begun = start(state, state.seed, from).state
  const continued = {
    ...begun,
    room: {
      ...roomUntil(state.room, frame.time),
      run: begun.runs,
      source: begun.room.source,
      branches: [],
      preview: begun.room.preview,
    },
    lines: state.lines.filter(line => line.time <= frame.time),
  }
  return sending(continued, {...runMessage(continued, begun.runs), after: frame.step, of})
}

/// The request for the run with this number.
export function runMessage(state: PageState, run: number) {
  const {seed} = state
  const twin = twinOf(state.runTree, run)
  const {text} = state.document.program
  const companions = state.robots.held === null ? companionsOf(state.companions, text) : []
  const more = {
    ...(seed === null ? {} : {seed}),
    ...(twin === undefined ? {} : {twin: twin.run}),
    ...(companions.length === 0 ? {} : {companions}),
  }
  return {op: "run", run, source: text, ...more, speed: state.speed} as const
}
