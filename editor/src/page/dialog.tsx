/// A dialog over the page: a heading, a sentence below it, a button that closes, and what it is about.

import type {ComponentChildren, VNode} from "preact"
import {useLayoutEffect, useRef} from "preact/hooks"
import type {PageState} from "../state/page.ts"
import {words} from "../words/index.ts"
import {CloseIcon} from "./icons.tsx"
import {useDesk, usePage} from "./pick.ts"

interface DialogProps {
  readonly name: Exclude<PageState["dialog"], null>
  readonly title: string
  readonly lead: string
  /// Made only while the dialog is open.
  readonly children: () => ComponentChildren
}

export function Dialog({name, title, lead, children}: DialogProps): VNode {
  const {store} = useDesk()
  const open = usePage(s => s.dialog === name)
  const dialog = useRef<HTMLDialogElement>(null)
  useLayoutEffect(() => {
    if (open) dialog.current?.showModal()
    else dialog.current?.close()
  }, [open])
  const close = () => {
    // Another one may have taken its place.
    if (store.now.dialog === name) store.dispatch({kind: "dialog", dialog: null})
  }
  return (
    // A click on the backdrop is a click on the dialog itself; Escape closes it through `onClose`.
    <dialog
      class={`gallery ${name}`}
      ref={dialog}
      aria-labelledby={`${name}-title`}
      // The browser tells later, also of what the page has closed itself and may have opened again since.
      onClose={() => open && close()}
      onClick={event => event.target === event.currentTarget && close()}
      onKeyDown={event => event.stopPropagation()}
    >
      {open && (
        <div class="gallery-body">
          <header>
            <div>
              <h2 id={`${name}-title`}>{title}</h2>
              <p class="quiet">{lead}</p>
            </div>
            <button type="button" class="plain icon" aria-label={words.close} onClick={close}>
              <CloseIcon />
            </button>
          </header>
          {children()}
        </div>
      )}
    </dialog>
  )
}
