/// State of the teacher's board as signals, and the changes that messages make.

import {type Signal, signal} from "@preact/signals"
import type {World} from "../worlds/world.ts"
import type {BoardMessage, BoardTask, Place, PupilOnBoard} from "./board_messages.ts"
import type {OwnComment, StoreFault} from "./class_messages.ts"
import {type Checking, type Results, type RoomsOfResult, withRooms} from "./hand_in_checks.ts"
import type {ProjectorChoice} from "./projector_choice.ts"
import type {SharingBounds, SharingMessage} from "./shared_messages.ts"

export interface ShownProgram {
  readonly pupil: number
  readonly nickname: string
  readonly name: string
  readonly address: string
  /// Its identifier; `null` for a hand-in, which takes no comments on places.
  readonly program: string | null
  /// The project file that the pupil has saved since.
  readonly newer: string | null
}

export interface Board extends ProjectorChoice {
  readonly link: "connecting" | "open" | "lost"
  readonly class: {readonly code: string; readonly addresses: readonly string[]} | null
  readonly refused: string | null
  /// Why nothing can be stored now.
  readonly storeFault: StoreFault | null
  readonly attention: string | null
  readonly pupils: readonly PupilOnBoard[]
  /// A pupil's program to look at: its link for an embedded page.
  readonly shown: ShownProgram | null
  /// The comments on the programs of the pupil whose program was opened last.
  readonly comments: readonly OwnComment[]
  /// Why the last comment was not stored.
  readonly commentRefused: string | null
  /// Editing the shown program together with its pupil.
  readonly sharing: "asked" | "on" | "declined" | "ended" | null
  /// The line of the pupil's cursor.
  readonly sharingLine: number | null
  /// Why the pupil was not asked.
  readonly sharingRefused: string | null
  readonly tasks: readonly BoardTask[]
  /// Why the last task was not opened, or the last change not stored.
  readonly taskRefused: string | null
  readonly checking: Checking
  /// By task.
  readonly results: ReadonlyMap<number, Results>
  readonly checkRefused: string | null
  /// Pupils that are selected on their cards, to send something to; empty for all.
  readonly selected: ReadonlySet<number>
  /// What the last command did.
  readonly said: string
}

export const board: Signal<Board> = signal({
  link: "connecting",
  class: null,
  refused: null,
  storeFault: null,
  attention: null,
  pupils: [],
  shown: null,
  comments: [],
  commentRefused: null,
  sharing: null,
  sharingLine: null,
  sharingRefused: null,
  projecting: null,
  projectorSight: {named: false, program: false},
  sightAsked: null,
  tasks: [],
  taskRefused: null,
  checking: {number: 0, task: null, done: 0, of: 0, rooms: 0},
  results: new Map(),
  checkRefused: null,
  selected: new Set(),
  said: "",
})
/// Rooms and robots change ten times a second; each miniature reads its own.
export const rooms = signal<ReadonlyMap<number, World>>(new Map())
export const places = signal<ReadonlyMap<number, Place>>(new Map())
/// Called with what the frame of the shown program has to know while it is edited together.
export const sharingListeners = new Set<(message: SharingMessage | SharingBounds) => void>()
export const change = (to: Partial<Board>) => {
  board.value = {...board.value, ...to}
}

/// The results of all tasks with the rooms of a message.
export const withRoomsOfTask = (
  results: ReadonlyMap<number, Results>,
  message: RoomsOfResult,
): ReadonlyMap<number, Results> =>
  new Map([...results, [message.task, withRooms(results.get(message.task) ?? new Map(), message)]])

/// The results after a message; `null` takes one away.
export function withResult(
  results: ReadonlyMap<number, Results>,
  {task, pupil, result}: BoardMessage & {readonly op: "result"},
): ReadonlyMap<number, Results> {
  const changed = new Map(results.get(task))
  if (result === null) changed.delete(pupil)
  else changed.set(pupil, result)
  return new Map([...results, [task, changed]])
}
