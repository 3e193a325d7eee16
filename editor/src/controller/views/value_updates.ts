/// Updates of the values in blocks and text: at most ten times a second while a run goes on, at once when the displayed moment stands.

import type {PageState} from "../../state/page_state.ts"
import {isActive} from "../../state/runs/run_state.ts"
import {noBranches, takenBranches} from "../../values/taken_branches.ts"
import {type ValueLabel, valueLabels} from "../../values/value_labels.ts"
import {measures, words} from "../../words/index.ts"
import type {PageParts} from "../document/page_parts.ts"

/// Milliseconds between two updates.
const interval = 100

/// Labels grow in steps of so many characters and do not shrink during a run.
const roomStep = 4

export function openValueUpdates(parts: PageParts): (state: PageState, now: number) => void {
  let last = Number.NEGATIVE_INFINITY
  let shown: readonly ValueLabel[] = []
  let run: number | null = null
  let inputs: readonly unknown[] = []
  const rooms = new Map<string, number>()

  const roomOf = ({definition: {name}, text}: ValueLabel): number => {
    const needed = roomStep * Math.ceil(text.length / roomStep)
    const room = Math.max(rooms.get(name) ?? 0, needed)
    rooms.set(name, room)
    return room
  }

  return (state, now) => {
    const {valuesShown, room, network, document} = state
    if (!valuesShown && shown.length === 0) return
    const current = [valuesShown, room, network, document, parts.blocks, parts.source]
    if (current.every((input, i) => input === inputs[i])) return
    const goesOn = isActive(state.run) && state.clock === "going" && room.lookedAt === null
    if (goesOn && room.run === run && document === inputs[3] && now - last < interval) return
    if (room.run !== run) rooms.clear()
    run = room.run
    last = now
    inputs = current
    const labels = valueLabels(state, words.why, measures)
    if (labels.length === 0 && shown.length === 0) return
    shown = labels
    const values = labels.map(label => ({...label, room: roomOf(label)}))
    const taken = labels.length === 0 ? noBranches : takenBranches(state)
    parts.source?.showValues(
      values.map(value => ({...value, at: value.definition.start, block: value.definition.block})),
      taken.ranges,
    )
    parts.blocks?.showValues(
      values.map(value => ({...value, block: value.definition.block})),
      taken.blocks,
    )
  }
}
