/// Lessons as values, and the decoders of the service's messages about them (protocol §9). Texts are those of one language.

import {
  boolean,
  type Decoder,
  list,
  Mismatch,
  number,
  object,
  oneOf,
  optional,
  string,
  unknownRecord,
} from "../wire/decode.ts"
import type {WorldFile} from "../worlds/world.ts"
import {readWorld} from "../worlds/world_decoder.ts"

export type StepKind = "predict" | "run" | "investigate" | "modify" | "make"

export interface Answer {
  readonly id: string
  readonly text: string
  /// What is said when it is chosen; may be empty.
  readonly reply: string
}

export interface Check {
  readonly id: string
  readonly text: string
  /// A question, a pointer, a piece to take; fewer when the lesson has fewer.
  readonly hints: readonly string[]
}

export interface Step {
  readonly id: string
  readonly kind: StepKind
  /// The step in one sentence.
  readonly say: string
  /// What is to be seen when it is done; may be empty.
  readonly after: string
  readonly answers: readonly Answer[]
  readonly right: string | null
  readonly checks: readonly Check[]
  /// What the service checks; `null` for a question. With `stars` each check is a star of a challenge, and the first is its goal.
  readonly watched: {
    readonly seconds: number
    readonly checks: readonly unknown[]
    readonly stars: boolean
  } | null
  /// The program that the step begins with; `null`: the program as it is.
  readonly program: string | null
}

export interface Lesson {
  readonly name: string
  readonly course: string
  /// Place in the list of all lessons; `null` for a lesson from a file or a link.
  readonly number: number | null
  readonly title: string
  readonly idea: string
  readonly learned: string
  readonly room: WorldFile
  /// The words whose blocks the toolbox shows (`toolbox_words.ts`); `null`: all blocks.
  readonly toolbox: readonly string[] | null
  readonly start: string
  readonly steps: readonly Step[]
  /// The name of the next lesson; `null` after the last.
  readonly next: string | null
  /// The text of the file or link that it was opened from (`lesson_file.ts`); `null` for a lesson of the service.
  readonly file: string | null
}

/// A lesson or a challenge in the list; the steps of a challenge are its stars.
export interface LessonEntry {
  readonly name: string
  readonly course: string
  readonly number: number
  readonly title: string
  readonly idea: string
  readonly steps: readonly string[]
}

type TextsById = {readonly [name: string]: string}
const noTexts: TextsById = {}
const noHints: {readonly [check: string]: readonly string[]} = {}

const texts: Decoder<TextsById> = (value, path) =>
  Object.fromEntries(
    Object.entries(unknownRecord(value, path)).map(([name, text]) => [name, string(text, `${path}.${name}`)]),
  )

export const record =
  <T>(item: Decoder<T>): Decoder<{readonly [name: string]: T}> =>
  (value, path) =>
    Object.fromEntries(
      Object.entries(unknownRecord(value, path)).map(([name, one]) => [name, item(one, `${path}.${name}`)]),
    )

const stepTexts = object(get => ({
  say: get("say", string),
  after: get("after", optional(string, "")),
  answers: get("answers", optional(texts, noTexts)),
  replies: get("replies", optional(texts, noTexts)),
}))

export const lessonTexts = object(get => ({
  title: get("title", string),
  idea: get("idea", string),
  learned: get("learned", string),
  steps: get("steps", record(stepTexts)),
  checks: get("checks", optional(texts, noTexts)),
  hints: get("hints", optional(record(list(string)), noHints)),
}))

/// The value for a language, or else the English one, or else the first.
const inLanguage =
  <T>(item: Decoder<T>, language: string): Decoder<T> =>
  (value, path) => {
    const all = record(item)(value, path)
    const found = all[language] ?? all.en ?? Object.values(all)[0]
    if (found === undefined) throw new Mismatch(path, "a text")
    return found
  }

const room: Decoder<WorldFile> = (value, path) => {
  const read = readWorld(value)
  if (read.kind === "fault") throw new Mismatch(`${path}.${read.fault.path}`, "a room")
  return value as WorldFile
}

const checkId = object(get => ({id: get("id", string)}))

export function lessonDecoder(language: string): Decoder<Lesson> {
  return object(get => {
    const said = get("texts", inLanguage(lessonTexts, language))
    const step = object<Step>(at => {
      const id = at("id", string)
      const own = said.steps[id]
      if (own === undefined) throw new Mismatch(`texts.steps.${id}`, "a text")
      const checks = at(
        "checks",
        optional(
          list<unknown>(value => value),
          [],
        ),
      )
      const seconds = at("seconds", optional(number, null))
      const stars = at("stars", optional(boolean, false))
      return {
        id,
        kind: at("kind", oneOf("predict", "run", "investigate", "modify", "make")),
        say: own.say,
        after: own.after,
        answers: at("answers", optional(list(string), [])).map(answer => ({
          id: answer,
          text: own.answers[answer] ?? answer,
          reply: own.replies[answer] ?? "",
        })),
        right: at("right", optional(string, null)),
        checks: at("checks", optional(list(checkId), [])).map(check => ({
          id: check.id,
          text: said.checks[check.id] ?? check.id,
          hints: said.hints[check.id] ?? [],
        })),
        watched: seconds === null ? null : {seconds, checks, stars},
        program: at("program", optional(string, null)),
      }
    })
    return {
      name: get("name", string),
      course: get("course", optional(string, "")),
      number: get("number", optional(number, null)),
      title: said.title,
      idea: said.idea,
      learned: said.learned,
      // A room without a title is called like its lesson.
      room: {title: said.title, ...get("room", room)},
      toolbox: get("toolbox", optional(list(string), null)),
      start: get("start", string),
      steps: get("steps", list(step)),
      next: get("next", optional(string, null)),
      file: null,
    }
  })
}

export function lessonListDecoder(language: string): Decoder<readonly LessonEntry[]> {
  return list(
    object(get => ({
      name: get("name", string),
      course: get("course", string),
      number: get("number", number),
      title: get("titles", inLanguage(string, language)),
      idea: get("ideas", inLanguage(string, language)),
      steps: get("steps", list(string)),
    })),
  )
}
