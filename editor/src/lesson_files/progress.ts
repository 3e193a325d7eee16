/// Progress of a learner in each lesson: a value, and its text in the browser's storage.

import {type Decoder, decode, list, parseJson, string, unknownRecord} from "../wire/decode.ts"

/// The ids of the steps that are done, by the name of the lesson.
export type Progress = {readonly [lesson: string]: readonly string[]}

export const progress: Decoder<Progress> = (value, path) =>
  Object.fromEntries(
    Object.entries(unknownRecord(value, path)).map(([name, done]) => [
      name,
      list(string)(done, `${path}.${name}`),
    ]),
  )

/// A damaged text counts as no progress.
export function readProgress(text: string | null): Progress {
  const read = decode(progress, parseJson(text ?? "{}"))
  return read.kind === "ok" ? read.value : {}
}

/// What is done in one of two.
export function union(one: Progress, other: Progress): Progress {
  const lessons = new Set([...Object.keys(one), ...Object.keys(other)])
  return Object.fromEntries(
    [...lessons].map(name => [name, [...new Set([...(one[name] ?? []), ...(other[name] ?? [])])]]),
  )
}

export const writeProgress = (progress: Progress): string => JSON.stringify(progress)

export function isFinished(
  all: Progress,
  lesson: {readonly name: string; readonly steps: readonly string[]},
) {
  const done = all[lesson.name] ?? []
  return lesson.steps.length > 0 && lesson.steps.every(step => done.includes(step))
}
