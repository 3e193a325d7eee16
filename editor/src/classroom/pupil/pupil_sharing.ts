/// Editing together on a pupil's page: the teacher's question and the pupil's answer, and the session that follows. It ends when either leaves, when another program is opened
/// here, or when the connection is lost; the program stays as it is then, and is saved as always.

import type {Signal} from "@preact/signals"
import type {PupilAnswer, PupilRequest} from "../../wire/classroom/pupil_messages.generated.ts"
import {words} from "../../words/index.ts"
import {openSharedSession, type SharedSession} from "../sharing/shared_session.ts"
import type {ClassEvent, ClassState} from "./class_state.ts"
import type {PageOfClass} from "./page_of_class.ts"

export interface SharingCommands {
  allowSharing(): void
  declineSharing(): void
  /// Ends it, or closes the line that says that it has ended.
  endSharing(): void
}

export interface PupilSharing {
  readonly commands: SharingCommands
  heard(message: PupilAnswer): void
  lost(): void
}

export function openPupilSharing(
  {store, loader, editor, parts, programStore}: PageOfClass,
  state: Signal<ClassState>,
  dispatch: (event: ClassEvent) => void,
  send: (message: PupilRequest) => boolean,
): PupilSharing {
  let session: SharedSession | null = null
  let shared: string | null = null
  const close = () => {
    session?.close()
    session = null
    parts.source?.endSharing()
  }
  const end = () => {
    close()
    send({op: "end-sharing"})
    dispatch({kind: "sharing", sharing: {kind: "ended"}})
  }
  const endIfOn = () => session !== null && end()
  loader.onOpening(endIfOn)
  // A conflict with another device makes two programs of the one.
  store.onEvent(() => session !== null && loader.storedId() !== shared && queueMicrotask(endIfOn))

  const begin = (program: string): SharedSession | null => {
    if (parts.source === null) return null
    const text = parts.source.share("pupil", words.classroom.sharing.teacher, () => session?.changed())
    shared = program
    return openSharedSession(text, send, end, line => dispatch({kind: "sharing-line", line}))
  }
  return {
    commands: {
      allowSharing() {
        const {sharing} = state.value
        if (sharing?.kind !== "asked") return
        const {program, number, name} = sharing
        if (loader.storedId() !== program) {
          const text = programStore.read(program)
          if (text === null) {
            send({op: "decline", number})
            return dispatch({kind: "sharing", sharing: {kind: "gone", name}})
          }
          loader.openText(name, text, {id: program})
        }
        editor.flush()
        // The pane shows what the document says: the changes of both start from it.
        editor.showText()
        const {text} = store.now.document.program
        if (!send({op: "share", number, project: loader.projectText(), text})) return
        session = begin(program)
        if (session === null) return end()
        dispatch({kind: "sharing", sharing: {kind: "on", line: null}})
      },
      declineSharing() {
        const {sharing} = state.value
        if (sharing?.kind === "asked") send({op: "decline", number: sharing.number})
        dispatch({kind: "sharing", sharing: null})
      },
      endSharing() {
        if (session !== null) end()
        else dispatch({kind: "sharing", sharing: null})
      },
    },
    heard(message) {
      if (message.op === "updates" || message.op === "cursor") session?.heard(message)
      else if (message.op === "sharing-over") close()
    },
    lost: close,
  }
}
