/// Programs of other classes on a pupil's page: hidden, and when the page shows one, a new program takes its place.

import type {Memberships} from "../messages/membership.ts"
import type {PageOfClass} from "./page_of_class.ts"

export interface ForeignPrograms {
  /// The service has named its class. `isOther`: the page was in another one; `wasMember`: with a pupil of that one.
  meetClass(isOther: boolean, wasMember: boolean): void
  /// Whether a program was replaced since this was asked last.
  takeReplaced(): boolean
}

export function openForeignPrograms(
  {store, loader, programStore}: Pick<PageOfClass, "store" | "loader" | "programStore">,
  memberships: Pick<Memberships, "isForeign">,
): ForeignPrograms {
  /// Whether the page was in another class, or showed a program of one, which gives way to a new one. The pupil's newest program follows when
  /// the class lets the page in.
  let isReplaced = false
  /// The entry of the program that was compared with the class last.
  let compared: string | null = null
  programStore.hide(memberships.isForeign)
  const replace = () => {
    isReplaced = true
    loader.newProgram()
    store.dispatch({kind: "lesson", event: {kind: "closed"}})
  }
  const hideForeign = () => {
    const id = loader.storedId()
    if (id === compared) return
    compared = id
    if (id !== null && memberships.isForeign(id)) replace()
  }
  store.onEvent(() => queueMicrotask(hideForeign))
  return {
    meetClass(isOther, wasMember) {
      if (isOther) isReplaced = true
      compared = null
      // What was opened there and is unchanged has no entry: a lesson that the other teacher sent is not handed in here.
      if (wasMember && loader.storedId() === null) replace()
      else hideForeign()
    },
    takeReplaced() {
      const was = isReplaced
      isReplaced = false
      return was
    },
  }
}
