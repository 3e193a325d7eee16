/// Keeps the open program in the browser: shortly after each change, and at once when the page is left, with the steps of undo and the
/// learner's place in it. What was typed in the same instant belongs to it: `settle` brings it to the store first.
///
/// A program gets a place of its own with its first change, and is the learner's own from then on. When another tab writes to the same place, this tab
/// moves to a new one, so neither overwrites the other.

import type {Shelf, Whereabouts} from "../run/storage.ts"
import {whenIdle} from "../run/window.ts"
import type {Store} from "../store.ts"
import {stepsText} from "./steps.ts"

/// Milliseconds between a change and its being kept.
const pause = 400

export interface Autosave {
  /// Another program is about to be open: `id` is its place, or `null` when it has none yet; `again`, the one that was open before a reload.
  opened(id: string | null, again: boolean): void
}

export function openAutosave(
  store: Store,
  shelf: Shelf,
  projectText: () => string,
  settle: () => void,
  whereabouts: () => Whereabouts | null,
  becameOwn: () => void,
): Autosave {
  let place: string | null = null
  /// The program is the learner's: the address names no example, to which a reload would go back.
  let own = false
  let timer: ReturnType<typeof setTimeout> | undefined

  const claim = () => {
    if (!own) becameOwn()
    own = true
  }
  const keep = () => {
    clearTimeout(timer)
    timer = undefined
    settle()
    const here = whereabouts()
    if (here !== null) shelf.setPlace(here)
    if (store.now.saved === "saved") return
    claim()
    shelf.setSteps(stepsText(store.now.history, store.now.document))
    place ??= freshPlace()
    const ok = shelf.keep(place, store.now.name, projectText(), Date.now())
    store.dispatch({kind: "stored", ok})
  }

  store.onFrame(state => {
    if (state.saved !== "changed") return
    // With the first change and not when it is kept: whoever reloads in between means the changed program.
    claim()
    if (timer === undefined) timer = setTimeout(() => whenIdle(keep), pause)
  })
  window.addEventListener("pagehide", keep)
  document.addEventListener("visibilitychange", () => document.visibilityState === "hidden" && keep())
  window.addEventListener("storage", event => {
    if (place === null || event.key !== shelf.keyOf(place)) return
    place = freshPlace()
    store.dispatch({kind: "notice", notice: {kind: "opened-elsewhere"}})
  })

  return {
    opened(id, again) {
      // What was changed a moment ago belongs to the program that is being left.
      keep()
      place = id
      own = false
      shelf.setCurrent(id)
      if (!again) shelf.setSteps(null)
    },
  }
}

/// `crypto.randomUUID` is missing where a page is served without TLS, as on a classroom's network.
function freshPlace(): string {
  return `${Date.now().toString(36)}-${Math.random().toString(36).slice(2, 8)}`
}
