/// Membership of the class as this browser stores it: the token, and for each program the version on the service that the browser's copy was made from.

import {type Decoder, decode, list, Mismatch, number, object, parseJson, string} from "../state/decode.ts"

export interface SyncRecord {
  /// The version on the service; 0 for none.
  readonly version: number
  /// The hash of the text of that version.
  readonly hash: string
  /// Requests made since then that were not answered yet: the service may have stored them.
  readonly marks: readonly string[]
}

export interface Membership {
  readonly token: string
  readonly nickname: string
  readonly programs: {readonly [id: string]: SyncRecord}
}

const key = "rosy.class"

/// Storage key that the board sets: this browser belongs to the teacher, who is not asked to join.
export const teacherKey = "rosy.teacher"

const record = object<SyncRecord>(get => ({
  version: get("version", number),
  hash: get("hash", string),
  marks: get("marks", list(string)),
}))
const records: Decoder<Membership["programs"]> = (value, path) => {
  if (typeof value !== "object" || value === null) throw new Mismatch(path, "an object")
  return Object.fromEntries(Object.entries(value).map(([id, one]) => [id, record(one, `${path}.${id}`)]))
}
const membership = object<Membership>(get => ({
  token: get("token", string),
  nickname: get("nickname", string),
  programs: get("programs", records),
}))

/// Read anew for each use, because all tabs of the browser write it.
export function readMembership(storage: Storage): Membership | null {
  try {
    const text = storage.getItem(key)
    const found = decode(membership, text === null ? null : parseJson(text))
    return found.kind === "ok" ? found.value : null
  } catch (fault) {
    if (fault instanceof DOMException) return null
    throw fault
  }
}

/// False when the storage is full or switched off.
export function writeMembership(storage: Storage, to: Membership | null): boolean {
  try {
    if (to === null) storage.removeItem(key)
    else storage.setItem(key, JSON.stringify(to))
    return true
  } catch (fault) {
    if (fault instanceof DOMException) return false
    throw fault
  }
}
