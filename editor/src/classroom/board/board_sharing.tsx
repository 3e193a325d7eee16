/// Editing together on the teacher's board: the question to the pupil, its answer, and the end, above the pupil's program.

import type {VNode} from "preact"
import type {BoardRequest} from "../../wire/classroom/board_messages.generated.ts"
import {words} from "../../words/index.ts"
import {board, change, type ShownProgram} from "./board_state.ts"

interface Props {
  readonly shown: ShownProgram
  /// The copy is as the pupil has saved it.
  readonly follows: boolean
  readonly send: (request: BoardRequest) => void
}

export function BoardSharing({shown: {nickname, pupil, program}, follows, send}: Props): VNode {
  const w = words.classroom.board.sharing
  const {sharing, sharingLine, sharingRefused} = board.value
  const isGoing = sharing === "asked" || sharing === "on"
  return (
    <>
      <p role="status" class={sharing === "on" ? "" : "quiet"} data-testid="board-sharing">
        {sharing !== null
          ? w[sharing](nickname)
          : program === null
            ? words.classroom.board.readOnly
            : w.follows}
      </p>
      {!isGoing && !follows && <p role="status">{w.changed}</p>}
      {sharing === "on" && sharingLine !== null && <p class="quiet">{w.line(nickname, sharingLine)}</p>}
      {sharingRefused !== null && (
        <p class="refused" role="alert">
          {sharingRefused}
        </p>
      )}
      {isGoing ? (
        <button type="button" class="plain" onClick={() => send({op: "end-sharing"})}>
          {sharing === "on" ? words.classroom.sharing.end : w.withdraw}
        </button>
      ) : (
        program !== null && (
          <button
            type="button"
            class="plain"
            onClick={() => {
              change({sharingRefused: null})
              send({op: "ask-to-share", pupil, program})
            }}
          >
            {w.ask}
          </button>
        )
      )}
    </>
  )
}
