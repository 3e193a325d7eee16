/// Lessons from a file or a link: one JSON value, as the service answers for a lesson of its own (protocol §9).
///
/// Its name is kept apart from the names of the service's lessons, so that the progress of the two does not mix.

import {withoutMark} from "@rosy/codegen/text-file"
import {list, Mismatch, number, object, oneOf, parseJson} from "../wire/decode.ts"
import {type Lesson, lessonDecoder} from "./lesson.ts"

export type ReadLesson =
  | {readonly kind: "lesson"; readonly lesson: Lesson}
  /// `at` is the place of the first mistake: `steps[1].seconds`.
  | {readonly kind: "damaged"; readonly at: string}
  /// Of a newer Rosy, whose format may have other fields.
  | {readonly kind: "newer"; readonly version: number}

/// Why a text cannot be opened as a lesson.
export type RefusedLesson = Exclude<ReadLesson, {readonly kind: "lesson"}>

/// Of the format: the version that this page writes, and the newest that it reads (`lesson_file.py`).
export const version = 1

/// The kinds of checks (`protocol/lesson.schema.json`). The service examines what else a check holds.
export const checkKinds = [
  "goals",
  "holds",
  "at",
  "faces",
  "still",
  "moves",
  "farthest",
  "back",
  "gap",
  "reaches",
  "raises",
  "ends",
  "says",
  "counts",
  "measures",
  "sends",
  "varies",
  "returns",
  "answers",
  "silent",
  "never",
  "function",
  "functions",
] as const

export type CheckKind = (typeof checkKinds)[number]

const ownPrefix = "own "

/// Whether a lesson of this name came from a file or a link.
export const isOwnLesson = (name: string): boolean => name.startsWith(ownPrefix)

/// Whether a text claims to be a lesson.
export function isLessonFile(text: string): boolean {
  const value = parsed(text)
  return typeof value === "object" && value !== null && "lesson" in value && "steps" in value
}

export function readLessonFile(text: string, language: string): ReadLesson {
  try {
    const value = parsed(text)
    const written = versionOf(value)
    if (written !== null && written > version) return {kind: "newer", version: written}
    const lesson = lessonDecoder(language)(value, "")
    header(value, "")
    examine(lesson)
    const name = `${ownPrefix}${lesson.name}`
    // As the service names rooms of its lessons: by this name a reload finds the learner's version of the program.
    const room = {...lesson.room, name: `lesson ${name}`}
    return {kind: "lesson", lesson: {...lesson, name, room, number: null, next: null, file: text}}
  } catch (fault) {
    if (fault instanceof Mismatch) return {kind: "damaged", at: fault.path}
    throw fault
  }
}

const parsed = (text: string) => parseJson(withoutMark(text))

const versionOf = (value: unknown): number | null =>
  typeof value === "object" && value !== null && "lesson" in value && typeof value.lesson === "number"
    ? value.lesson
    : null

const header = object(get => ({
  lesson: get("lesson", number),
  steps: get(
    "steps",
    list(
      object(at => {
        const checks = list(object(of => of("kind", oneOf(...checkKinds))))
        return at("checks", (value, path) => (value === undefined ? [] : checks(value, path)))
      }),
    ),
  ),
}))

/// What the fields alone cannot say; the same as `lesson_file.py` of the service.
function examine({steps}: Lesson): void {
  if (steps.length === 0) throw new Mismatch("steps", "a step")
  const seen = new Set<string>()
  for (const [i, {id, kind, answers, right, watched, checks}] of steps.entries()) {
    const path = `steps[${i}]`
    for (const one of [id, ...checks.map(check => check.id)]) {
      if (seen.has(one)) throw new Mismatch(`${path}.id`, "an id of its own")
      seen.add(one)
    }
    if (kind === "predict" || kind === "investigate") {
      if (answers.length < 2) throw new Mismatch(`${path}.answers`, "two answers")
      if (!answers.some(answer => answer.id === right)) throw new Mismatch(`${path}.right`, "an answer")
    } else if (watched === null) throw new Mismatch(`${path}.seconds`, "how long the run is watched")
    else if (kind !== "run" && checks.length === 0) throw new Mismatch(`${path}.checks`, "a check")
  }
}
