/// Program store in the browser's storage: the learner's programs, the page's preferences, and the session of this tab. Every changed program has an entry of its own, so
/// opening another program never overwrites it. A deleted program is kept until there are too many of them or the storage is full; other programs are never removed.

import type {Level} from "@rosy/codegen"
import type {ReplacedRoom} from "../state/page_state.ts"
import {decode, oneOf, parseJson} from "../wire/decode.ts"
import {tryToStore} from "./browser_storage.ts"
import {
  index,
  liking,
  type Preferences,
  type ReadingPosition,
  replacedRoom,
  type StoredProgram,
  whereabouts,
} from "./stored_values.ts"

/// Deleted programs that can be restored; those deleted first are removed first.
const mostDeleted = 20
const indexKey = "rosy.programs"
const currentKey = "rosy.current"
const likingKey = "rosy.liking"
const levelKey = "rosy.level"
const stepsKey = "rosy.steps"
const leftKey = "rosy.left"
const placeKey = "rosy.place"
const programKey = (id: string) => `rosy.program.${id}`
const pictureKey = (id: string) => `rosy.picture.${id}`
const roomKey = (id: string) => `rosy.room.${id}`

export interface ProgramStore {
  /// Programs that this function names are in no list and are not opened from now on: those of another class.
  hide(isHidden: (id: string) => boolean): void
  /// The programs that are not deleted; the one that was changed last comes first.
  programs(): readonly StoredProgram[]
  /// The deleted programs that can be restored; the one that was deleted last comes first.
  deleted(): readonly StoredProgram[]
  /// The program that this tab had open, or else the one that was open last in any, as the text of its project file.
  current(): {readonly id: string; readonly text: string} | null
  read(id: string): string | null
  /// The storage key of a program, as other tabs announce it.
  keyOf(id: string): string
  /// Stores a program as the newest of the list. The result is false when the storage is full or switched off.
  save(id: string, name: string, text: string, at: number): boolean
  /// Stores a program as the newest of the list, without opening it in this tab.
  insert(id: string, name: string, text: string, at: number): boolean
  /// Stores another name and its text in the place of a program, which keeps its date.
  rename(id: string, name: string, text: string): boolean
  remove(id: string, at: number): void
  restore(id: string): void
  /// The picture of a program's blocks, as `browser/block_picture.ts` makes it.
  picture(id: string): string | null
  setPicture(id: string, picture: string): void
  /// The learner's own room of a program whose room is a room of a test.
  replacedRoom(id: string): ReplacedRoom | null
  setReplacedRoom(id: string, room: ReplacedRoom | null): void
  /// This tab has that program open; `null` is one that has no place yet.
  setCurrent(id: string | null): void
  /// What this tab keeps over a reload: the steps of undo around the program as it is, and where the learner was in it.
  undoSteps(): string | null
  setUndoSteps(text: string | null): void
  /// The example that this tab has changed into a program of the learner's own. A browser that reloads within milliseconds of the change still requests the example's address.
  left(): string | null
  setLeft(example: string | null): void
  readingPosition(): ReadingPosition | null
  setReadingPosition(place: ReadingPosition): void
  /// How much of the language the toolbox shows, when the learner has chosen.
  level(): Level | null
  setLevel(level: Level): void
  preferences(): Preferences
  setPreferences(liking: Preferences): void
}

/// `storage` is what all tabs share, `tab` what only this one remembers, over a reload. `madeWay` gets the names of the deleted
/// programs that were removed for good because the storage is full.
export function openProgramStore(
  storage: Storage,
  tab: Storage,
  madeWay: (names: readonly string[]) => void = () => {},
): ProgramStore {
  const read = (key: string, from = storage): string | null => {
    try {
      return from.getItem(key)
    } catch (fault) {
      if (fault instanceof DOMException) return null
      throw fault
    }
  }
  const write = (key: string, text: string, to = storage): boolean => tryToStore(to, key, text)
  const kept = (): readonly StoredProgram[] => {
    const text = read(indexKey)
    const found = decode(index, text === null ? [] : parseJson(text))
    return found.kind === "ok" ? found.value : []
  }
  let isHidden: (id: string) => boolean = () => false
  const deleted = () =>
    kept()
      .filter(program => program.deletedAt !== null && !isHidden(program.id))
      .sort((a, b) => (b.deletedAt ?? 0) - (a.deletedAt ?? 0))
  const outdatedOf = (programs: readonly StoredProgram[], most: number): readonly StoredProgram[] =>
    programs
      .filter(program => program.deletedAt !== null)
      .sort((a, b) => (b.deletedAt ?? 0) - (a.deletedAt ?? 0))
      .slice(most)
  /// Writes the list, without the deleted programs that are too many.
  const setKept = (programs: readonly StoredProgram[], most = mostDeleted): boolean => {
    const outdated = outdatedOf(programs, most)
    for (const {id} of outdated) {
      storage.removeItem(programKey(id))
      storage.removeItem(pictureKey(id))
      storage.removeItem(roomKey(id))
    }
    return write(indexKey, JSON.stringify(programs.filter(program => !outdated.includes(program))))
  }
  /// Writes the list with `most` deleted programs, because the storage is full; says which ones are gone.
  const makeRoom = (programs: readonly StoredProgram[], most: number): void => {
    const gone = outdatedOf(programs, most).filter(({id}) => !isHidden(id))
    setKept(programs, most)
    if (gone.length > 0) madeWay(gone.map(({name}) => name))
  }
  /// Writes what must not be lost: when the storage is full, deleted programs make way.
  const writeProgram = (id: string, text: string, programs: readonly StoredProgram[]): boolean => {
    const put = (list: readonly StoredProgram[]) => write(programKey(id), text) && setKept(list)
    if (put(programs)) return true
    makeRoom(kept(), 0)
    if (put(programs.filter(program => program.deletedAt === null))) return true
    // A text that the list does not name would only take up space.
    if (kept().every(program => program.id !== id)) storage.removeItem(programKey(id))
    return false
  }
  const insert = (id: string, name: string, text: string, at: number) =>
    writeProgram(id, text, [{id, name, at, deletedAt: null}, ...kept().filter(program => program.id !== id)])
  const change = (id: string, to: Partial<StoredProgram>): readonly StoredProgram[] =>
    kept().map(program => (program.id === id ? {...program, ...to} : program))
  return {
    hide(is) {
      isHidden = is
    },
    programs: () => kept().filter(program => program.deletedAt === null && !isHidden(program.id)),
    deleted,
    current() {
      const gone = deleted().map(program => program.id)
      for (const id of [read(currentKey, tab), read(currentKey)]) {
        const text =
          id === null || id === "" || gone.includes(id) || isHidden(id) ? null : read(programKey(id))
        if (id !== null && text !== null) return {id, text}
      }
      return null
    },
    read: id => read(programKey(id)),
    keyOf: programKey,
    save(id, name, text, at) {
      const ok = insert(id, name, text, at)
      if (ok) {
        write(currentKey, id)
        write(currentKey, id, tab)
      }
      return ok
    },
    insert,
    rename: (id, name, text) => writeProgram(id, text, change(id, {name})),
    remove(id, at) {
      const programs = change(id, {deletedAt: at})
      if (setKept(programs)) return
      // The list is longer by the time: programs that were deleted before make way, and a picture that can be drawn again.
      storage.removeItem(pictureKey(id))
      makeRoom(programs, 1)
    },
    restore(id) {
      setKept(change(id, {deletedAt: null}))
    },
    picture: id => read(pictureKey(id)),
    setPicture(id, picture) {
      write(pictureKey(id), picture)
    },
    replacedRoom(id) {
      const text = read(roomKey(id))
      const found = decode(replacedRoom, text === null ? undefined : parseJson(text))
      return found.kind === "ok" ? found.value : null
    },
    setReplacedRoom(id, replaced) {
      if (replaced !== null) write(roomKey(id), JSON.stringify(replaced))
      else if (read(roomKey(id)) !== null) storage.removeItem(roomKey(id))
    },
    setCurrent(id) {
      write(currentKey, id ?? "", tab)
      if (id !== null) write(currentKey, id)
    },
    undoSteps: () => read(stepsKey, tab),
    setUndoSteps(text) {
      // Steps that there is no room for must not leave older ones behind.
      if (text === null || !write(stepsKey, text, tab)) write(stepsKey, "", tab)
    },
    left: () => read(leftKey, tab) || null,
    setLeft(example) {
      write(leftKey, example ?? "", tab)
    },
    readingPosition() {
      const text = read(placeKey, tab)
      const found = decode(whereabouts, text === null ? undefined : parseJson(text))
      return found.kind === "ok" ? found.value : null
    },
    setReadingPosition(place) {
      write(placeKey, JSON.stringify(place), tab)
    },
    level() {
      const found = decode(oneOf("tasks", "reactions", "haskell"), read(levelKey))
      return found.kind === "ok" ? found.value : null
    },
    setLevel(level) {
      write(levelKey, level)
    },
    preferences() {
      const text = read(likingKey)
      const found = decode(liking, text === null ? {} : parseJson(text))
      return found.kind === "ok" ? found.value : {}
    },
    setPreferences(now) {
      write(likingKey, JSON.stringify(now))
    },
  }
}
