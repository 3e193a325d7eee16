/// Values in the browser's storage and their decoders: list of programs, reading position, preferences.

import {
  type Arrangement,
  leastShare,
  mostShare,
  regions,
  regionsIn,
  type Tree,
  withDiagramBelowBlocks,
} from "../state/arrangement.ts"
import type {Layout, PageState, ReplacedRoom} from "../state/page_state.ts"
import {
  boolean,
  type Decoder,
  list,
  Mismatch,
  number,
  object,
  oneOf,
  optional,
  string,
} from "../wire/decode.ts"
import type {WorldFile} from "../worlds/world.ts"
import {readWorld} from "../worlds/world_decoder.ts"

/// A program kept in this browser.
export interface StoredProgram {
  readonly id: string
  readonly name: string
  /// When it was last changed, in milliseconds since 1970.
  readonly at: number
  /// When it was deleted; `null` for a program of the list.
  readonly deletedAt: number | null
}

/// The place of the reader in a program.
export interface ReadingPosition {
  /// The hash of the text that the offsets are of.
  readonly text: string
  /// The selection in the text, the start of the first line in sight, and whether the text has the keyboard.
  readonly anchor: number
  readonly head: number
  readonly top: number
  readonly writes: boolean
  /// How far the blocks are scrolled, in pixels, and how large they are.
  readonly x: number
  readonly y: number
  readonly scale: number
}

export type Preferences = Partial<
  Pick<
    PageState,
    | "theme"
    | "muted"
    | "arrangement"
    | "layout"
    | "trail"
    | "charts"
    | "chartSpan"
    | "previewing"
    | "valuesShown"
  >
>

export const index = list(
  object<StoredProgram>(get => ({
    id: get("id", string),
    name: get("name", string),
    at: get("at", number),
    deletedAt: get("deletedAt", optional(number, null)),
  })),
)
export const whereabouts = object<ReadingPosition>(get => ({
  text: get("text", string),
  anchor: get("anchor", number),
  head: get("head", number),
  top: get("top", number),
  writes: get("writes", boolean),
  x: get("x", number),
  y: get("y", number),
  scale: get("scale", number),
}))
const room: Decoder<string | WorldFile> = (value, path) => {
  if (typeof value === "string") return value
  if (readWorld(value).kind === "fault") throw new Mismatch(path, "a room")
  return value as WorldFile
}
export const replacedRoom = object<ReplacedRoom>(get => ({by: get("by", string), own: get("own", room)}))
const layout = object<Layout>(get => ({
  canvas: get("canvas", number),
}))
const region = oneOf(...regions)
const tree: Decoder<Tree> = (value, path) =>
  typeof value === "string"
    ? region(value, path)
    : object<Tree>(get => ({
        split: get("split", oneOf("beside", "below")),
        first: get("first", tree),
        second: get("second", tree),
        share: get("share", share),
      }))(value, path)
const share: Decoder<number> = (value, path) => {
  const found = number(value, path)
  if (found < leastShare || found > mostShare) throw new Mismatch(path, "a share")
  return found
}
const arrangement: Decoder<Arrangement> = (value, path) => {
  const stored = object<Arrangement>(get => ({tree: get("tree", tree), hidden: get("hidden", list(region))}))(
    value,
    path,
  )
  // Arrangements from before there was a diagram do not have its region.
  const found: Arrangement = regionsIn(stored.tree).includes("diagram")
    ? stored
    : {tree: withDiagramBelowBlocks(stored.tree), hidden: [...stored.hidden, "diagram"]}
  const there = regionsIn(found.tree)
  if (there.length !== regions.length || !regions.every(one => there.includes(one)))
    throw new Mismatch(path, "each region once")
  if (regions.every(one => found.hidden.includes(one))) throw new Mismatch(path, "a region to be seen")
  return found
}
const chartSpans = [20, 60, "all"] as const
export const liking = object<Preferences>(get => {
  const theme = get("theme", optional(oneOf("auto", "light", "dark"), null))
  const muted = get("muted", optional(boolean, null))
  const previewing = get("previewing", optional(boolean, null))
  const valuesShown = get("valuesShown", optional(boolean, null))
  const arranged = get("arrangement", optional(arrangement, null))
  const borders = get("layout", optional(layout, null))
  const trail = get("trail", optional(oneOf("plain", "speed", "time"), null))
  const charts = get("charts", optional(list(string), null))
  const chartSpan = chartSpans.find(span => span === get("chartSpan", value => value))
  return {
    ...(theme === null ? {} : {theme}),
    ...(muted === null ? {} : {muted}),
    ...(previewing === null ? {} : {previewing}),
    ...(valuesShown === null ? {} : {valuesShown}),
    ...(arranged === null ? {} : {arrangement: arranged}),
    ...(borders === null ? {} : {layout: borders}),
    ...(trail === null ? {} : {trail}),
    ...(charts === null ? {} : {charts}),
    ...(chartSpan === undefined ? {} : {chartSpan}),
  }
})
