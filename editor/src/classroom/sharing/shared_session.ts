/// Session of two who edit a text together, on one side: sends own changes, one request at a time, applies what the service confirms, and tells and shows cursors.

import type {SharedText} from "../../views/source/shared_text.ts"
import type {SharingMessage, SharingRequest} from "../messages/shared_messages.ts"

export interface SharedSession {
  /// The text or the selection has changed.
  changed(): void
  heard(message: SharingMessage): void
  /// Sends nothing more.
  close(): void
}

/// Milliseconds between two messages about the cursor.
const cursorPause = 100

export function openSharedSession(
  text: SharedText,
  send: (message: SharingRequest) => void,
  /// The texts of the two sides differ, which no message leads to.
  broken: () => void,
  /// The other's cursor may be in another line.
  moved: (line: number | null) => void,
): SharedSession {
  /// A request waits for its answer. Every answer of the service settles it: the other's changes mean that the service has dropped it.
  let isSent = false
  let isClosed = false
  let told = ""
  let timer: ReturnType<typeof setTimeout> | undefined
  const push = () => {
    if (isSent || isClosed) return
    const pending = text.pending()
    if (pending === null) return
    isSent = true
    send({op: "push", ...pending})
  }
  const tellCursor = () => {
    timer ??= setTimeout(() => {
      timer = undefined
      const cursor = isClosed ? null : text.selection()
      const now = JSON.stringify(cursor)
      if (cursor === null || now === told) return
      told = now
      send({op: "cursor", ...cursor})
    }, cursorPause)
  }
  const changed = () => {
    push()
    tellCursor()
  }
  changed()
  return {
    changed,
    heard(message) {
      if (isClosed) return
      if (message.op === "cursor") text.showCursor(message)
      else {
        isSent = false
        if (!text.receive(message)) return broken()
        changed()
      }
      moved(text.otherLine())
    },
    close() {
      isClosed = true
      clearTimeout(timer)
    },
  }
}
