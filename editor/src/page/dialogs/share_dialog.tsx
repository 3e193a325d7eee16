/// Share dialog: the link that contains the program, its QR code, the markup that embeds it, the page that works without a service, and printing.

import type {VNode} from "preact"
import type {Shared} from "../../state/page_state.ts"
import {useController, usePageState} from "../../ui/app_context.ts"
import {Dialog, TextWithCode} from "../../ui/controls.tsx"
import {Copied} from "../../ui/copied.tsx"
import {words} from "../../words/index.ts"

export function ShareDialog(): VNode {
  return (
    <Dialog name="share" title={words.share.title} lead={words.share.lead}>
      {() => <Shares />}
    </Dialog>
  )
}

function Shares(): VNode {
  const controller = useController()
  const shared = usePageState(s => s.shared)
  const hasFilm = usePageState(s => s.room.run !== null && s.room.recording.length > 0)
  if (shared === null) return <p class="quiet">{words.share.making}</p>
  return (
    <div class="share">
      {shared.reach !== "page" && (
        <p data-testid="reach">
          <TextWithCode text={words.share.reach[shared.reach]} strong={null} />
        </p>
      )}
      <Copied label={words.share.link} text={shared.link} />
      {shared.code === null ? <p class="quiet">{words.share.noCode}</p> : <Code code={shared.code} />}
      <Copied label={words.share.embed} text={shared.embed} />
      <p>
        <button type="button" class="plain" onClick={() => void controller.saveSharedPage()}>
          {words.share.page}
        </button>
        <br />
        <span class="quiet">{hasFilm ? words.share.pageHint : words.share.pageWithoutFilm}</span>
      </p>
      <p>
        <button type="button" class="plain" onClick={() => controller.print()}>
          {words.share.print}
        </button>
      </p>
    </div>
  )
}

/// Modules of light around a code (ISO/IEC 18004, section 6.3.8).
const quietZone = 4

function Code({code}: {code: NonNullable<Shared["code"]>}): VNode {
  const side = code.size + 2 * quietZone
  return (
    <>
      <svg
        class="qr-code"
        role="img"
        aria-label={words.share.code}
        viewBox={`${-quietZone} ${-quietZone} ${side} ${side}`}
      >
        <rect x={-quietZone} y={-quietZone} width={side} height={side} fill="#fff" />
        <path d={code.path} fill="#000" shape-rendering="crispEdges" />
      </svg>
      <p class="quiet">{words.share.codeHint}</p>
    </>
  )
}
