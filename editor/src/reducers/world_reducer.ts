/// Reducer for the room: a chosen room, a room of a test, the room editor, files of rooms. Pure.

import {withoutMark} from "@rosy/codegen/text-file"
import {noFixPreviews} from "../state/messages/fix_previews.ts"
import type {WorldEvent} from "../state/page_events.ts"
import {isTestRoomShown, type PageState} from "../state/page_state.ts"
import {inOtherRoom, isFreePlace} from "../state/runs/companions.ts"
import {clearRoom} from "../state/runs/room_state.ts"
import {nextRun} from "../state/runs/run_state.ts"
import {noRuns} from "../state/runs/run_tree.ts"
import {sending, still, type Transition, unreachable} from "../state/transition.ts"
import {parseJson} from "../wire/decode.ts"
import {words} from "../words/index.ts"
import {wordedText} from "../words/worker_sentences.ts"
import {edit, isChanged, openEditor} from "../worlds/editor_state.ts"
import {startFault} from "../worlds/start_validation.ts"
import {isLarge, type World} from "../worlds/world.ts"
import {readWorld} from "../worlds/world_decoder.ts"
import {worldText, writeWorld} from "../worlds/world_encoder.ts"
import type {Fault} from "../worlds/world_fields.ts"
import {reduceRunEvent} from "./run_reducer.ts"

/// Applies a choice of the room, or an edit of it.
export function reduceWorldEvent(state: PageState, event: WorldEvent): Transition {
  switch (event.kind) {
    case "world-chosen":
      return chooseWorld(state, event.world)
    case "world-taken": {
      const wrong = startFault(event.world)
      if (wrong === null) return takeWorld({...state, notice: null}, event.world)
      return still({...state, notice: {kind: "unreadable-world", name: event.world.name, ...wrong}})
    }
    case "test-room-opened": {
      // A second room of a test does not replace the learner's own.
      const {replacedRoom: before, worldName} = state
      const own = before !== null && isTestRoomShown(state) ? before.own : (worldName ?? firstRoom)
      return takeWorld({...state, replacedRoom: {by: event.world.name, own}, dialog: null}, event.world)
    }
    case "own-room-restored":
      return restoreOwnRoom(state)
    case "companions-chosen": {
      const {companions} = event
      if (state.room.run === null) return still({...state, companions})
      const {state: reset, effects} = reduceRunEvent(state, {kind: "reset-pressed"})
      return {state: {...reset, companions}, effects}
    }
    case "companions-stored":
      return still({...state, companions: event.companions})
    case "companion-placed": {
      const {world, run} = state.room
      const others = state.companions.filter((_, i) => i !== event.companion)
      if (world === null || run !== null) return still(state)
      const isTaken = !isFreePlace(world, event.place, others)
      // Before it is dropped the hand may still take it to a free place.
      const notice = event.isDropped ? noticed(state.notice, isTaken, words.companions.taken) : state.notice
      if (isTaken) return still({...state, notice})
      const companions = state.companions.map((one, i) =>
        i === event.companion ? {...one, ...event.place} : one,
      )
      return still({...state, companions, notice})
    }
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
      return {state, effects: [{kind: "pick-world"}]}
    case "world-file-made": {
      const world = state.worldEditor?.world ?? state.room.world
      if (world === null) return still(state)
      return {state, effects: [{kind: "save-world", name: world.name, text: worldText(world)}]}
    }
    case "world-file-read":
      return readWorldFile(state, event.name, event.text)
    default:
      return unreachable(event)
  }
}

/// A room from a file: into the editor when it is open, or else it is the room now.
function readWorldFile(state: PageState, name: string, text: string): Transition {
  const unreadable = (fault: Fault) =>
    still({...state, notice: {kind: "unreadable-world", name, path: fault.path, why: fault.why}})
  const value = parseJson(withoutMark(text))
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

/// The room of a program that names none.
const firstRoom = "room"

function chooseWorld(state: PageState, world: string): Transition {
  const chosen: PageState = {
    ...state,
    worldName: world,
    saved: "changed",
    run: nextRun(state.run, {kind: "reset-pressed"}),
    room: clearRoom(state.room, state.robots.held === null ? null : state.runs),
    runTree: noRuns,
    dialog: null,
  }
  return sending(chosen, {op: "world", world})
}

function restoreOwnRoom(state: PageState): Transition {
  if (state.replacedRoom === null) return still(state)
  const {own} = state.replacedRoom
  const back: PageState = {...state, replacedRoom: null, dialog: null}
  if (typeof own === "string") return chooseWorld(back, own)
  const read = readWorld(own)
  return read.kind === "world" ? takeWorld(back, read.world) : still(state)
}

/// The simulator's room. The view follows the robot in a new room that is too large to be shown whole; in the same room as before the
/// learner's choice stays.
export function inWorld(state: PageState, world: World): PageState {
  const known = state.room.world
  const same = known !== null && known.name === world.name && `${known.size}` === `${world.size}`
  const follows = same ? state.follows : isLarge(world)
  const companions = inOtherRoom(world, state.companions)
  const isCrowded = companions.length < state.companions.length
  const notice = isCrowded ? noticed(state.notice, true, words.companions.noPlace) : state.notice
  return {
    ...state,
    follows,
    companions,
    notice,
    room: {...state.room, world, idle: true, fixPreviews: noFixPreviews},
  }
}

/// The notice with this message while something is refused, which disappears when it is not.
function noticed(notice: PageState["notice"], isRefused: boolean, message: string): PageState["notice"] {
  if (isRefused) return {kind: "refusal", message, hint: ""}
  return notice?.kind === "refusal" && notice.message === message ? null : notice
}

/// Makes a world the room, and saves it with the program.
function takeWorld(state: PageState, world: World): Transition {
  const file = writeWorld(world)
  const taken: PageState = {
    ...state,
    worldName: file,
    saved: "changed",
    run: nextRun(state.run, {kind: "reset-pressed"}),
    // Below a real robot its floor stays.
    room: state.robots.held === null ? {...clearRoom(state.room, null), world} : state.room,
    runTree: noRuns,
  }
  return state.link === "open" ? sending(taken, {op: "world", world: file}) : still(taken)
}

/// The changed room goes to the simulator and into the project; one that cannot be used stays in the editor.
function closeWorldEditor(state: PageState, keep: boolean): Transition {
  const editor = state.worldEditor
  if (editor === null) return still(state)
  const closed = {...state, worldEditor: null}
  if (!keep || !isChanged(editor)) return still(closed)
  if (startFault(editor.world) !== null) return still(state)
  // A room of the gallery stays what it is: the changed one is another.
  const {name, title} = editor.world
  const own = state.worlds.includes(name)
    ? {
        ...editor.world,
        name: `my ${name}`,
        title: words.world.changed(title === "" ? name : wordedText(title)),
      }
    : editor.world
  return takeWorld(closed, own)
}
