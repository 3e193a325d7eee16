/// Page with a pupil's program inside of the teacher's board: tells the board which place is chosen and where the comments are, and shows them.

import type {Store} from "../../browser/store.ts"
import type {DocumentEditor} from "../../controller/document/document_editor.ts"
import type {PageParts} from "../../controller/document/page_parts.ts"
import type {ProgramLoader} from "../../controller/programs/program_loader.ts"
import {lineNumber, locatePlace, placeOf, quoteOf} from "../../program/block_comments.ts"
import type {PageState} from "../../state/page_state.ts"
import {
  type ChosenPlace,
  type GuestMessage,
  type HostMessage,
  listen,
  post,
} from "../messages/guest_messages.ts"
import {openGuestSharing} from "./guest_sharing.ts"

export function openBoardGuest(
  store: Store,
  parts: PageParts,
  loader: ProgramLoader,
  editor: DocumentEditor,
): void {
  const board = window.parent
  if (board === window) return
  const sharing = openGuestSharing(store, parts, loader, editor, message => post(board, message))
  const told = new Map<GuestMessage["kind"], string>()
  /// Sends what is news.
  const tell = (message: GuestMessage) => {
    const text = JSON.stringify(message)
    if (told.get(message.kind) === text) return
    told.set(message.kind, text)
    post(board, message)
  }
  listen<HostMessage>(
    () => board,
    message => {
      if (message.kind === "comments") store.dispatch({kind: "block-comments", comments: message.comments})
      else sharing.heard(message)
    },
  )
  store.onFrame(state => {
    tell({kind: "chosen", chosen: chosenPlace(state, parts.source?.cursor() ?? 0)})
    const {program} = state.document
    const lines = state.blockComments.map(({id, place}) => {
      const range = locatePlace(program, place)
      return {comment: id, line: range === null ? null : lineNumber(program.text, range.start)}
    })
    tell({kind: "located", lines})
  })
  tell({kind: "ready"})
}

/// Nothing is chosen before the teacher chooses a block, or puts the cursor into the text.
function chosenPlace({document, selected, selectedIn}: PageState, cursor: number): ChosenPlace | null {
  if (selected === null && selectedIn === "blocks") return null
  const place = placeOf(document.program, selected, cursor)
  const range = place === null ? null : locatePlace(document.program, place)
  if (place === null || range === null) return null
  return {
    place,
    line: lineNumber(document.program.text, range.start),
    quote: quoteOf(place.piece.slice(place.start, place.end)),
  }
}
