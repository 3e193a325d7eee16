/// Quantities of a run: values that can be charted, listed, and exported as CSV. Pure.

import {robot} from "@rosy/codegen/robot"
import type {MemoryName} from "../program/written_memories.ts"
import type {Frame} from "../state/messages/messages.ts"
import {numberAt, speedOf, turningOf} from "../state/runs/channels.ts"
import type {Recording} from "../state/runs/recording.ts"
import {ledNames} from "../state/runs/room_state.ts"
import type {MemoryValue} from "../wire/link_messages.generated.ts"
import {spreadsheet} from "./spreadsheet.ts"

/// A value of a frame that can be shown as a number over time.
export interface Quantity {
  readonly key: string
  /// What it is called; `null` for what `words` or the robot's labels have a word for, under its key.
  readonly name: string | null
  readonly unit: string
  /// `null` while there is no such value.
  readonly of: (frame: Frame) => number | null
  /// The block family whose colour the curve has.
  readonly family: "state" | "event" | "command" | "memory" | "task" | "number" | "choice" | "own"
}

const known = (key: string, unit: string, family: Quantity["family"], of: Quantity["of"]): Quantity => ({
  key,
  name: null,
  unit,
  family,
  of,
})

/// What every run has, in the order of the table.
export const quantities: readonly Quantity[] = [
  known("speed", "m/s", "state", speedOf),
  known("turning", "rad/s", "memory", turningOf),
  known("x", "m", "number", f => f.x),
  known("y", "m", "task", f => f.y),
  known("heading", "rad", "choice", f => f.theta),
  ...robot.charts.map(({key, channel, place, unit, family}) =>
    known(key, unit, family, frame => numberAt(frame, channel, place)),
  ),
]

/// Where the robot believes it is, in a world where that may be wrong.
const believed: readonly Quantity[] = [
  known("believedX", "m", "number", f => f.ghost?.[0] ?? null),
  known("believedY", "m", "task", f => f.ghost?.[1] ?? null),
  known("believedHeading", "rad", "choice", f => f.ghost?.[2] ?? null),
]

/// A remembered value with a name of its own: two tasks may each remember an `Int`.
export interface NamedMemoryValue {
  readonly key: string
  /// As the program writes its type.
  readonly name: string
  /// As Haskell writes it: `Memory Int`.
  readonly type: string
  readonly value: string
}

const asItIs: MemoryName = type => type

export function namedMemory(
  memory: readonly MemoryValue[] | null,
  nameOf: MemoryName = asItIs,
): readonly NamedMemoryValue[] {
  const seen = new Map<string, number>()
  return (memory ?? []).map(({type, value}) => {
    const count = (seen.get(type) ?? 0) + 1
    seen.set(type, count)
    const place = count === 1 ? "" : ` (${count})`
    return {key: `memory ${type}${place}`, name: `${nameOf(type)}${place}`, type, value}
  })
}

/// A number as Haskell writes it, or a truth as 1 and 0; `null` for any other value.
export function numberIn(value: string): number | null {
  if (value === "True") return 1
  if (value === "False") return 0
  return /^-?\d+(\.\d+)?(e-?\d+)?$/.test(value) ? Number(value) : null
}

/// The remembered number of a frame. Frames between two changes share their memory, so most need no search.
function keptNumber(key: string): Quantity["of"] {
  let last: {readonly memory: readonly MemoryValue[] | null; readonly value: number | null} | null = null
  return ({memory}) => {
    if (last === null || last.memory !== memory) {
      const found = namedMemory(memory).find(r => r.key === key)
      last = {memory, value: found === undefined ? null : numberIn(found.value)}
    }
    return last.value
  }
}

/// What can be drawn of a run that now stands at this frame.
export function quantitiesOf(frame: Frame | null, nameOf: MemoryName = asItIs): readonly Quantity[] {
  const kept = namedMemory(frame?.memory ?? null, nameOf)
    .filter(({value}) => numberIn(value) !== null)
    .map(({key, name}): Quantity => ({key, name, unit: "", family: "memory", of: keptNumber(key)}))
  return [...quantities, ...(frame === null || frame.ghost === null ? [] : believed), ...kept]
}

/// A table of the whole run for a spreadsheet: a header, then a row per frame.
export function toCsv(recording: Recording, nameOf: MemoryName = asItIs): string {
  const frames = recording.pieces.flat()
  const last = frames.at(-1)
  const numbers = [...quantities, ...(last === undefined || last.ghost === null ? [] : believed)]
  const kept = new Map<string, string>()
  let before: readonly MemoryValue[] | null = null
  for (const f of frames) {
    if (f.memory !== before) for (const r of namedMemory(f.memory, nameOf)) kept.set(r.key, r.name)
    before = f.memory
  }
  const rows = [["time", ...numbers.map(q => q.key), "led1", "led2", ...kept.values()]]
  for (const f of frames) {
    const memory = new Map(namedMemory(f.memory).map(r => [r.key, r.value]))
    rows.push([
      f.time.toFixed(2),
      ...numbers.map(q => {
        const value = q.of(f)
        return value === null ? "" : String(+value.toFixed(5))
      }),
      ledNames[numberAt(f, "Led1")] ?? "",
      ledNames[numberAt(f, "Led2")] ?? "",
      ...[...kept.keys()].map(key => memory.get(key) ?? ""),
    ])
  }
  return spreadsheet(rows)
}
