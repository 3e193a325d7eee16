/// What this browser remembers of class mode: handouts that were opened, comments that were read, and the class that this tab works without.

import {type BrowserStorage, tryToStore} from "../../storage/browser_storage.ts"

const skippedKey = "rosy.class.skipped"
const handoutKey = "rosy.class.handout"
const commentsKey = "rosy.class.comments"

/// Comments that a browser remembers as read; older ones may be shown again.
const mostReadComments = 50

export interface ClassMemory {
  /// Keys of comments (`commentKey`).
  readComments(): readonly string[]
  /// The result is all that were read.
  addReadComment(key: string): readonly string[]
  forgetComments(): void
  /// Identifiers of handouts.
  openedHandouts(): readonly string[]
  addHandout(id: string): void
  /// The pupil works on without this class in this tab.
  skip(classId: string): void
  hasSkipped(classId: string): boolean
}

export function openClassMemory({shared, tab}: BrowserStorage): ClassMemory {
  const readComments = () => (shared.getItem(commentsKey) ?? "").split("\n")
  const openedHandouts = () => (shared.getItem(handoutKey) ?? "").split(" ")
  return {
    readComments,
    addReadComment(key) {
      const read = [...readComments().slice(-mostReadComments), key]
      tryToStore(shared, commentsKey, read.join("\n"))
      return read
    },
    forgetComments: () => shared.removeItem(commentsKey),
    openedHandouts,
    addHandout(id) {
      tryToStore(shared, handoutKey, `${openedHandouts().slice(-20).join(" ")} ${id}`)
    },
    skip(classId) {
      tryToStore(tab, skippedKey, classId)
    },
    hasSkipped: classId => tab.getItem(skippedKey) === classId,
  }
}
