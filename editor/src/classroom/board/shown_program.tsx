/// A pupil's program on the teacher's board: the page with a copy of it, and the comments on its places.

import type {VNode} from "preact"
import {useEffect, useLayoutEffect, useRef, useState} from "preact/hooks"
import {quoteOf} from "../../program/block_comments.ts"
import type {BoardRequest} from "../../wire/classroom/board_messages.generated.ts"
import type {OwnComment} from "../../wire/classroom/pupil_messages.generated.ts"
import {words} from "../../words/index.ts"
import {
  type ChosenPlace,
  type GuestMessage,
  type HostMessage,
  listen,
  post,
} from "../messages/guest_messages.ts"
import type {SharingBounds, SharingMessage} from "../messages/shared_messages.ts"
import {BoardSharing} from "./board_sharing.tsx"
import {board, change, type ShownProgram, sharingListeners} from "./board_state.ts"

interface Props {
  readonly shown: ShownProgram
  readonly send: (request: BoardRequest) => boolean
}

/// What the page in the frame says of the program.
interface Guest {
  readonly isReady: boolean
  readonly chosen: ChosenPlace | null
  readonly follows: boolean
  /// The lines of comments; `null` for a place that is gone.
  readonly lines: ReadonlyMap<number, number | null>
}

const noGuest: Guest = {isReady: false, follows: true, chosen: null, lines: new Map()}

export function ShownProgramDialog({shown, send}: Props): VNode {
  const w = words.classroom.board
  const dialog = useRef<HTMLDialogElement>(null)
  const frame = useRef<HTMLIFrameElement>(null)
  const [guest, setGuest] = useState(noGuest)
  useLayoutEffect(() => dialog.current?.showModal(), [])
  useLayoutEffect(() => {
    setGuest(noGuest)
    return listen<GuestMessage>(
      () => frame.current?.contentWindow ?? null,
      message => {
        if (message.kind === "sharing") send(message.message)
        else if (message.kind === "line") change({sharingLine: message.line})
        else setGuest(now => heard(now, message))
      },
    )
  }, [shown.address])
  useEffect(() => {
    const tell = (message: SharingMessage | SharingBounds) => {
      const page = frame.current?.contentWindow
      if (page) post(page, hostMessage(message, shown.nickname))
    }
    sharingListeners.add(tell)
    return () => {
      sharingListeners.delete(tell)
      if (board.value.sharing === "asked" || board.value.sharing === "on") send({op: "end-sharing"})
    }
  }, [shown.address])
  const {newer} = shown
  useEffect(() => {
    const page = frame.current?.contentWindow
    if (guest.isReady && newer !== null && page) post(page, {kind: "newer", project: newer})
  }, [guest.isReady, newer])
  const {program, pupil} = shown
  const comments = program === null ? [] : board.value.comments.filter(one => one.program === program)
  const told = JSON.stringify(comments)
  useEffect(() => {
    const page = frame.current?.contentWindow
    if (guest.isReady && page) post(page, {kind: "comments", comments: comments.filter(({done}) => !done)})
  }, [guest.isReady, told])
  const title = w.programOf(shown.nickname, shown.name)
  return (
    <dialog class="board-program" ref={dialog} aria-label={title} onClose={() => change({shown: null})}>
      <header>
        <h2>{title}</h2>
        <div class="board-program-sharing">
          <BoardSharing shown={shown} follows={guest.follows} send={send} />
        </div>
        <button type="button" class="plain" onClick={() => change({shown: null})}>
          {w.close}
        </button>
      </header>
      <iframe ref={frame} src={shown.address} title={title} />
      {program !== null && (
        <Comments
          comments={comments}
          guest={guest}
          add={(text, {place}) => send({op: "add-comment", pupil, program, text, place})}
          remove={comment => send({op: "remove-comment", comment})}
        />
      )}
    </dialog>
  )
}

function hostMessage(message: SharingMessage | SharingBounds, nickname: string): HostMessage {
  switch (message.op) {
    case "shared":
      return {kind: "share", nickname, project: message.project ?? "", text: message.text ?? ""}
    case "sharing-over":
      return {kind: "end-sharing"}
    default:
      return {kind: "shared", message}
  }
}

type NewsOfGuest = Exclude<GuestMessage, {readonly kind: "sharing" | "line"}>

function heard(guest: Guest, message: NewsOfGuest): Guest {
  switch (message.kind) {
    case "ready":
      return {...guest, isReady: true}
    case "follows":
      return {...guest, follows: message.follows}
    case "chosen":
      return {...guest, chosen: message.chosen}
    case "located":
      return {...guest, lines: new Map(message.lines.map(({comment, line}) => [comment, line]))}
  }
}

interface CommentsProps {
  readonly comments: readonly OwnComment[]
  readonly guest: Guest
  /// Whether it could be sent.
  readonly add: (text: string, chosen: ChosenPlace) => boolean
  readonly remove: (comment: number) => void
}

function Comments({comments, guest, add, remove}: CommentsProps): VNode {
  const w = words.classroom.board.comments
  const [text, setText] = useState("")
  const {chosen, lines} = guest
  const {commentRefused, link} = board.value
  return (
    <section class="board-comments" aria-label={w.title} data-testid="board-comments">
      <form
        onSubmit={event => {
          event.preventDefault()
          if (chosen === null || text.trim() === "") return
          change({commentRefused: null})
          if (add(text.trim(), chosen)) setText("")
        }}
      >
        <p role="status">{chosen === null ? w.choose : w.about(chosen.line, chosen.quote)}</p>
        <div class="board-comment">
          <input
            type="text"
            aria-label={w.text}
            value={text}
            maxLength={2000}
            onInput={event => setText(event.currentTarget.value)}
          />
          <button type="submit" class="plain" disabled={chosen === null || text.trim() === ""}>
            {w.send}
          </button>
        </div>
        {link === "lost" && <p class="refused">{words.classroom.board.lost}</p>}
        {commentRefused !== null && (
          <p class="refused" role="alert">
            {commentRefused}
          </p>
        )}
      </form>
      <ul>
        {comments.map(({id, text, place, done}) => {
          const quote = quoteOf(place.piece.slice(place.start, place.end))
          const line = lines.get(id)
          return (
            <li key={id}>
              <q>{text}</q>
              <span class="quiet">
                {done || line === undefined ? quote : line === null ? w.gone(quote) : w.at(line, quote)}
              </span>
              <span>{done ? w.done : w.open}</span>
              <button type="button" class="plain" aria-label={w.removeOf(text)} onClick={() => remove(id)}>
                {w.remove}
              </button>
            </li>
          )
        })}
      </ul>
    </section>
  )
}
