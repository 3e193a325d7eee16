/// A small menu that its button opens: it closes with Escape, which gives the button the keyboard again, and with a press anywhere else.

import {useLayoutEffect, useRef} from "preact/hooks"
import type {PageState} from "../state/page.ts"
import {useDesk, usePage} from "./pick.ts"

export function usePopup(name: Exclude<PageState["dialog"], null>) {
  const {store} = useDesk()
  const open = usePage(s => s.dialog === name)
  const box = useRef<HTMLDivElement>(null)
  const button = useRef<HTMLButtonElement>(null)
  const toggle = (to: boolean) => store.dispatch({kind: "dialog", dialog: to ? name : null})
  useLayoutEffect(() => {
    if (!open) return
    const close = () => store.dispatch({kind: "dialog", dialog: null})
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
  return {open, box, button, toggle}
}
