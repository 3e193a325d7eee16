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
const visitedKey = "rosy.visited"
const programKey = (id: string) => `rosy.program.${id}`
const pictureKey = (id: string) => `rosy.picture.${id}`
const roomKey = (id: string) => `rosy.room.${id}`

export interface ProgramStore extends TabSession, PreferenceStore {
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
}

/// What a tab keeps over a reload, beside the program that it had open.
interface TabSession {
  /// The steps of undo around the program as it is, and where the learner was in it.
  undoSteps(): string | null
  setUndoSteps(text: string | null): void
  /// The example that this tab has changed into a program of the learner's own. A browser that reloads within milliseconds of the change still requests the example's address.
  left(): string | null
  setLeft(example: string | null): void
  readingPosition(): ReadingPosition | null
  setReadingPosition(place: ReadingPosition): void
}

interface PreferenceStore {
  /// How much of the language the toolbox shows, when the learner has chosen.
  level(): Level | null
  setLevel(level: Level): void
  preferences(): Preferences
  setPreferences(liking: Preferences): void
  /// Whether no program has been opened or stored in this browser before.
  isFirstVisit(): boolean
  setVisited(): void
}

/// `storage` is what all tabs share, `tab` what only this one remembers, over a reload. `madeWay` gets the names of the deleted
/// programs that were removed for good because the storage is full.
export function openProgramStore(
  storage: Storage,
  tab: Storage,
  madeWay: (names: readonly string[]) => void = () => {},
): ProgramStore {
  let isHidden: (id: string) => boolean = () => false
  const {kept, setKept, makeRoom, insert, rename, change} = openProgramList(storage, gone => {
    const names = gone.filter(({id}) => !isHidden(id)).map(({name}) => name)
    if (names.length > 0) madeWay(names)
  })
  const deleted = () =>
    kept()
      .filter(program => program.deletedAt !== null && !isHidden(program.id))
      .sort((a, b) => (b.deletedAt ?? 0) - (a.deletedAt ?? 0))
  return {
    hide(is) {
      isHidden = is
    },
    programs: () => kept().filter(program => program.deletedAt === null && !isHidden(program.id)),
    deleted,
    current() {
      const gone = deleted().map(program => program.id)
      for (const id of [readText(tab, currentKey), readText(storage, currentKey)]) {
        const text =
          id === null || id === "" || gone.includes(id) || isHidden(id)
            ? null
            : readText(storage, programKey(id))
        if (id !== null && text !== null) return {id, text}
      }
      return null
    },
    read: id => readText(storage, programKey(id)),
    keyOf: programKey,
    save(id, name, text, at) {
      const ok = insert(id, name, text, at)
      if (ok) {
        tryToStore(storage, currentKey, id)
        tryToStore(tab, currentKey, id)
      }
      return ok
    },
    insert,
    rename,
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
    picture: id => readText(storage, pictureKey(id)),
    setPicture(id, picture) {
      tryToStore(storage, pictureKey(id), picture)
    },
    replacedRoom(id) {
      const text = readText(storage, roomKey(id))
      const found = decode(replacedRoom, text === null ? undefined : parseJson(text))
      return found.kind === "ok" ? found.value : null
    },
    setReplacedRoom(id, replaced) {
      if (replaced !== null) tryToStore(storage, roomKey(id), JSON.stringify(replaced))
      else if (readText(storage, roomKey(id)) !== null) storage.removeItem(roomKey(id))
    },
    setCurrent(id) {
      tryToStore(tab, currentKey, id ?? "")
      if (id !== null) tryToStore(storage, currentKey, id)
    },
    ...tabSession(tab),
    ...storedPreferences(storage),
  }
}

/// The programs of the storage, deleted ones among them, and their texts. `madeWay` gets those that were removed for good because the
/// storage is full.
function openProgramList(storage: Storage, madeWay: (gone: readonly StoredProgram[]) => void) {
  const kept = (): readonly StoredProgram[] => {
    const text = readText(storage, indexKey)
    const found = decode(index, text === null ? [] : parseJson(text))
    return found.kind === "ok" ? found.value : []
  }
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
    return tryToStore(
      storage,
      indexKey,
      JSON.stringify(programs.filter(program => !outdated.includes(program))),
    )
  }
  /// Writes the list with `most` deleted programs, because the storage is full; says which ones are gone.
  const makeRoom = (programs: readonly StoredProgram[], most: number): void => {
    const gone = outdatedOf(programs, most)
    setKept(programs, most)
    madeWay(gone)
  }
  /// Writes what must not be lost: when the storage is full, deleted programs make way.
  const writeProgram = (id: string, text: string, programs: readonly StoredProgram[]): boolean => {
    const put = (list: readonly StoredProgram[]) => tryToStore(storage, programKey(id), text) && setKept(list)
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
  const rename = (id: string, name: string, text: string) => writeProgram(id, text, change(id, {name}))
  return {kept, setKept, makeRoom, insert, rename, change}
}

function tabSession(tab: Storage): TabSession {
  return {
    undoSteps: () => readText(tab, stepsKey),
    setUndoSteps(text) {
      // Steps that there is no room for must not leave older ones behind.
      if (text === null || !tryToStore(tab, stepsKey, text)) tryToStore(tab, stepsKey, "")
    },
    left: () => readText(tab, leftKey) || null,
    setLeft(example) {
      tryToStore(tab, leftKey, example ?? "")
    },
    readingPosition() {
      const text = readText(tab, placeKey)
      const found = decode(whereabouts, text === null ? undefined : parseJson(text))
      return found.kind === "ok" ? found.value : null
    },
    setReadingPosition(place) {
      tryToStore(tab, placeKey, JSON.stringify(place))
    },
  }
}

function storedPreferences(storage: Storage): PreferenceStore {
  return {
    level() {
      const found = decode(oneOf("tasks", "reactions", "haskell"), readText(storage, levelKey))
      return found.kind === "ok" ? found.value : null
    },
    setLevel(level) {
      tryToStore(storage, levelKey, level)
    },
    preferences() {
      const text = readText(storage, likingKey)
      const found = decode(liking, text === null ? {} : parseJson(text))
      return found.kind === "ok" ? found.value : {}
    },
    setPreferences(now) {
      tryToStore(storage, likingKey, JSON.stringify(now))
    },
    isFirstVisit: () => [visitedKey, indexKey].every(key => readText(storage, key) === null),
    setVisited() {
      if (readText(storage, visitedKey) === null) tryToStore(storage, visitedKey, "yes")
    },
  }
}

function readText(from: Storage, key: string): string | null {
  try {
    return from.getItem(key)
  } catch (fault) {
    if (fault instanceof DOMException) return null
    throw fault
  }
}
