/// Invitation to a class, for the board and the projector: where pupils open Rosy, the class code, and both as a QR code.

import type {VNode} from "preact"
import {type QrCode, qrCodeOf} from "../../ui/qr_code.ts"
import {words} from "../../words/index.ts"

interface Props {
  readonly code: string
  /// Empty while the computer is on no network.
  readonly addresses: readonly string[]
}

/// Modules of light around a code (ISO/IEC 18004, section 6.3.8).
const quietZone = 4

export function Invitation({code, addresses}: Props): VNode {
  const w = words.classroom.board
  const [address] = addresses
  const drawing = address === undefined ? null : qrCodeOf(`${address}#class=${code}`)
  return (
    <div class="board-invitation">
      {drawing !== null && <QrDrawing drawing={drawing} />}
      <dl>
        <dt>{w.pupilsOpen}</dt>
        <dd>{addresses.length === 0 ? w.noNetwork : addresses.map(one => <div key={one}>{one}</div>)}</dd>
        <dt>{words.classroom.code}</dt>
        <dd class="board-code" data-testid="class-code">
          {code}
        </dd>
      </dl>
    </div>
  )
}

export function QrDrawing({drawing}: {drawing: QrCode}): VNode {
  const side = drawing.size + 2 * quietZone
  return (
    <svg
      class="board-qr"
      role="img"
      aria-label={words.classroom.board.qr}
      viewBox={`${-quietZone} ${-quietZone} ${side} ${side}`}
    >
      <rect x={-quietZone} y={-quietZone} width={side} height={side} fill="#fff" />
      <path d={drawing.path} fill="#000" shape-rendering="crispEdges" />
    </svg>
  )
}
