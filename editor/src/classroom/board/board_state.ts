/// State of the teacher's board as signals, and the changes that messages make.

import {type Signal, signal} from "@preact/signals"
import type {
  BoardTask,
  DoorShown,
  LessonShown,
  Place,
  PupilShown,
  PupilsAdded,
  StoreFault,
  StudyShown,
  Suspended,
} from "../../wire/classroom/board_messages.generated.ts"
import type {Checking} from "../../wire/classroom/check_messages.generated.ts"
import type {OwnComment} from "../../wire/classroom/pupil_messages.generated.ts"
import type {World} from "../../worlds/world.ts"
import type {BoardMessage} from "../messages/board_messages.ts"
import {type Results, type RoomsOfResult, withRooms} from "../messages/hand_in_checks.ts"
import type {ProjectorChoice} from "../messages/projector_choice.ts"
import type {SharingBounds, SharingMessage} from "../messages/shared_messages.ts"

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
  /// The last suspension of the service, until the teacher has closed the message.
  readonly suspended: Omit<Suspended, "op"> | null
  /// One screen with all pupils takes the place of the tools and the cards.
  readonly isOverview: boolean
  /// Most of the class has not run for long.
  readonly mostIdle: boolean
  readonly pupils: readonly PupilShown[]
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
  readonly lessons: readonly LessonShown[]
  /// Why the last task was not opened, or the last change not stored.
  readonly taskRefused: string | null
  readonly checking: Omit<Checking, "op">
  /// By task.
  readonly results: ReadonlyMap<number, Results>
  readonly checkRefused: string | null
  readonly door: Omit<DoorShown, "op">
  readonly study: Omit<StudyShown, "op">
  /// What became of the last list of names; why the last change of a pupil was not made.
  readonly added: Omit<PupilsAdded, "op"> | null
  readonly rosterRefused: string | null
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
  suspended: null,
  isOverview: false,
  mostIdle: false,
  pupils: [],
  shown: null,
  comments: [],
  commentRefused: null,
  sharing: null,
  sharingLine: null,
  sharingRefused: null,
  projecting: null,
  projectingTask: null,
  projectorSight: {named: false, program: false},
  sightAsked: null,
  tasks: [],
  lessons: [],
  taskRefused: null,
  checking: {number: 0, task: null, done: 0, of: 0, rooms: 0},
  results: new Map(),
  checkRefused: null,
  door: {locked: false, removed: []},
  study: {contact: null, takingPart: 0},
  added: null,
  rosterRefused: null,
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
