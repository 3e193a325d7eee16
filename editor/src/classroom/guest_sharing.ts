/// Editing together on the page inside of the teacher's board: opens the pupil's program as it is, and edits it together until either ends it. Afterwards it is a copy.

import type {DocumentEditor} from "../controller/document_editor.ts"
import type {PageParts} from "../controller/page_parts.ts"
import type {ProgramLoader} from "../controller/program_loader.ts"
import type {Store} from "../state/store.ts"
import {changesBetween} from "../state/text_changes.ts"
import {words} from "../words/index.ts"
import type {GuestMessage, HostMessage} from "./guest_messages.ts"
import {openSharedSession, type SharedSession} from "./shared_session.ts"

export interface GuestSharing {
  heard(message: Exclude<HostMessage, {readonly kind: "comments"}>): void
}

export function openGuestSharing(
  store: Store,
  parts: PageParts,
  loader: ProgramLoader,
  editor: DocumentEditor,
  post: (message: GuestMessage) => void,
): GuestSharing {
  let session: SharedSession | null = null
  const close = () => {
    session?.close()
    session = null
    parts.source?.endSharing()
  }
  const end = () => {
    if (session === null) return
    close()
    post({kind: "sharing", message: {op: "end-sharing"}})
  }
  // A file that the teacher drops here would take the place of the pupil's program.
  loader.onOpening(end)
  return {
    heard(message) {
      if (message.kind === "shared") session?.heard(message.message)
      else if (message.kind === "end-sharing") close()
      else {
        close()
        loader.openText(words.yourProgram, message.project)
        editor.flush()
        editor.changeText(changesBetween(store.now.document.program.text, message.text))
        if (parts.source === null) return
        const text = parts.source.share("teacher", message.nickname, () => session?.changed())
        session = openSharedSession(
          text,
          request => post({kind: "sharing", message: request}),
          end,
          line => post({kind: "line", line}),
        )
      }
    },
  }
}
