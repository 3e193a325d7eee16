/// Checks of all hand-ins of a task: the teacher's choices, the request made of them, the results, the rooms that were tried, and the project of a pupil's program in one of them (protocol §11).

import {batchProblem} from "../../jobs/batch_answer.ts"
import {
  firstChoices,
  type PropertyChoices,
  runSeconds,
  type TestedRoom,
  testedRoom,
  wordsOf,
} from "../../jobs/room_test.ts"
import {isOwnLesson} from "../../lesson_files/lesson_file.ts"
import type {
  CheckAll,
  Checking,
  CheckResult as ShownResult,
} from "../../wire/classroom/check_messages.generated.ts"
import {parseJson} from "../../wire/decode.ts"

/// What the lesson of each hand-in checks, in the lesson's rooms; the room of each hand-in; and rooms that need no room to begin with.
export const roomFamilies = ["lesson", "own", "obstacles", "maze", "pits"] as const
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

/// `read` gives the project file of a program of the teacher's.
export function checkRequest(
  task: number,
  choices: CheckChoices,
  read: (program: string) => string | null,
): CheckAll {
  const {where, rooms, seed} = choices
  // The lesson has properties and rooms of its own.
  if (where === "lesson")
    return {op: "check-all", task, rooms: 1, seed: 1, seconds: runSeconds, properties: "", family: where}
  const properties = wordsOf(choices)
  const test = {op: "check-all", task, rooms, seed, seconds: runSeconds, properties} as const
  if (typeof where === "string") return {...test, family: where}
  return {...test, family: "room", world: roomOf(read(where.program) ?? "")}
}

/// The room of a project file: a world as JSON, or the name of one of the gallery.
export const roomOf = (project: string): unknown => projectOf(project).world ?? defaultRoom

/// Room of a project that names none (`gallery.py`).
const defaultRoom = "room"

/// The result of a hand-in.
export interface CheckResult extends Pick<ShownResult, "checked" | "rooms" | "passed" | "fault" | "unmet"> {
  /// In the language of the page.
  readonly problems: readonly string[]
  readonly worst: TestedRoom | null
  /// The rooms that the service has sent so far, worst first; empty before they were asked for.
  readonly tried: readonly TestedRoom[]
}

export function checkResult(result: ShownResult): CheckResult {
  const {checked, rooms, passed, fault, unmet, problems, worst} = result
  const shown = worst === null ? null : testedRoom(worst)
  return {checked, rooms, passed, fault, unmet, problems: problems.map(batchProblem), worst: shown, tried: []}
}

/// The results of a task by pupil.
export type Results = ReadonlyMap<number, CheckResult>

/// Rooms of a hand-in, which follow `after` others of earlier messages.
export interface RoomsOfResult {
  readonly task: number
  readonly pupil: number
  readonly after: number
  readonly rooms: readonly TestedRoom[]
}

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
  {task}: Omit<Checking, "op">,
): number {
  if (task !== null || !checked) return 0
  return handedIn.filter(({pupil}) => !results.has(pupil)).length
}

/// Where the check of a task begins: with the lesson, when all that was handed in was made in lessons of the service, which has the checks of no others.
export function firstWhere(handedIn: readonly {readonly lesson: string}[]): RoomFamily {
  return handedIn.length > 0 && handedIn.every(({lesson}) => lesson !== "" && !isOwnLesson(lesson))
    ? "lesson"
    : "own"
}

/// The checks of the lesson that did not pass, in a language or else in English.
export const unmetIn = ({unmet}: CheckResult, language: string): readonly string[] =>
  unmet.map(texts => texts[language] ?? texts["en"] ?? "")

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
