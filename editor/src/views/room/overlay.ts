/// Overlay of two runs: what is drawn of the compared run over the shown one, at the displayed moment. Pure.

import type {PageState} from "../../state/page_state.ts"
import {frameAt} from "../../state/runs/recording.ts"
import type {Trail} from "../../state/runs/room_state.ts"
import {comparedRun, nodeOf, type RunNode} from "../../state/runs/run_tree.ts"

export interface Overlay {
  /// What the learner calls the two runs by.
  readonly shown: Pick<RunNode, "number" | "twin" | "recorded">
  readonly compared: Pick<RunNode, "number" | "twin" | "recorded">
  /// All of the compared path, and until when it is drawn, s; `null` for all of it.
  readonly trail: Trail
  readonly until: number | null
  /// Where the robot of the compared run is then.
  readonly pose: {readonly x: number; readonly y: number; readonly theta: number}
}

/// `null` while no run is compared.
export function overlayOf({runTree, room}: Pick<PageState, "runTree" | "room">): Overlay | null {
  const other = comparedRun(runTree)
  const own = nodeOf(runTree, room.run)
  if (other === null || own === undefined) return null
  const {trail, recording, frame} = other.kept.room
  const pose = room.lookedAt === null ? frame : frameAt(recording, room.lookedAt)
  if (pose === null) return null
  return {shown: own, compared: other, trail, until: room.lookedAt, pose}
}
