/// Steps of a recorded run: the moments at which a function begins to fire, such as the next step of a task, or an event's reaction. Pure.

import type {Frame} from "../messages/messages.ts"
import {frameAt, framesBetween, type Recording} from "./recording.ts"

export interface RunStep {
  /// Seconds of the run.
  readonly time: number
  /// The functions that begin.
  readonly names: readonly string[]
}

/// A function that fires again within this time has not begun anew, s.
const pause = 0.05

const countOf = (names: readonly string[], name: string) => names.filter(other => other === name).length

/// In the order of time.
export const stepsOf = (recording: Recording): readonly RunStep[] =>
  stepsBetween(recording, Number.NEGATIVE_INFINITY, Number.POSITIVE_INFINITY)

/// The functions that begin in the frame at a time, s. Reads only the frames shortly before it, so it may be asked for each picture.
export function begunAt(recording: Recording, time: number): readonly string[] {
  const first = frameAt(recording, time - pause)?.time ?? time
  return stepsBetween(recording, first, time).find(step => step.time === time)?.names ?? []
}

function stepsBetween(recording: Recording, from: number, to: number): readonly RunStep[] {
  const steps: RunStep[] = []
  const firedAt = new Map<string, number>()
  let before: Frame | null = null
  for (const frame of framesBetween(recording, from, to)) {
    const previous: readonly string[] = before?.fired ?? []
    // Where one step of a task ends and another of the same name begins, both fire at once.
    const isNextFrame = before !== null && frame.step - before.step === 1
    const names = [...new Set(frame.fired)].filter(name =>
      previous.includes(name)
        ? isNextFrame && countOf(frame.fired, name) > countOf(previous, name)
        : frame.time - (firedAt.get(name) ?? Number.NEGATIVE_INFINITY) > pause,
    )
    if (names.length > 0) steps.push({time: frame.time, names})
    for (const name of frame.fired) firedAt.set(name, frame.time)
    before = frame
  }
  return steps
}

/// The step after a time of the run; `null` after the last one.
export function stepAfter(recording: Recording, time: number): RunStep | null {
  return stepsOf(recording).find(step => step.time > time) ?? null
}

/// The step before a time of the run; `null` before the first one.
export function stepBefore(recording: Recording, time: number): RunStep | null {
  return stepsOf(recording).findLast(step => step.time < time) ?? null
}
