/// Autosave: stores the open program in the browser after each change and when the page is left, together with the undo steps and the reading position.
///
/// A program gets an entry of its own in the program store with its first change, in the task of that change: a reload that follows immediately opens the changed program and
/// not the example that it was. Later changes are stored after a pause. When another tab writes to the same entry, this tab shows that version; when both have
/// changes, this tab moves to a new entry with a new name, so that neither overwrites the other.

import {whenIdle} from "../../browser/browser_window.ts"
import type {Store} from "../../browser/store.ts"
import type {ProgramStore} from "../../storage/program_store.ts"
import type {ReadingPosition} from "../../storage/stored_values.ts"
import {words} from "../../words/index.ts"
import {serializeHistory} from "../document/undo_storage.ts"

/// Milliseconds between a change and its being kept.
const pause = 400

export interface Autosave {
  /// Another program is about to be open: `id` is its place, or `null` when it has none yet; `again`, the one that was open before a reload.
  opened(id: string | null, again: boolean): void
  /// The text has an edit that the document does not have yet.
  edited(): void
  /// Stores the program now.
  flush(): void
  /// The entry of the open program; `null` when it has none yet.
  place(): string | null
}

/// What autosave needs of the page.
export interface AutosavedPage {
  projectText(): string
  /// A small picture of the blocks; `null` when there is none.
  picture(): string | null
  /// Brings what was typed to the document.
  settle(): void
  readingPosition(): ReadingPosition | null
  /// The program became the learner's own with its first change.
  becameOwn(): void
  /// Shows another tab's version of the open program. The result is false when it cannot be read.
  follow(text: string): boolean
}

export function openAutosave(store: Store, programStore: ProgramStore, page: AutosavedPage): Autosave {
  let place: string | null = null
  /// The text of the entry as this tab has read or written it.
  let known: string | null = null
  /// The program is the learner's: the address names no example, to which a reload would go back.
  let own = false
  let timer: ReturnType<typeof setTimeout> | undefined

  const claim = () => {
    if (!own) page.becameOwn()
    own = true
  }
  /// Compares the entry with this tab's copy of it.
  const compare = () => {
    const stored = place === null ? null : programStore.read(place)
    if (stored === null || stored === known) return
    page.settle()
    if (store.now.saved === "saved" && page.follow(stored)) {
      known = stored
      return
    }
    const name = freshName(store.now.name, programStore.programs())
    const notice = {kind: "became-two", name: store.now.name, copy: name} as const
    place = freshPlace()
    known = null
    store.dispatch({kind: "renamed", name})
    store.dispatch({kind: "notice", notice})
  }
  const keep = () => {
    clearTimeout(timer)
    timer = undefined
    page.settle()
    const here = page.readingPosition()
    if (here !== null) programStore.setReadingPosition(here)
    if (store.now.saved === "saved") return
    compare()
    claim()
    programStore.setUndoSteps(serializeHistory(store.now.history, store.now.document))
    place ??= freshPlace()
    const ok = programStore.save(place, store.now.name, page.projectText(), Date.now())
    known = programStore.read(place)
    const picture = page.picture()
    if (ok && picture !== null) programStore.setPicture(place, picture)
    if (ok) programStore.setReplacedRoom(place, store.now.replacedRoom)
    store.dispatch({kind: "stored", ok})
  }

  /// Stores the first change at the end of the current task: the text editor allows no reading of its layout before.
  const keepFirst = () => {
    if (own) return
    claim()
    queueMicrotask(keep)
  }

  store.onEvent(state => state.saved === "changed" && keepFirst())
  store.onFrame(state => {
    if (state.saved === "changed" && timer === undefined) timer = setTimeout(() => whenIdle(keep), pause)
  })
  // A browser ends a page that is closed after a moment, also one that has not had the processor: the earlier of the two may be the only one that is heard.
  for (const leaving of ["beforeunload", "pagehide"]) window.addEventListener(leaving, keep)
  document.addEventListener("visibilitychange", () => document.visibilityState === "hidden" && keep())
  window.addEventListener("storage", event => {
    if (place !== null && event.key === programStore.keyOf(place)) compare()
  })

  return {
    opened(id, again) {
      // What was changed a moment ago belongs to the program that is being left.
      keep()
      place = id
      known = id === null ? null : programStore.read(id)
      own = false
      programStore.setCurrent(id)
      if (!again) programStore.setUndoSteps(null)
    },
    edited: keepFirst,
    flush: keep,
    place: () => place,
  }
}

/// The name of a copy: the first of "walk 2", "walk 3", … that no program has.
export function freshName(name: string, others: readonly {readonly name: string}[]): string {
  const stem = (name === "" ? words.unnamed : name).replace(/ \d+$/, "")
  const taken = new Set(others.map(other => other.name))
  let n = 2
  while (taken.has(`${stem} ${n}`)) n += 1
  return `${stem} ${n}`
}

/// `crypto.randomUUID` is missing where a page is served without TLS, as on a classroom's network.
export function freshPlace(): string {
  return `${Date.now().toString(36)}-${Math.random().toString(36).slice(2, 8)}`
}
