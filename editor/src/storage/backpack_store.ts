/// Backpack in the browser's storage: definitions as Haskell text, which every program of this browser can take. The one that was put in last comes first.

import {decode, list, object, parseJson, string} from "../wire/decode.ts"
import {tryToStore} from "./browser_storage.ts"

export interface PackedClip {
  /// The definition that was put in, and those that came along.
  readonly name: string
  readonly others: readonly string[]
  readonly text: string
}

export interface BackpackStore {
  list(): readonly PackedClip[]
  /// The same text is never in it twice. False when the storage is full or switched off.
  put(clip: PackedClip): boolean
  remove(clip: PackedClip): void
}

/// Clips that are kept; those that were put in first go first.
const mostClips = 40

const key = "rosy.backpack"

const clips = list(
  object<PackedClip>(get => ({
    name: get("name", string),
    others: get("others", list(string)),
    text: get("text", string),
  })),
)

export function openBackpackStore(storage: Storage): BackpackStore {
  const kept = (): readonly PackedClip[] => {
    let text: string | null = null
    try {
      text = storage.getItem(key)
    } catch (fault) {
      if (!(fault instanceof DOMException)) throw fault
    }
    const found = text === null ? null : decode(clips, parseJson(text))
    return found?.kind === "ok" ? found.value : []
  }
  const without = (text: string) => kept().filter(clip => clip.text !== text)
  const store = (all: readonly PackedClip[]) => tryToStore(storage, key, JSON.stringify(all))
  return {
    list: kept,
    put: ({name, others, text}) => store([{name, others, text}, ...without(text)].slice(0, mostClips)),
    remove: ({text}) => void store(without(text)),
  }
}
