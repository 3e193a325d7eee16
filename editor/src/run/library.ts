/// What the service has to offer beside the session: examples and rooms, over HTTP (protocol §4).

import {decode, list, object, optional, parseJson, string} from "../state/decode.ts"
import type {Example} from "../state/page.ts"
import {readWorld} from "../worlds/read.ts"
import type {World} from "../worlds/world.ts"

const example = object<Example>(get => ({
  name: get("name", string),
  title: get("title", optional(string, "")),
  teaches: get("teaches", optional(string, "")),
}))

export type Fetched<T> = {readonly kind: "there"; readonly value: T} | {readonly kind: "failed"}

async function get(path: string): Promise<Fetched<string>> {
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

/// The order in which the language is met (LANGUAGE.md §5); others follow by name.
const order = [
  "move",
  "accelerate",
  "accelerateAndPlay",
  "forwardBackward",
  "randomWalk",
  "safetyControl",
  "mux",
  "safeRandomWalk",
  "turn",
  "moveDirection",
  "drawSquare",
]

/// The examples in the order of the gallery.
export function galleryOrder(examples: readonly Example[]): readonly Example[] {
  const place = (e: Example) => (order.includes(e.name) ? order.indexOf(e.name) : order.length)
  return [...examples].sort((a, b) => place(a) - place(b) || a.name.localeCompare(b.name))
}

export async function fetchExamples(): Promise<Fetched<readonly Example[]>> {
  const answer = await get("api/examples")
  if (answer.kind === "failed") return answer
  const read = decode(list(example), parseJson(answer.value))
  return read.kind === "ok" ? {kind: "there", value: galleryOrder(read.value)} : {kind: "failed"}
}

/// The text of an example's project file.
export function fetchExample(name: string): Promise<Fetched<string>> {
  return get(`api/examples/${encodeURIComponent(name)}`)
}

export async function fetchWorlds(): Promise<Fetched<readonly string[]>> {
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
