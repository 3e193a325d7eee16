/// Last values that only firings tell: what a function took and gave, the latest command or event of a type. Pure.

import {type FiringLog, latestFirings} from "../state/runs/firing_log.ts"
import {type RoomState, shownFrame} from "../state/runs/room_state.ts"
import type {Measures} from "../words/number_formats.ts"
import {shortFractions} from "./sentence_words.ts"
import {firingText, type LabelWords} from "./value_labels.ts"

/// Of a node of the diagram, at the displayed moment; `null` when it is not known.
export function lastOf(
  room: RoomState,
  {kind, key}: {readonly kind: string; readonly key: string},
  words: LabelWords,
  measures: Measures,
): string | null {
  const frame = shownFrame(room)
  if (frame === null) return null
  const time = room.lookedAt ?? frame.time
  const latest = latestFirings(room.firings, time)
  switch (kind) {
    case "function": {
      const firing = latest.get(key)
      return firing === undefined ? null : firingText(firing, time, words, measures).whole
    }
    case "command":
    case "channel":
      return lastGiven(room.firings, time, kind === "command" ? "command" : "event", key)
    default:
      return null
  }
}

/// The latest one of a type that firings gave; `null` as well when a firing that is not in the log may have given a later one.
function lastGiven({pieces}: FiringLog, time: number, to: "command" | "event", type: string): string | null {
  let next: number | null = null
  for (const {firings} of [...pieces].reverse())
    for (const {n, time: when, gave} of [...firings].reverse()) {
      if (when > time) continue
      if (next !== null && n !== next - 1) return null
      next = n
      const value = gave.findLast(one => one.to === to && one.type === type)?.value
      if (value !== undefined) return value === "" || value === "_" ? null : shortFractions(value)
    }
  return null
}
