/// Cards with the pupils' three words: a sheet that is printed in the place of the board, with lines to cut along.

import {render, type VNode} from "preact"
import {qrCodeOf} from "../../ui/qr_code.ts"
import type {PupilShown} from "../../wire/classroom/board_messages.generated.ts"
import {words} from "../../words/index.ts"
import {QrDrawing} from "../common/invitation.tsx"

interface Props {
  readonly pupils: readonly Pick<PupilShown, "id" | "nickname" | "words">[]
  readonly code: string
  readonly addresses: readonly string[]
}

/// Opens the browser's print dialog for the cards of these pupils.
export function printCards(pupils: Props["pupils"], invitation: Omit<Props, "pupils">): void {
  const sheet = document.createElement("article")
  sheet.className = "print-sheet"
  document.body.append(sheet)
  render(<Cards pupils={pupils} code={invitation.code} addresses={invitation.addresses} />, sheet)
  window.addEventListener("afterprint", () => sheet.remove(), {once: true})
  window.print()
}

export function Cards({pupils, code, addresses}: Props): VNode {
  const w = words.classroom.board.roster.card
  const [address] = addresses
  const drawing = address === undefined ? null : qrCodeOf(`${address}#class=${code}`)
  return (
    <ul class="board-cards">
      {pupils.map(pupil => (
        <li key={pupil.id}>
          <div>
            <h2>
              <bdi>{pupil.nickname}</bdi>
            </h2>
            <p class="board-card-words" lang="mul">
              {pupil.words}
            </p>
            <p>{w.how(words.classroom.wasHere)}</p>
            <p>
              {address ?? ""}
              <br />
              {words.classroom.code}: <b>{code}</b>
            </p>
          </div>
          {drawing !== null && <QrDrawing drawing={drawing} />}
        </li>
      ))}
    </ul>
  )
}
