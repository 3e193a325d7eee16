/// The pupil's program on the page inside of the teacher's board: a copy that follows what the pupil saves until the teacher changes it; while the two edit it together, the
/// program itself.

import {parseProject} from "@rosy/codegen"
import type {Store} from "../../browser/store.ts"
import type {DocumentEditor} from "../../controller/document/document_editor.ts"
import {normalizeLineEndings} from "../../controller/document/line_endings.ts"
import type {PageParts} from "../../controller/document/page_parts.ts"
import type {ProgramLoader} from "../../controller/programs/program_loader.ts"
import {changesBetween} from "../../program/text_changes.ts"
import {words} from "../../words/index.ts"
import type {GuestMessage, HostMessage} from "../messages/guest_messages.ts"
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
  /// The text as the pupil has it.
  let pupils = store.now.document.program.text
  const follow = (project: string) => {
    const parsed = parseProject(project)
    if (session !== null || !parsed.ok) return
    editor.flush()
    const follows = store.now.document.program.text === pupils
    if (follows) {
      pupils = normalizeLineEndings(parsed.project.haskell)
      editor.changeText(changesBetween(store.now.document.program.text, pupils))
    }
    post({kind: "follows", follows})
  }
  const close = () => {
    if (session === null) return
    session.close()
    session = null
    parts.source?.endSharing()
    editor.flush()
    pupils = store.now.document.program.text
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
      else if (message.kind === "newer") follow(message.project)
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
