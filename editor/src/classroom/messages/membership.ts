/// Memberships of classes as this browser stores them, one for each class: the token, and for each program the version on the service that the
/// browser's copy was made from. Classes that follow one another at the same address have different identifiers.

import {tryToStore} from "../../storage/browser_storage.ts"
import {type Decoder, decode, list, Mismatch, number, object, parseJson, string} from "../../wire/decode.ts"

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

const key = "rosy.classes"

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

const memberships: Decoder<{readonly [id: string]: Membership}> = (value, path) => {
  if (typeof value !== "object" || value === null) throw new Mismatch(path, "an object")
  return Object.fromEntries(Object.entries(value).map(([id, one]) => [id, membership(one, `${path}.${id}`)]))
}

/// The memberships of this browser, read anew for each use, because all tabs of the browser write them.
export interface Memberships {
  /// The identifier of the class that the service runs; `null` until the service has sent it.
  classId(): string | null
  setClass(id: string): void
  /// The membership in this class.
  read(): Membership | null
  /// False when the storage is full or switched off.
  write(to: Membership | null): boolean
  /// Whether a program belongs to a pupil of another class only.
  isForeign(program: string): boolean
}

export function openMemberships(storage: Storage): Memberships {
  let classId: string | null = null
  const all = (): {readonly [id: string]: Membership} => {
    try {
      const text = storage.getItem(key)
      const found = decode(memberships, text === null ? {} : parseJson(text))
      return found.kind === "ok" ? found.value : {}
    } catch (fault) {
      if (fault instanceof DOMException) return {}
      throw fault
    }
  }
  const own = () => (classId === null ? null : (all()[classId] ?? null))
  return {
    classId: () => classId,
    setClass(id) {
      classId = id
    },
    read: own,
    write(to) {
      if (classId === null) return false
      const {[classId]: _, ...others} = all()
      return tryToStore(storage, key, JSON.stringify(to === null ? others : {...others, [classId]: to}))
    },
    isForeign(program) {
      if (own()?.programs[program] !== undefined) return false
      return Object.entries(all()).some(
        ([id, {programs}]) => id !== classId && programs[program] !== undefined,
      )
    },
  }
}
