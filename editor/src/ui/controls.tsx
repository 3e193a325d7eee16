/// Shared controls: icon button, dialog, popup menu, segmented control, sentence with inline code.

import type {ComponentChildren, ComponentProps, VNode} from "preact"
import {useLayoutEffect, useRef} from "preact/hooks"
import type {PageState} from "../state/page_state.ts"
import {words} from "../words/index.ts"
import {useController, usePageState} from "./app_context.ts"
import {CloseIcon} from "./icons.tsx"

/// A button with an icon instead of words; the pointer shows the hint, by default the label.
export function IconButton({
  label,
  hint = label,
  ...rest
}: {readonly label: string; readonly hint?: string} & ComponentProps<"button">): VNode {
  return <button type="button" class="plain icon" title={hint} aria-label={label} {...rest} />
}

interface DialogProps {
  readonly name: Exclude<PageState["dialog"], null>
  readonly title: string
  readonly lead: string
  /// Made only while the dialog is open.
  readonly children: () => ComponentChildren
}

export function Dialog({name, title, lead, children}: DialogProps): VNode {
  const {store} = useController()
  const open = usePageState(s => s.dialog === name)
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

export function usePopup(name: Exclude<PageState["dialog"], null>) {
  const {store} = useController()
  const open = usePageState(s => s.dialog === name)
  const box = useRef<HTMLDivElement>(null)
  const button = useRef<HTMLButtonElement>(null)
  // What is drawn may be a frame old when something is pressed.
  const close = () => {
    if (store.now.dialog === name) store.dispatch({kind: "dialog", dialog: null})
  }
  const toggle = () => store.dispatch({kind: "dialog", dialog: store.now.dialog === name ? null : name})
  useLayoutEffect(() => {
    if (!open) return
    const onPointer = (event: PointerEvent) => {
      if (!box.current?.contains(event.target as Node)) close()
    }
    const onKey = (event: KeyboardEvent) => {
      if (event.key !== "Escape") return
      close()
      button.current?.focus()
    }
    document.addEventListener("pointerdown", onPointer, true)
    document.addEventListener("keydown", onKey)
    return () => {
      document.removeEventListener("pointerdown", onPointer, true)
      document.removeEventListener("keydown", onKey)
    }
  }, [open, store])
  return {open, box, button, close, toggle}
}

export function SegmentedControl<T extends string>(props: {
  readonly label: string
  readonly options: readonly (readonly [T, string])[]
  /// `null` when none of them is chosen.
  readonly value: T | null
  readonly choose: (value: T) => void
}): VNode {
  return (
    <fieldset class="segments" aria-label={props.label}>
      {props.options.map(([value, text]) => (
        <button
          type="button"
          key={value}
          aria-pressed={value === props.value}
          onClick={() => props.choose(value)}
        >
          {text}
        </button>
      ))}
    </fieldset>
  )
}

/// A sentence with its code in code (between backticks or ‘quotes’), and the name of the function it is about in bold.
export function TextWithCode({text, strong}: {text: string; strong: string | null}): VNode {
  return (
    <>
      {text.split(/(`[^`]+`|‘[^’]+’)/).map((part, i) => {
        const code = /^(?:`[^`]+`|‘[^’]+’)$/.test(part) ? part.slice(1, -1) : null
        if (code !== null) return code === strong ? <b key={part}>{code}</b> : <code key={part}>{code}</code>
        // Sentences about a run begin with the name of the function.
        if (i === 0 && strong !== null && part.startsWith(`${strong} `))
          return (
            <>
              <b>{strong}</b>
              {part.slice(strong.length)}
            </>
          )
        return part
      })}
    </>
  )
}
