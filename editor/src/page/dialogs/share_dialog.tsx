/// Share dialog: the link that contains the program, its QR code, the markup that embeds it, and printing.

import type {VNode} from "preact"
import {useRef} from "preact/hooks"
import type {Shared} from "../../state/page_state.ts"
import {words} from "../../words/index.ts"
import {useController, usePageState} from "../app_context.ts"
import {Dialog} from "../controls.tsx"

export function ShareDialog(): VNode {
  return (
    <Dialog name="share" title={words.share.title} lead={words.share.lead}>
      {() => <Shares />}
    </Dialog>
  )
}

function Shares(): VNode {
  const desk = useController()
  const shared = usePageState(s => s.shared)
  if (shared === null) return <p class="quiet">{words.share.making}</p>
  return (
    <div class="share">
      <Copied label={words.share.link} text={shared.link} />
      {shared.code === null ? <p class="quiet">{words.share.noCode}</p> : <Code code={shared.code} />}
      <Copied label={words.share.embed} text={shared.embed} />
      <p>
        <button type="button" class="plain" onClick={() => desk.print()}>
          {words.share.print}
        </button>
      </p>
    </div>
  )
}

/// A text in a field, with a button that copies it.
export function Copied({label, text}: {label: string; text: string}): VNode {
  const field = useRef<HTMLInputElement>(null)
  const said = useRef<HTMLSpanElement>(null)
  const copy = () => {
    field.current?.select()
    // The Clipboard API is missing where a page is served without TLS, as on a classroom's network.
    const done = document.execCommand("copy")
    if (said.current !== null) said.current.textContent = done ? words.share.copied : words.share.notCopied
  }
  return (
    <div class="share-row">
      <label>
        <span>{label}</span>
        <input
          type="text"
          readOnly
          ref={field}
          value={text}
          onFocus={event => event.currentTarget.select()}
        />
      </label>
      <button type="button" class="plain" aria-label={`${words.share.copy}: ${label}`} onClick={copy}>
        {words.share.copy}
      </button>
      <span role="status" class="quiet" ref={said} />
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
