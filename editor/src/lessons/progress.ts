/// Progress of a learner in each lesson: a value, and its text in the browser's storage.

import {decode, list, parseJson, string, unknownRecord} from "../state/decode.ts"

/// The ids of the steps that are done, by the name of the lesson.
export type Progress = {readonly [lesson: string]: readonly string[]}

/// A damaged text counts as no progress.
export function readProgress(text: string | null): Progress {
  const read = decode(
    (value, path) => {
      const all = unknownRecord(value, path)
      return Object.fromEntries(
        Object.entries(all).map(([name, done]) => [name, list(string)(done, `${path}.${name}`)]),
      )
    },
    parseJson(text ?? "{}"),
  )
  return read.kind === "ok" ? read.value : {}
}

export const writeProgress = (progress: Progress): string => JSON.stringify(progress)

export function isFinished(
  progress: Progress,
  lesson: {readonly name: string; readonly steps: readonly string[]},
) {
  const done = progress[lesson.name] ?? []
  return lesson.steps.length > 0 && lesson.steps.every(step => done.includes(step))
}
