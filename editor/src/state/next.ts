/// One step of the page: what happened turns one state into the next, and says what to send. Pure.

import {edit, isChanged, openEditor} from "../worlds/editor.ts"
import {type Fault, readWorld} from "../worlds/read.ts"
import {startFault} from "../worlds/standing.ts"
import type {World} from "../worlds/world.ts"
import {worldText, writeWorld} from "../worlds/write.ts"
import {withShown, withView} from "./arrangement.ts"
import {parseJson} from "./decode.ts"
import {movedFix} from "./fixes.ts"
import {drives, letGo, robotEvent, robotHeard, robotRefused} from "./helm.ts"
import {type Document, redo, remember, undo} from "./history.ts"
import type {ServiceMessage} from "./messages.ts"
import type {Order, PageEvent, PageState, Step} from "./page.ts"
import {type Finding, locate, type Mover, mover, rangeMoved} from "./program.ts"
import {
  addLine,
  clearRoom,
  hear,
  isShown,
  ledNames,
  sensedBetween,
  showFrame,
  shownFrame,
  soundNames,
} from "./room.ts"
import {isActive, nextRun} from "./run.ts"
import {unreachable} from "./unreachable.ts"

const still = (state: PageState): Step => ({state, orders: []})
const sending = (state: PageState, ...messages: (Order & {kind: "send"})["message"][]): Step => ({
  state,
  orders: messages.map(message => ({kind: "send", message})),
})

export function next(state: PageState, event: PageEvent): Step {
  switch (event.kind) {
    case "link-lost": {
      // A robot in this page's hands stands now, and is anybody's.
      const lost = state.robots.held === null ? state : letGo(state)
      const run = nextRun(state.run, {kind: "lost"})
      return still({...lost, link: "lost", accepted: false, run, robots: {...lost.robots, offered: null}})
    }
    case "heard":
      return heard(state, event.message)
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
      return sending({...state, run, room, lines: [], findings: {...state.findings, run: []}}, {op: "reset"})
    }
    case "looked-back": {
      const last = state.room.frame?.time ?? 0
      // The end of the run is now: from there the picture goes on.
      const lookedAt = event.time === null || event.time >= last ? null : event.time
      const looking = {...state, room: {...state.room, lookedAt}}
      // A real robot does not wait while somebody looks back.
      const stands =
        lookedAt !== null && state.clock === "going" && isActive(state.run) && state.robots.held === null
      return stands ? sending({...looking, clock: "standing"}, {op: "pause"}) : still(looking)
    }
    case "hand":
      return state.run.kind === "running" && state.robots.held === null
        ? sending(present(state), {op: "input", ...event.hand})
        : still(state)
    case "held":
      return still({...state, room: {...state.room, held: event.thing}})
    case "robots-unlocked":
    case "robot-taken":
    case "robot-left":
    case "estop-pressed":
    case "free-pressed":
    case "out-of-sight":
      return robotEvent(state, event)
    case "charted":
      return still({...state, charts: event.quantities})
    case "chart-span":
      return still({...state, chartSpan: event.span})
    case "pause-pressed":
      return isActive(state.run) && state.clock === "going" && !drives(state)
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
    case "opened": {
      const {opened} = event
      const room = clearRoom(state.room, state.robots.held === null ? null : state.runs)
      const fresh: PageState = {
        ...state,
        name: opened.name,
        saved: "saved",
        document: opened.document,
        history: opened.history,
        // Where a program without a room of its own is opened is its room from then on.
        worldName: opened.world ?? state.worldName,
        run: nextRun(state.run, {kind: "reset-pressed"}),
        room,
        lines: [],
        findings: {compiler: [], run: []},
        accepted: false,
        selected: null,
        welcome: opened.welcome ? "fresh" : "over",
        dialog: null,
        notice: null,
      }
      const asked = check(fresh)
      if (state.link !== "open") return still(asked.state)
      // Choosing a room ends a run; without a room of its own a project gets the room as it was, reset.
      const ready =
        opened.world === null ? ({op: "reset"} as const) : ({op: "world", world: opened.world} as const)
      return {state: asked.state, orders: [{kind: "send", message: ready}, ...asked.orders]}
    }
    case "program-changed": {
      const history = remember(state.history, state.document, event.by, event.at)
      return changeTo({...state, history}, event.document)
    }
    case "analysed":
      return still(state.document === event.before ? {...state, document: event.document} : state)
    case "undo-pressed": {
      const back = undo(state.history, state.document)
      return back === null ? still(state) : changeTo({...state, history: back.history}, back.document)
    }
    case "redo-pressed": {
      const on = redo(state.history, state.document)
      return on === null ? still(state) : changeTo({...state, history: on.history}, on.document)
    }
    case "selected":
      return still({...state, selected: event.block, selectedIn: event.in})
    case "renamed":
      return still({...state, name: event.name, saved: "changed"})
    case "stored":
      return still({
        ...state,
        saved: event.ok ? "saved" : "failed",
        notice: event.ok ? state.notice : {kind: "not-saved"},
      })
    case "world-chosen":
      return sending(
        {
          ...state,
          worldName: event.world,
          saved: "changed",
          run: nextRun(state.run, {kind: "reset-pressed"}),
          room: clearRoom(state.room, null),
          dialog: null,
        },
        {op: "world", world: event.world},
      )
    case "world-editor-opened": {
      const {world} = state.room
      // A real robot has no room that could be changed.
      if (world === null || state.robots.held !== null) return still(state)
      return still({...state, worldEditor: openEditor(world)})
    }
    case "world-edited":
      return still(
        state.worldEditor === null ? state : {...state, worldEditor: edit(state.worldEditor, event.edit)},
      )
    case "world-editor-closed":
      return closeWorldEditor(state, event.keep)
    case "world-file-wanted":
      return {state, orders: [{kind: "pick-world"}]}
    case "world-file-made": {
      const world = state.worldEditor?.world ?? state.room.world
      if (world === null) return still(state)
      return {state, orders: [{kind: "save-world", name: world.name, text: worldText(world)}]}
    }
    case "world-file-read":
      return readWorldFile(state, event.name, event.text)
    case "rooms-read":
      return still({...state, rooms: event.rooms})
    case "worlds-listed":
      return still({...state, worlds: event.worlds})
    case "gallery":
      return still({...state, gallery: event.gallery})
    case "dialog":
      return still({...state, dialog: event.dialog})
    case "notice":
      return still({...state, notice: event.notice})
    case "view":
      return still({...state, arrangement: withView(state.arrangement, event.view)})
    case "arranged":
      return still({...state, arrangement: event.arrangement, arranging: null})
    case "arranging":
      return still({...state, arranging: event.arranging})
    case "region":
      return still({...state, region: event.region})
    case "size":
      return still({...state, size: event.size})
    case "tab":
      return still({...state, tab: event.tab})
    case "theme":
      return still({...state, theme: event.theme})
    case "layout":
      return still({...state, layout: event.layout})
    case "muted":
      return still({...state, muted: event.muted})
    case "trail":
      return still({...state, trail: event.trail})
    case "follows":
      return still({...state, follows: event.follows})
    case "films":
      return still({...state, films: event.films})
    default:
      return unreachable(event)
  }
}

const moved =
  (move: Mover) =>
  (finding: Finding): Finding =>
    finding.range === null
      ? finding
      : {
          ...finding,
          range: rangeMoved(move, finding.range),
          fixes: finding.fixes.map(f => movedFix(move, f)),
        }

/// Makes another document the program. What the last run said was about the old one.
function changeTo(state: PageState, document: Document): Step {
  const changed: PageState = {...state, document, saved: "changed"}
  if (document.program.text === state.document.program.text) return still(changed)
  const move = mover(state.document.program.text, document.program.text)
  return check({
    ...changed,
    // What the compiler said stands, moved along, until it has read the new text: marks do not flicker while typing.
    findings: {compiler: state.findings.compiler.map(moved(move)), run: []},
    welcome: state.welcome === "ran" ? "over" : state.welcome,
  })
}

/// A room from a file: into the editor when it is open, or else it is the room now.
function readWorldFile(state: PageState, name: string, text: string | null): Step {
  const unreadable = (fault: Fault) =>
    still({...state, notice: {kind: "unreadable-world", name, path: fault.path, why: fault.why}})
  const value = parseJson(text?.replace(/^\uFEFF/, "") ?? "")
  if (value === undefined) return unreadable({path: "", why: "the file is damaged or cut short."})
  const read = readWorld(value)
  if (read.kind === "fault") return unreadable(read.fault)
  const {world} = read
  const open = {...state, notice: null}
  const {worldEditor} = state
  if (worldEditor !== null) return still({...open, worldEditor: edit(worldEditor, {kind: "change", world})})
  const wrong = startFault(world)
  if (wrong !== null) return unreadable(wrong)
  return takeWorld(open, world)
}

/// Metres: seen whole, a longer room makes a dot of the robot and a scribble of its trail, so the picture goes with it.
const longestSeenWhole = 12

/// The simulator's room as it stands now. A room that the learner has just come into is shown so that the robot is seen;
/// in one that they know already, the picture stays as they like it.
function inWorld(state: PageState, world: World): PageState {
  const known = state.room.world
  const same = known !== null && known.name === world.name && `${known.size}` === `${world.size}`
  const follows = same ? state.follows : Math.max(...world.size) > longestSeenWhole
  return {...state, follows, room: {...state.room, world, idle: true}}
}

/// Makes a world the room, and saves it with the program.
function takeWorld(state: PageState, world: World): Step {
  const file = writeWorld(world)
  const taken: PageState = {
    ...state,
    worldName: file,
    saved: "changed",
    run: nextRun(state.run, {kind: "reset-pressed"}),
    // Below a real robot its floor stays.
    room: state.robots.held === null ? {...clearRoom(state.room, null), world} : state.room,
  }
  return state.link === "open" ? sending(taken, {op: "world", world: file}) : still(taken)
}

/// The changed room goes to the simulator and into the project; one that cannot be used stays in the editor.
function closeWorldEditor(state: PageState, keep: boolean): Step {
  const editor = state.worldEditor
  if (editor === null) return still(state)
  const closed = {...state, worldEditor: null}
  if (!keep || !isChanged(editor)) return still(closed)
  if (startFault(editor.world) !== null) return still(state)
  // A room of the gallery stays what it is: the changed one is another.
  const {name} = editor.world
  const own = state.worlds.includes(name) ? {...editor.world, name: `my ${name}`, title: ""} : editor.world
  return takeWorld(closed, own)
}

/// Ends looking back.
function present(state: PageState): PageState {
  return {...state, room: {...state.room, lookedAt: null}}
}

function start(state: PageState, seed: number | null): Step {
  const connected = state.link === "open"
  const run = state.runs + 1
  const started: PageState = {
    ...state,
    run: nextRun(state.run, {kind: "run-pressed", connected, run}),
    runs: run,
    seed,
    clock: "going",
    room: clearRoom(state.room, run),
    lines: [],
    findings: {...state.findings, run: []},
    welcome: state.welcome === "fresh" ? "ran" : state.welcome,
    tab: state.tab === "problems" ? "console" : state.tab,
    notice: null,
    region: state.size === "phone" ? "room" : state.region,
    // Nobody runs a robot without looking at it.
    arrangement: withShown(state.arrangement, "room", true),
  }
  return connected ? sending(started, runMessage(started, run)) : still(started)
}

function runMessage(state: PageState, run: number) {
  const {seed} = state
  const luck = seed === null ? {} : {seed}
  return {op: "run", run, source: state.document.program.text, ...luck, speed: state.speed} as const
}

/// Asks the compiler about the text as it is now.
function check(state: PageState): Step {
  const id = state.checks + 1
  const asked = {...state, checks: id}
  if (state.link !== "open" || state.document.program.text === "") return still(asked)
  return sending(asked, {op: "check", id, source: state.document.program.text})
}

function heard(state: PageState, message: ServiceMessage): Step {
  switch (message.op) {
    case "hello": {
      const back: PageState = {
        ...state,
        link: "open",
        session: message.session,
        run: nextRun(state.run, {kind: "connected"}),
      }
      const asked = check(back)
      const orders: Order[] = []
      if (state.worldName !== null)
        orders.push({kind: "send", message: {op: "world", world: state.worldName}})
      orders.push(...asked.orders)
      if (state.run.kind === "waiting")
        orders.push({kind: "send", message: runMessage(asked.state, state.run.run)})
      return {state: asked.state, orders}
    }
    case "worker":
      return still({...state, worker: message.state})
    case "world":
      return state.robots.held === null ? still(inWorld(state, message.world)) : still(state)
    case "robots":
    case "robot":
      return robotHeard(state, message)
    case "completed":
      // Whoever asked has the answer; nothing on the page depends on it.
      return still(state)
    case "checked": {
      if (message.id !== state.checks) return still(state)
      const compiler = message.problems.map(p => locate(state.document.program, p, "compiler"))
      const accepted = !compiler.some(f => f.severity === "error")
      return still({
        ...state,
        declared: message.declarations,
        types: {...message.types, text: state.document.program.text},
        findings: {...state.findings, compiler},
        accepted,
      })
    }
    case "state": {
      const run = nextRun(state.run, {kind: "heard", message})
      if (run === state.run) return still(state)
      if (message.state !== "ended") return still({...state, run})
      const found = message.problems.map(p =>
        locate(state.document.program, p, message.ended === "refused" ? "compiler" : "run"),
      )
      const findings =
        message.ended === "refused" ? {...state.findings, compiler: found} : {...state.findings, run: found}
      const tab = found.some(f => f.severity === "error") ? "problems" : state.tab
      return still({...state, run, findings, tab})
    }
    case "frame": {
      if (!isShown(state.room, message.frame.run)) return still(state)
      const {frame} = message
      let {lines} = state
      for (const text of sensedBetween(state.room.frame, frame))
        lines = addLine(lines, "sensed", text, frame.time)
      return still({...state, room: showFrame(state.room, frame), lines})
    }
    case "goals":
      // A world tells its goals before a run, too.
      return message.run === state.room.run || state.room.run === null
        ? still({...state, room: {...state.room, goals: message.goals}})
        : still(state)
    case "said": {
      if (!isShown(state.room, message.run)) return still(state)
      const lines = addLine(state.lines, "said", message.text, message.time)
      return still({...state, room: hear(state.room, message.text, message.time), lines})
    }
    case "sound": {
      const name = soundNames[message.sound]
      if (!isShown(state.room, message.run) || name === undefined) return still(state)
      const lines = addLine(state.lines, "sound", name, message.time)
      const played = {...state, lines}
      return state.muted ? still(played) : {state: played, orders: [{kind: "play", sound: message.sound}]}
    }
    case "refusal":
      // What is about robots is said in their dialog.
      if (state.dialog === "robots" || state.robots.offered?.locked)
        return still(robotRefused(state, message.message))
      return still({...state, notice: {kind: "refusal", message: message.message, hint: message.hint}})
    default:
      return unreachable(message)
  }
}

/// What a screen reader and a test can read of the robot; before a run it stands at the start.
export function readout(state: PageState): {readonly [key: string]: string} | null {
  const {world} = state.room
  const frame = shownFrame(state.room)
  const pose = frame ?? world?.start
  if (pose === undefined) return null
  const led = (value: number) => ledNames[value] ?? "Black"
  const degrees = Math.round((pose.theta * 180) / Math.PI)
  const sides = (bits: number) =>
    [bits & 4 ? "left" : "", bits & 2 ? "centre" : "", bits & 1 ? "right" : ""].filter(Boolean).join(" ")
  const wheels = (bits: number) => [bits & 2 ? "left" : "", bits & 1 ? "right" : ""].filter(Boolean).join(" ")
  return {
    time: (frame?.time ?? 0).toFixed(2),
    x: pose.x.toFixed(3),
    y: pose.y.toFixed(3),
    heading: `${((degrees % 360) + 360) % 360}°`,
    speed: (frame?.v ?? 0).toFixed(3),
    bumpers: sides(frame?.bumpers ?? 0),
    cliffs: sides(frame?.cliffs ?? 0),
    wheels: wheels(frame?.wheels ?? 0),
    led1: led(frame?.led1 ?? 0),
    led2: led(frame?.led2 ?? 0),
  }
}
