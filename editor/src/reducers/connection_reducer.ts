/// Reducer for the connection to the service: its messages, and its loss. Pure.

import {conflictShown} from "@rosy/codegen"
import {blockFinding, locateProblem} from "../program/program.ts"
import {withoutRead} from "../program/unread_texts.ts"
import {reduceLesson, watchedNow} from "../state/lesson_state.ts"
import {hearFixPreview} from "../state/messages/fix_previews.ts"
import type {ServiceMessage} from "../state/messages/messages.ts"
import {hearPreview, noPreview} from "../state/messages/preview.ts"
import type {PageState} from "../state/page_state.ts"
import {
  reduceRobotMessage,
  withoutRobot,
  withRobotRefusal,
  withSimulatedRoom,
} from "../state/robot_ownership.ts"
import {addFrame, addLine, addSpeech, isShown, roomUntil, soundNames} from "../state/runs/room_state.ts"
import {nextRun} from "../state/runs/run_state.ts"
import {nodeOf} from "../state/runs/run_tree.ts"
import {type Effect, still, type Transition, unreachable} from "../state/transition.ts"
import {refusedSockets} from "../state/visible_findings.ts"
import type {Request} from "../wire/page/page.generated.ts"
import {words} from "../words/index.ts"
import {worded} from "../words/worker_sentences.ts"
import {check, withoutMisreading} from "./document_reducer.ts"
import {beginReplay, endReplay} from "./recording_reducer.ts"
import {explain, withLessons} from "./request_reducer.ts"
import {observeMessage, runMessage} from "./run_reducer.ts"
import {inStoredRun, withoutRefusedRun} from "./run_tree_reducer.ts"
import {inWorld} from "./world_reducer.ts"

/// A message with this `op`.
type Message<Op extends ServiceMessage["op"]> = Extract<ServiceMessage, {readonly op: Op}>

/// The state after the connection was lost. A robot that this page controlled stands and is free.
export function loseConnection(state: PageState): PageState {
  const lost = state.robots.held === null ? state : withoutRobot(state)
  return {
    ...lost,
    link: "lost",
    accepted: false,
    run: nextRun(state.run, {kind: "lost"}),
    // The next session of the service has no last run.
    room: {...lost.room, preview: noPreview},
    robots: {...lost.robots, offered: null},
    recorded: null,
  }
}

export function reduceServiceMessage(state: PageState, message: ServiceMessage): Transition {
  const run = pictureOf(message)
  return run === null
    ? reduceMessage(state, message)
    : inStoredRun(state, run, s => reduceMessage(s, message))
}

/// The run of whose picture or console a message tells; `null` for other messages.
function pictureOf(message: ServiceMessage): number | null {
  switch (message.op) {
    case "frame":
      return message.frame.run
    case "goals":
    case "said":
    case "companion-said":
    case "companion-ended":
    case "sound":
    case "blocked":
    case "diverged":
    case "uncompared":
      return message.run
    default:
      return null
  }
}

function reduceMessage(state: PageState, message: ServiceMessage): Transition {
  switch (message.op) {
    case "hello":
      return greet(state, message)
    case "worker":
      return still({...state, worker: message.state, workerFault: message.fault})
    case "world":
      return still((state.robots.held === null ? inWorld : withSimulatedRoom)(state, message.world))
    case "robots":
    case "robot":
      return reduceRobotMessage(state, message)
    case "completed":
    case "seen":
      // The request has its answer; nothing on the page depends on it.
      return still(state)
    case "checked":
      return withCheck(state, message)
    case "state":
      return still(withRunState(state, message))
    case "frame":
      return still(withFrame(state, message))
    case "goals": {
      // The goals of a world arrive before a run, too.
      const isCurrent = message.run === state.room.run || state.room.run === null
      return still(isCurrent ? {...state, room: {...state.room, goals: message.goals}} : state)
    }
    case "previewed": {
      const preview = hearPreview(state.room.preview, message.preview)
      const fixPreviews = hearFixPreview(state.room.fixPreviews, message.preview)
      return still({...state, room: {...state.room, preview, fixPreviews}})
    }
    case "diverged":
      return still(withDivergence(state, message))
    case "uncompared":
      return still(withoutComparison(state, message))
    case "checks":
      return withLessons(state, reduceLesson(state.lessons, {kind: "judged", checks: message.checks}))
    case "said": {
      if (!isShown(state.room, message.run)) return still(state)
      const lines = addLine(state.lines, "said", message.text, message.time)
      return still({...state, room: addSpeech(state.room, message.text, message.time), lines})
    }
    case "companion-said":
    case "companion-ended": {
      if (!isShown(state.room, message.run)) return still(state)
      return still({...state, lines: addLine(state.lines, "companion", companionLine(message), message.time)})
    }
    case "sound": {
      const name = soundNames[message.sound]
      if (!isShown(state.room, message.run) || name === undefined) return still(state)
      const played = {...state, lines: addLine(state.lines, "sound", name, message.time)}
      // A recording comes faster than it was.
      const isSilent = state.muted || message.run === state.replay
      return isSilent ? still(played) : {state: played, effects: [{kind: "play", sound: message.sound}]}
    }
    case "safety": {
      const {on, override} = message
      const told = {...state, safety: {on, since: override?.since ?? null}}
      if (override === null || !isShown(state.room, override.run)) return still(told)
      return still({...told, lines: addLine(state.lines, "safety", "", override.since)})
    }
    case "recorded":
      return still({...state, recorded: {run: message.run, file: message.file}})
    case "replayed":
      return still(beginReplay(state, message))
    case "because":
      return explain(state, {kind: "answered", answer: message.answer})
    case "blocked": {
      if (!isShown(state.room, message.run)) return still(state)
      const by = message.bumped ? "bumper" : ""
      return still({...state, lines: addLine(state.lines, "blocked", by, message.time)})
    }
    case "conflict":
      return still(withConflict(state, message))
    case "refusal":
      return still(withRefusal(state, message))
    default:
      return unreachable(message)
  }
}

/// The first robot of the room is that of the run.
function companionLine(message: Message<"companion-said" | "companion-ended">): string {
  const number = message.robot + 1
  if (message.op === "companion-said") return words.companions.said(number, message.text)
  const {problem} = message
  return problem === null
    ? words.companions.ended(number)
    : words.companions.failed(number, worded(problem.sentences?.message ?? null, problem.message))
}

/// Sends a new session of the service the room, the settings, the lesson, the program, and a run that waits for it.
function greet(state: PageState, {session}: Message<"hello">): Transition {
  const run = nextRun(state.run, {kind: "connected"})
  const asked = check({...state, link: "open", session, run})
  const send = (message: Request): Effect => ({kind: "send", message})
  const effects: Effect[] = []
  if (state.worldName !== null) effects.push(send({op: "world", world: state.worldName}))
  effects.push(send(observeMessage(state)))
  if (state.safety.on) effects.push(send({op: "safety", on: true}))
  const watched = watchedNow(state.lessons)
  if (watched !== null) effects.push(send({op: "lesson", step: watched}))
  effects.push(...asked.effects)
  if (state.run.kind === "waiting") effects.push(send(runMessage(asked.state, state.run.run)))
  return {state: asked.state, effects}
}

/// The compiler's answer about the newest text; an answer about an older one changes nothing.
function withCheck(state: PageState, message: Message<"checked">): Transition {
  if (message.id !== state.checks) return still(state)
  const {program} = state.document
  const back = withoutMisreading(state, message)
  if (back !== null) return back
  const compiler = message.problems.map(p => locateProblem(program, p, "compiler"))
  const accepted = !compiler.some(f => f.severity === "error")
  return still({
    ...state,
    declared: message.declarations,
    types: {...message.types, text: program.text},
    parsed: message.groups === null ? state.parsed : withParsed(state.parsed, program.text),
    // Text that is being typed is compared with the answer about it.
    unread:
      message.groups === null || state.pendingText !== null
        ? state.unread
        : withoutRead(state.unread, state.document),
    network: accepted ? {parts: message.parts, text: program.text} : state.network,
    // A text that cannot be read has none: a message can still be sent to the program that runs.
    topics: accepted || message.topics.length > 0 ? message.topics : state.topics,
    findings: {...state.findings, compiler},
    accepted,
  })
}

/// Texts that are remembered: a step of the history joins some quick edits.
const maxParsed = 8

function withParsed(parsed: readonly string[], text: string): readonly string[] {
  return [text, ...parsed.filter(t => t !== text)].slice(0, maxParsed)
}

function withRunState(state: PageState, message: Message<"state">): PageState {
  const run = nextRun(state.run, {kind: "heard", message})
  if (run === state.run) return state
  if (message.state === "running" && message.branches !== undefined && message.branches.length > 0)
    return {...state, run, room: {...state.room, branches: message.branches}}
  if (message.state !== "ended") return {...state, run}
  if (message.run === state.replay) return endReplay({...state, run}, message)
  const isRefused = message.ended === "refused"
  const from = isRefused ? "compiler" : "run"
  const found = message.problems.map(p => locateProblem(state.document.program, p, from))
  const shown = isRefused ? withoutRefusedRun(state, message.run) : state
  return {
    ...shown,
    run,
    findings: {...shown.findings, [from]: found},
    tab: found.some(f => f.severity === "error") ? "problems" : state.tab,
    refused: isRefused ? refusedSockets(state.document) : state.refused,
  }
}

function withFrame(state: PageState, {frame}: Message<"frame">): PageState {
  if (!isShown(state.room, frame.run)) return state
  let {lines} = state
  for (const [i, text] of frame.sensed.entries())
    lines = addLine(lines, "sensed", text, frame.times?.[i] ?? frame.time)
  return {...state, room: addFrame(state.room, frame), lines}
}

/// A changed program repeats the last run only up to this time: what came after it is taken back.
function withDivergence(state: PageState, {run, time}: Message<"diverged">): PageState {
  if (run !== state.room.run) return state
  return {
    ...state,
    room: roomUntil(state.room, time),
    lines: state.lines.filter(line => line.time <= time),
    notice: {kind: "diverged", time},
  }
}

/// Not all commands of the run before are kept. An unchanged program repeats it exactly without a comparison.
function withoutComparison(state: PageState, {run, time}: Message<"uncompared">): PageState {
  const repeated = nodeOf(state.runTree, run)
  const origin = nodeOf(state.runTree, repeated?.from?.run ?? null)
  if (run !== state.room.run || (origin !== undefined && origin.text === repeated?.text)) return state
  return {...state, notice: {kind: "uncompared", time}}
}

function withConflict(state: PageState, message: Message<"conflict">): PageState {
  if (!isShown(state.room, message.run)) return state
  const {workspace, program} = state.document
  const known = new Set(state.findings.run.map(finding => finding.message))
  const found = conflictShown(workspace, message)
    .map(problem => blockFinding(program, problem, message.time))
    .filter(finding => !known.has(finding.message))
  return {...state, findings: {...state.findings, run: [...state.findings.run, ...found]}}
}

/// A refusal about robots, such as of a code that the page gave by itself, is shown in their dialog, any other as a notice.
function withRefusal(state: PageState, {message, hint}: Message<"refusal">): PageState {
  const {offered, code} = state.robots
  if (state.dialog === "robots" || (offered?.locked && code !== null)) return withRobotRefusal(state, message)
  return {...state, notice: {kind: "refusal", message, hint}}
}
