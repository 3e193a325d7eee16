/// Resources fetched over HTTP: examples and rooms (protocol §4), API documentation, and the WebAssembly parser of Haskell.

import {openReader, type Reader} from "@rosy/codegen/reader"
import grammarAddress from "tree-sitter-haskell/tree-sitter-haskell.wasm?url"
import runtimeAddress from "web-tree-sitter/web-tree-sitter.wasm?url"
import {type Lesson, type LessonEntry, lessonDecoder, lessonListDecoder} from "../lesson_files/lesson.ts"
import type {Example} from "../state/page_state.ts"
import {type Decoder, decode, list, number, object, optional, parseJson, string} from "../wire/decode.ts"
import type {World} from "../worlds/world.ts"
import {readWorld} from "../worlds/world_decoder.ts"

const example = object<Example>(get => ({
  name: get("name", string),
  title: get("title", optional(string, "")),
  teaches: get("teaches", optional(string, "")),
  level: get("level", optional(string, "")),
}))

/// Where the robot drives in an example; a point is x and y in metres.
export interface ExamplePath {
  readonly world: World
  readonly path: readonly (readonly [number, number])[]
}

const point: Decoder<readonly [number, number]> = (value, path) => {
  const [x = Number.NaN, y = Number.NaN] = list(number)(value, path)
  return [x, y]
}
const examplePath = object(get => ({world: get("world", value => value), path: get("path", list(point))}))

export type FetchResult<T> = {readonly kind: "there"; readonly value: T} | {readonly kind: "failed"}

async function get(path: string): Promise<FetchResult<string>> {
  try {
    const answer = await fetch(path)
    if (!answer.ok) return {kind: "failed"}
    return {kind: "there", value: await answer.text()}
  } catch (fault) {
    // `fetch` rejects with a TypeError when the service cannot be reached, and for nothing else.
    if (fault instanceof TypeError) return {kind: "failed"}
    throw fault
  }
}

/// The examples in the order of the gallery.
export async function fetchExamples(): Promise<FetchResult<readonly Example[]>> {
  const answer = await get("api/examples")
  if (answer.kind === "failed") return answer
  const read = decode(list(example), parseJson(answer.value))
  return read.kind === "ok" ? {kind: "there", value: read.value} : {kind: "failed"}
}

/// The lessons in their order, with titles in a language or else in English.
export function fetchLessons(language: string): Promise<FetchResult<readonly LessonEntry[]>> {
  return getDecoded("api/lessons", lessonListDecoder(language))
}

/// The challenges in their order; the steps of one are its stars.
export function fetchChallenges(language: string): Promise<FetchResult<readonly LessonEntry[]>> {
  return getDecoded("api/challenges", lessonListDecoder(language))
}

/// A lesson or a challenge.
export function fetchLesson(name: string, language: string): Promise<FetchResult<Lesson>> {
  return getDecoded(`api/lessons/${encodeURIComponent(name)}`, lessonDecoder(language))
}

async function getDecoded<T>(path: string, decoder: Decoder<T>): Promise<FetchResult<T>> {
  const answer = await get(path)
  if (answer.kind === "failed") return answer
  const read = decode(decoder, parseJson(answer.value))
  if (read.kind === "ok") return {kind: "there", value: read.value}
  console.warn(`${path}: ${read.message}`)
  return {kind: "failed"}
}

/// The text of an example's project file.
export function fetchExample(name: string): Promise<FetchResult<string>> {
  return get(`api/examples/${encodeURIComponent(name)}`)
}

/// `null` when the service cannot compute it.
export async function fetchExamplePath(name: string): Promise<ExamplePath | null> {
  const answer = await get(`api/examples/${encodeURIComponent(name)}/path`)
  const read = answer.kind === "there" ? decode(examplePath, parseJson(answer.value)) : null
  if (read?.kind !== "ok") return null
  const world = readWorld(read.value.world)
  return world.kind === "world" ? {world: world.world, path: read.value.path} : null
}

export async function fetchWorlds(): Promise<FetchResult<readonly string[]>> {
  const answer = await get("api/worlds")
  if (answer.kind === "failed") return answer
  const read = decode(list(string), parseJson(answer.value))
  return read.kind === "ok" ? {kind: "there", value: read.value} : {kind: "failed"}
}

/// From the simplest room to the one most like a real floor; others follow by name.
const roomOrder = [
  "room",
  "empty",
  "corridor",
  "two-rooms",
  "slalom",
  "obstacles",
  "boxes",
  "maze",
  "pits",
  "table",
  "track",
  "oval",
  "crossing",
  "gap",
  "classroom",
  "slippery",
]

/// The rooms of these names in the order of their gallery, as far as they can be had.
export async function fetchRooms(names: readonly string[]): Promise<readonly World[]> {
  const place = (name: string) => (roomOrder.includes(name) ? roomOrder.indexOf(name) : roomOrder.length)
  const sorted = [...names].sort((a, b) => place(a) - place(b) || a.localeCompare(b))
  const found = await Promise.all(
    sorted.map(async name => {
      const answer = await get(`api/worlds/${encodeURIComponent(name)}`)
      const read = answer.kind === "there" ? readWorld(parseJson(answer.value)) : null
      return read?.kind === "world" ? [read.world] : []
    }),
  )
  return found.flat()
}

export interface Explanation {
  readonly words: string
  /// Where the whole of it stands.
  readonly address: string
}

export interface Explanations {
  about(name: string): Promise<Explanation | null>
}

const address = "api-docs/Rosy.html"

export function openExplanations(): Explanations {
  let page: Promise<Document | null> | undefined
  return {
    async about(name) {
      page ??= fetchPage()
      const found = await page
      const place = found?.getElementById(`v:${name}`) ?? found?.getElementById(`t:${name}`)
      if (place == null) return null
      const own = place.closest("tr")?.querySelector("td.doc:not(.empty)")
      const told = own ?? place.closest(".top")?.querySelector(":scope > .doc > p")
      return {words: (told?.textContent ?? "").replace(/\s+/g, " ").trim(), address: `${address}#${place.id}`}
    },
  }
}

async function fetchPage(): Promise<Document | null> {
  try {
    const answer = await fetch(address)
    return answer.ok ? new DOMParser().parseFromString(await answer.text(), "text/html") : null
  } catch (fault) {
    // `fetch` rejects with a TypeError when the service cannot be reached, and for nothing else.
    if (fault instanceof TypeError) return null
    throw fault
  }
}

/// `null` when the files do not come: without them no program can be opened.
export async function fetchReader(): Promise<Reader | null> {
  const [runtime, grammar] = await Promise.all([bytes(runtimeAddress), bytes(grammarAddress)])
  return runtime === null || grammar === null ? null : openReader({runtime, grammar})
}

async function bytes(address: string): Promise<Uint8Array | null> {
  try {
    const answer = await fetch(address)
    return answer.ok ? new Uint8Array(await answer.arrayBuffer()) : null
  } catch (fault) {
    if (fault instanceof TypeError) return null
    throw fault
  }
}
