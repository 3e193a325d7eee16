/// What the browser remembers: the learner's programs and how they like the page. Every program that was
/// changed keeps a place of its own, so opening another never loses it.

import type {Level} from "@rosy/codegen"
import {type Arrangement, leastShare, mostShare, regions, regionsIn, type Tree} from "../state/arrangement.ts"
import {
  boolean,
  type Decoder,
  decode,
  list,
  Mismatch,
  number,
  object,
  oneOf,
  optional,
  parseJson,
  string,
} from "../state/decode.ts"
import type {Layout, PageState} from "../state/page.ts"

/// A program kept in this browser.
export interface Kept {
  readonly id: string
  readonly name: string
  /// When it was last changed, in milliseconds since 1970.
  readonly at: number
}

/// Programs kept; the oldest go first.
const maxKept = 30
const indexKey = "rosy.programs"
const currentKey = "rosy.current"
const likingKey = "rosy.liking"
const levelKey = "rosy.level"
const stepsKey = "rosy.steps"
const placeKey = "rosy.place"
const programKey = (id: string) => `rosy.program.${id}`

export interface Shelf {
  kept(): readonly Kept[]
  /// The program that this tab had open, or else the one that was open last in any, as the text of its project file.
  current(): {readonly id: string; readonly text: string} | null
  read(id: string): string | null
  /// The storage key of a program, as other tabs announce it.
  keyOf(id: string): string
  /// Answers whether the browser took it: its space is limited, and may be switched off.
  keep(id: string, name: string, text: string, at: number): boolean
  /// This tab has that program open; `null` is one that has no place yet.
  setCurrent(id: string | null): void
  /// What this tab keeps over a reload: the steps of undo around the program as it is, and where the learner was in it.
  steps(): string | null
  setSteps(text: string | null): void
  place(): Whereabouts | null
  setPlace(place: Whereabouts): void
  /// How much of the language the toolbox shows, when the learner has chosen.
  level(): Level | null
  setLevel(level: Level): void
  liking(): Liking
  setLiking(liking: Liking): void
}

/// Where somebody is in a program.
export interface Whereabouts {
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

export type Liking = Partial<
  Pick<PageState, "theme" | "muted" | "arrangement" | "layout" | "trail" | "charts" | "chartSpan">
>

const index = list(
  object<Kept>(get => ({id: get("id", string), name: get("name", string), at: get("at", number)})),
)
const whereabouts = object<Whereabouts>(get => ({
  text: get("text", string),
  anchor: get("anchor", number),
  head: get("head", number),
  top: get("top", number),
  writes: get("writes", boolean),
  x: get("x", number),
  y: get("y", number),
  scale: get("scale", number),
}))
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
  const found = object<Arrangement>(get => ({tree: get("tree", tree), hidden: get("hidden", list(region))}))(
    value,
    path,
  )
  const there = regionsIn(found.tree)
  if (there.length !== regions.length || !regions.every(one => there.includes(one)))
    throw new Mismatch(path, "each region once")
  if (regions.every(one => found.hidden.includes(one))) throw new Mismatch(path, "a region to be seen")
  return found
}
const chartSpans = [20, 60, "all"] as const
const liking = object<Liking>(get => {
  const theme = get("theme", optional(oneOf("auto", "light", "dark"), null))
  const muted = get("muted", optional(boolean, null))
  const arranged = get("arrangement", optional(arrangement, null))
  const borders = get("layout", optional(layout, null))
  const trail = get("trail", optional(oneOf("plain", "speed", "time"), null))
  const charts = get("charts", optional(list(string), null))
  const chartSpan = chartSpans.find(span => span === get("chartSpan", value => value))
  return {
    ...(theme === null ? {} : {theme}),
    ...(muted === null ? {} : {muted}),
    ...(arranged === null ? {} : {arrangement: arranged}),
    ...(borders === null ? {} : {layout: borders}),
    ...(trail === null ? {} : {trail}),
    ...(charts === null ? {} : {charts}),
    ...(chartSpan === undefined ? {} : {chartSpan}),
  }
})

/// `storage` is what all tabs share, `tab` what only this one remembers, over a reload.
export function openShelf(storage: Storage, tab: Storage): Shelf {
  const read = (key: string, from = storage): string | null => {
    try {
      return from.getItem(key)
    } catch (fault) {
      if (fault instanceof DOMException) return null
      throw fault
    }
  }
  const write = (key: string, text: string, to = storage): boolean => {
    try {
      to.setItem(key, text)
      return true
    } catch (fault) {
      if (fault instanceof DOMException) return false
      throw fault
    }
  }
  const kept = (): readonly Kept[] => {
    const text = read(indexKey)
    const found = decode(index, text === null ? [] : parseJson(text))
    return found.kind === "ok" ? found.value : []
  }
  return {
    kept,
    current() {
      for (const id of [read(currentKey, tab), read(currentKey)]) {
        const text = id === null || id === "" ? null : read(programKey(id))
        if (id !== null && text !== null) return {id, text}
      }
      return null
    },
    read: id => read(programKey(id)),
    keyOf: programKey,
    keep(id, name, text, at) {
      const others = kept().filter(k => k.id !== id)
      for (const old of others.slice(maxKept - 1)) storage.removeItem(programKey(old.id))
      return (
        write(programKey(id), text) &&
        write(indexKey, JSON.stringify([{id, name, at}, ...others.slice(0, maxKept - 1)])) &&
        write(currentKey, id) &&
        write(currentKey, id, tab)
      )
    },
    setCurrent(id) {
      write(currentKey, id ?? "", tab)
      if (id !== null) write(currentKey, id)
    },
    steps: () => read(stepsKey, tab),
    setSteps(text) {
      // Steps that there is no room for must not leave older ones behind.
      if (text === null || !write(stepsKey, text, tab)) write(stepsKey, "", tab)
    },
    place() {
      const text = read(placeKey, tab)
      const found = decode(whereabouts, text === null ? undefined : parseJson(text))
      return found.kind === "ok" ? found.value : null
    },
    setPlace(place) {
      write(placeKey, JSON.stringify(place), tab)
    },
    level() {
      const found = decode(oneOf("tasks", "reactions", "haskell"), read(levelKey))
      return found.kind === "ok" ? found.value : null
    },
    setLevel(level) {
      write(levelKey, level)
    },
    liking() {
      const text = read(likingKey)
      const found = decode(liking, text === null ? {} : parseJson(text))
      return found.kind === "ok" ? found.value : {}
    },
    setLiking(now) {
      write(likingKey, JSON.stringify(now))
    },
  }
}
