import type {VNode} from "preact"
import {useRef} from "preact/hooks"
import {words} from "../words/index.ts"

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
