/// Drafts as they are stored in the browser: their text, its decoder, and the merge with what another tab stored. Pure.

import {
  type Decoder,
  decode,
  list,
  number,
  object,
  oneOf,
  optional,
  parseJson,
  string,
  unknownRecord,
} from "../wire/decode.ts"
import type {WorldFile} from "../worlds/world.ts"
import type {Argument, DraftAnswer, DraftCheck, DraftStep, LessonDraft} from "./draft.ts"
import {record} from "./lesson.ts"
import {checkKinds} from "./lesson_file.ts"

/// Their storage key.
export const draftsKey = "rosy.lesson.drafts"

export const writeDrafts = (drafts: readonly LessonDraft[]): string => JSON.stringify(drafts)

/// A draft that cannot be read is left out.
export function readDrafts(text: string | null): readonly LessonDraft[] {
  const all = decode(
    list<unknown>(value => value),
    parseJson(text ?? "[]"),
  )
  if (all.kind === "mismatch") return []
  return all.value.flatMap(value => {
    const read = decode(draft, value)
    return read.kind === "ok" ? [read.value] : []
  })
}

/// What is stored, with the changes of this tab since `before`.
export function mergeDrafts(
  stored: readonly LessonDraft[],
  before: readonly LessonDraft[],
  now: readonly LessonDraft[],
): readonly LessonDraft[] {
  const changed = now.filter(one => !before.includes(one))
  const isGone = ({name}: LessonDraft) =>
    before.some(one => one.name === name) && !now.some(one => one.name === name)
  return changed.reduce(
    withDraft,
    stored.filter(one => !isGone(one)),
  )
}

/// The draft in the place of the one with its name, or else at the end.
export function withDraft(drafts: readonly LessonDraft[], draft: LessonDraft): readonly LessonDraft[] {
  const at = drafts.findIndex(one => one.name === draft.name)
  return at < 0 ? [...drafts, draft] : drafts.with(at, draft)
}

export const argument: Decoder<Argument> = (value, path) =>
  typeof value === "string"
    ? value
    : typeof value === "number"
      ? number(value, path)
      : list(string)(value, path)

const texts = record(string)

const check = object<DraftCheck>(get => ({
  id: get("id", string),
  kind: get("kind", oneOf(...checkKinds)),
  arguments: get("arguments", record(argument)),
  text: get("text", texts),
  hints: get("hints", list(texts)),
  // Older drafts have none.
  wrong: get("wrong", optional(list(string), [])),
}))

const answer = object<DraftAnswer>(get => ({
  id: get("id", string),
  text: get("text", texts),
  reply: get("reply", texts),
}))

const step = object<DraftStep>(get => ({
  id: get("id", string),
  kind: get("kind", oneOf("predict", "run", "investigate", "modify", "make")),
  say: get("say", texts),
  after: get("after", texts),
  seconds: get("seconds", number),
  checks: get("checks", list(check)),
  answers: get("answers", list(answer)),
  right: get("right", optional(string, null)),
  program: get("program", optional(string, null)),
  hands: get(
    "hands",
    optional(
      list<unknown>(hand => hand),
      [] as readonly unknown[],
    ),
  ),
}))

const draft = object<LessonDraft>(get => ({
  name: get("name", string),
  language: get("language", string),
  title: get("title", texts),
  idea: get("idea", texts),
  learned: get("learned", texts),
  room: get("room", unknownRecord) as WorldFile,
  start: get("start", string),
  solution: get("solution", optional(string, null)),
  toolbox: get("toolbox", optional(list(string), null)),
  steps: get("steps", list(step)),
}))
