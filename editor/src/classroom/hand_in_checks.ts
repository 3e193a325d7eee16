/// Checks of all hand-ins of a task: the teacher's choices, the request made of them, the results, the rooms that were tried, and the project of a pupil's program in one of them (protocol §11).

import {
  firstChoices,
  type PropertyChoices,
  runSeconds,
  type TestedRoom,
  testedRoom,
  wordsOf,
} from "../rooms/room_test.ts"
import {batchProblem} from "../state/batch_answer.ts"
import {list, number, object, oneOf, optional, parseJson, string} from "../state/decode.ts"

/// Rooms that need no room to begin with, and the room of each hand-in.
export const roomFamilies = ["own", "obstacles", "maze", "pits"] as const
type RoomFamily = (typeof roomFamilies)[number]

export interface CheckChoices extends PropertyChoices {
  /// With a program of the teacher's: its room, and rooms like it.
  readonly where: RoomFamily | {readonly program: string}
  readonly rooms: number
  readonly seed: number
}

export const firstCheck: CheckChoices = {
  properties: firstChoices.properties,
  amounts: firstChoices.amounts,
  where: "own",
  rooms: 10,
  seed: 1,
}

/// Rooms of a check; of one alone it is the room that was chosen.
export const checkedRoomCounts = [1, 5, 10, 20, 50, 100] as const

export interface CheckRequest {
  readonly op: "check-all"
  readonly task: number
  readonly family: RoomFamily | "room"
  readonly rooms: number
  readonly seed: number
  readonly seconds: number
  readonly properties: string
  readonly world?: unknown
}

/// Checks the hand-ins without a result as the newest check of all has checked the others.
export interface NewCheckRequest {
  readonly op: "check-new"
  readonly task: number
}

/// `read` gives the project file of a program of the teacher's.
export function checkRequest(
  task: number,
  choices: CheckChoices,
  read: (program: string) => string | null,
): CheckRequest {
  const {where, rooms, seed} = choices
  const properties = wordsOf(choices)
  const test = {op: "check-all", task, rooms, seed, seconds: runSeconds, properties} as const
  if (typeof where === "string") return {...test, family: where}
  return {...test, family: "room", world: roomOf(read(where.program) ?? "")}
}

/// The room of a project file: a world as JSON, or the name of one of the gallery.
export const roomOf = (project: string): unknown => projectOf(project).world ?? defaultRoom

/// Room of a project that names none (`gallery.py`).
const defaultRoom = "room"

/// Programs that were checked, of so many, and the rooms tried.
export interface Checking {
  /// Counts the checks since the service started.
  readonly number: number
  readonly task: number | null
  readonly done: number
  readonly of: number
  readonly rooms: number
}

export const faults = ["compile", "room", "time", "lost"] as const
type Fault = (typeof faults)[number]

export interface CheckResult {
  /// Seconds since 1970.
  readonly checked: number
  readonly rooms: number
  readonly passed: number
  /// Why there are no outcomes; `problems` are those of a program that does not compile.
  readonly fault: Fault | null
  readonly problems: readonly string[]
  readonly worst: TestedRoom | null
  /// The rooms that the service has sent so far, worst first; empty before they were asked for.
  readonly tried: readonly TestedRoom[]
}

export const checkResult = object<CheckResult>(get => ({
  checked: get("checked", number),
  rooms: get("rooms", number),
  passed: get("passed", number),
  fault: get("fault", optional(oneOf(...faults), null)),
  problems: get("problems", list(batchProblem)),
  worst: get("worst", optional(testedRoom, null)),
  tried: [],
}))

export const checking = object<Checking>(get => ({
  number: get("number", number),
  task: get("task", optional(number, null)),
  done: get("done", number),
  of: get("of", number),
  rooms: get("rooms", number),
}))

/// The results of a task by pupil.
export type Results = ReadonlyMap<number, CheckResult>

/// Rooms of a hand-in, which follow `after` others of earlier messages.
export interface RoomsOfResult {
  readonly task: number
  readonly pupil: number
  readonly after: number
  readonly rooms: readonly TestedRoom[]
}

export const roomsOfResult = object<RoomsOfResult>(get => ({
  task: get("task", number),
  pupil: get("pupil", number),
  after: get("after", number),
  rooms: get("rooms", list(testedRoom)),
}))

/// The results of a task with the rooms of a message.
export function withRooms(results: Results, {pupil, after, rooms}: RoomsOfResult): Results {
  const result = results.get(pupil)
  if (result === undefined) return results
  return new Map([...results, [pupil, {...result, tried: [...result.tried.slice(0, after), ...rooms]}]])
}

/// The number of hand-ins that the checks have left out, as those that came while one went on; 0 before the first check.
export function uncheckedCount(
  {handedIn, checked}: {readonly handedIn: readonly {readonly pupil: number}[]; readonly checked: boolean},
  results: Results,
  {task}: Checking,
): number {
  if (task !== null || !checked) return 0
  return handedIn.filter(({pupil}) => !results.has(pupil)).length
}

/// Pupils with their results: programs without outcomes first, then those that passed in the fewest rooms, the earliest failure first.
export function worstFirst<Pupil extends {readonly id: number}>(
  pupils: readonly Pupil[],
  results: Results,
): readonly (readonly [Pupil, CheckResult])[] {
  const rows = pupils.flatMap(pupil => {
    const result = results.get(pupil.id)
    return result === undefined ? [] : [[pupil, result] as const]
  })
  const share = ({fault, passed, rooms}: CheckResult) => (fault !== null ? -1 : passed / rooms)
  const time = ({worst}: CheckResult) => worst?.time ?? 0
  return rows.sort(([, a], [, b]) => share(a) - share(b) || time(a) - time(b))
}

/// The project file of a pupil's program with a room.
export function projectInRoom(text: string, name: string, world: unknown): string {
  return JSON.stringify({...projectOf(text), name, world})
}

interface Project {
  readonly world?: unknown
  readonly [field: string]: unknown
}

/// A text that is no project file is a program itself.
function projectOf(text: string): Project {
  const value = parseJson(text)
  const isProject = typeof value === "object" && value !== null && !Array.isArray(value)
  return isProject ? {...value} : {rosy: 1, haskell: text}
}

/// A message's pupil with the program, the number of the room and the room as JSON, and the seed.
export interface RunInRoom {
  readonly pupil: number
  readonly room: number
  readonly name: string
  readonly text: string | null
  readonly world: unknown
  readonly seed: number
}

export const runInRoom = object<RunInRoom>(get => ({
  pupil: get("pupil", number),
  room: get("room", number),
  name: get("name", string),
  text: get("text", optional(string, null)),
  world: get("world", value => value),
  seed: get("seed", number),
}))
