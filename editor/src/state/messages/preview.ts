/// Preview of an edited program: the service's answer as a value, and the state of asking for it. Pure.

import type {Previewed} from "../../wire/page/programs.generated.ts"
import type {Goal} from "../../wire/page/runs.generated.ts"

/// Where the robot would be, m, and when, s since the start.
export interface PathPoint {
  readonly time: number
  readonly x: number
  readonly y: number
}

/// protocol §4, `previewed`. Problems of the run that it would be are not shown: the page shows those of its own runs.
export interface Preview extends Pick<Previewed, "id" | "ended" | "time"> {
  readonly x: number
  readonly y: number
  readonly theta: number
  readonly path: readonly PathPoint[]
  /// Where the robot stands when it begins to touch something.
  readonly collisions: readonly PathPoint[]
  readonly goals: readonly Pick<Goal, "state" | "time">[]
  /// From when on the pen is down, 1, or up, 0, with the number of its colour and its width, m.
  readonly pen: Previewed["pen"]
}

export interface PreviewState {
  /// The program of the last run in this room; `null` when there has been none.
  readonly ran: string | null
  /// The newest question to the service; `null` when nothing is to be shown. Its answer is late when a person would notice.
  readonly asked: {readonly id: number; readonly text: string; readonly isLate: boolean} | null
  /// The newest answer; its preview is `null` when the program does not compile, or when the last run cannot be repeated.
  readonly answer: {
    readonly text: string
    readonly preview: Preview | null
    /// The last run had more inputs by the learner than the service records.
    readonly unrepeatable?: true
  } | null
}

export const noPreview: PreviewState = {ran: null, asked: null, answer: null}

/// Shortest and longest run that is previewed, s; the service refuses longer ones.
const shortest = 10
const longest = 300

/// How long a preview after a run of so many seconds has to be.
export const wantedSeconds = (ran: number): number => Math.max(shortest, ran)

/// The length of it that the service computes, at most.
export const previewSeconds = (ran: number): number => Math.min(longest, wantedSeconds(ran))

/// Whether the answer to the newest question is still to come.
export const isPending = ({asked, answer}: PreviewState): boolean =>
  asked !== null && asked.text !== answer?.text

/// Milliseconds after which an answer is late.
export const lateAfter = 300

/// What is drawn: the newest preview. `current` is false while the answer about the newest text is late: dimmed for each letter it would flicker.
export function shownPreview(
  state: PreviewState,
): {readonly preview: Preview; readonly current: boolean} | null {
  const preview = state.asked === null ? null : (state.answer?.preview ?? null)
  return preview === null ? null : {preview, current: !(isPending(state) && state.asked?.isLate)}
}

/// The answer to this question is late, if it has not come.
export function latePreview(state: PreviewState, id: number): PreviewState {
  const {asked} = state
  return asked?.id === id && isPending(state) ? {...state, asked: {...asked, isLate: true}} : state
}

/// Takes an answer; one to an older question changes nothing.
export function hearPreview(state: PreviewState, preview: Preview): PreviewState {
  const {asked} = state
  if (asked === null || asked.id !== preview.id || !isPending(state)) return state
  const {text} = asked
  if (preview.ended === "unrepeatable") return {...state, answer: {text, preview: null, unrepeatable: true}}
  return {...state, answer: {text, preview: preview.ended === "refused" ? null : preview}}
}

/// The pose on a path at a time, as its last point before.
export function placeAt(path: readonly PathPoint[], time: number): PathPoint | null {
  return path.findLast(point => point.time <= time + 1e-9) ?? path[0] ?? null
}

const point = ([time, x, y]: readonly [number, number, number]): PathPoint => ({time, x, y})

export function previewOf({id, ended, time, goals, pose, path, collisions, pen}: Previewed): Preview {
  const [x, y, theta] = pose
  return {id, ended, time, goals, x, y, theta, path: path.map(point), collisions: collisions.map(point), pen}
}
