/// Branches that functions took at the displayed moment, as places in text and blocks: equations, guards, alternatives. Pure.

import {type BlockId, offsetOf, type Program} from "../program/program.ts"
import type {PageState} from "../state/page_state.ts"
import {latestFirings} from "../state/runs/firing_log.ts"
import {shownFrame} from "../state/runs/room_state.ts"
import type {Branch} from "../wire/firing.generated.ts"
import type {FiringShown} from "../wire/page/explanations.generated.ts"

export interface TakenBranches {
  /// Offsets, in the order of the text; of nested branches the outer one first.
  readonly ranges: readonly {readonly start: number; readonly end: number}[]
  readonly blocks: readonly BlockId[]
}

export const noBranches: TakenBranches = {ranges: [], blocks: []}

/// Those of the latest firing of each function. None when the text has changed since the run began.
export function takenBranches(state: Pick<PageState, "document" | "room" | "valuesShown">): TakenBranches {
  const {room, document} = state
  const frame = shownFrame(room)
  const {program} = document
  if (!state.valuesShown || room.run === null || frame === null || room.source !== program.text)
    return noBranches
  const latest = latestFirings(room.firings, room.lookedAt ?? frame.time)
  const ranges = [...latest.values()]
    .flatMap(ownBranches)
    .map(({start, end}) => ({start: offsetOf(program.text, start), end: offsetOf(program.text, end)}))
    .sort((a, b) => a.start - b.start || b.end - a.end)
  return {
    ranges,
    blocks: [...new Set(ranges.flatMap(range => blockOf(program, range) ?? []))],
  }
}

/// The branches of the function itself and of its local definitions; all of a function without a name.
function ownBranches({function: name, branches}: FiringShown): readonly Branch[] {
  const own = branches.filter(branch => branch.in.includes(name))
  return own.length > 0 ? own : branches
}

/// The widest block that ends where the branch ends: its result, or all of it.
function blockOf(
  {spans}: Program,
  range: {readonly start: number; readonly end: number},
): BlockId | undefined {
  const inside = spans.filter(span => span.start >= range.start && span.end === range.end)
  return inside.sort((a, b) => a.start - b.start)[0]?.block
}
