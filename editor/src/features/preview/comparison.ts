/// Comparison of a preview with the run that the page shows, as facts. Pure.

import {type Preview, placeAt, shownPreview, wantedSeconds} from "../../state/messages/preview.ts"
import type {PageState} from "../../state/page_state.ts"
import {frameAt} from "../../state/runs/recording.ts"

export type Side = "left" | "right" | "up" | "down" | "up left" | "up right" | "down left" | "down right"

export interface Comparison {
  /// Whether it is about the program as it is now, or as it was a moment ago.
  readonly current: boolean
  /// How far from the run's place the robot would be, m, and on which side in the picture; `null` where it makes no difference.
  readonly moved: {readonly distance: number; readonly side: Side} | null
  /// When that is, s, unless both end then.
  readonly at: number | null
  readonly bumps: number
  readonly goals: {readonly done: number; readonly all: number}
  /// When the program would fail, s.
  readonly fails: number | null
  /// When the preview ends, s, because it was not computed any longer; `null` when it is as long as the run.
  readonly cut: number | null
}

/// Less than this is the same place, m.
const samePlace = 0.05

/// A direction is named alone when the other is less than this share of it.
const slant = 0.4

/// `null` while there is nothing to compare.
export function compare(state: Pick<PageState, "room">): Comparison | null {
  const shown = shownPreview(state.room.preview)
  if (shown === null) return null
  const {preview, current} = shown
  const failed = preview.ended === "error" || preview.ended === "stuck"
  return {
    current,
    ...difference(state, preview),
    bumps: preview.collisions.length,
    goals: {done: preview.goals.filter(g => g.state === "done").length, all: preview.goals.length},
    fails: failed ? preview.time : null,
    cut: isCut(state, preview) ? preview.time : null,
  }
}

/// A preview is asked for as long as the run, as far as the service computes so much.
function isCut({room}: Pick<PageState, "room">, {ended, time}: Preview): boolean {
  return ended === "time" && time < wantedSeconds(room.frame?.time ?? 0) - 0.05
}

/// Both at the same moment: the end of the shorter one.
function difference({room}: Pick<PageState, "room">, preview: Preview): Pick<Comparison, "moved" | "at"> {
  const ran = room.frame?.time ?? 0
  const time = Math.min(ran, preview.time)
  const before = frameAt(room.recording, time)
  const after = placeAt(preview.path, time)
  const at = Math.abs(ran - preview.time) < 0.1 ? null : time
  if (before === null || after === null) return {moved: null, at}
  const [dx, dy] = [after.x - before.x, after.y - before.y]
  const distance = Math.hypot(dx, dy)
  return {moved: distance < samePlace ? null : {distance, side: sideOf(dx, dy)}, at}
}

/// x points to the right of the picture, y up.
function sideOf(dx: number, dy: number): Side {
  const across = dx < 0 ? "left" : "right"
  const along = dy < 0 ? "down" : "up"
  if (Math.abs(dy) < slant * Math.abs(dx)) return across
  if (Math.abs(dx) < slant * Math.abs(dy)) return along
  return `${along} ${across}`
}
