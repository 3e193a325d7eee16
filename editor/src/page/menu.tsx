/// The small menu: files, sound and colours.

import type {VNode} from "preact"
import {useEffect, useRef} from "preact/hooks"
import type {Theme} from "../state/page.ts"
import {words} from "../words/index.ts"
import {History} from "./history.tsx"
import {MoreIcon} from "./icons.tsx"
import {useDesk, usePage} from "./pick.ts"
import {Segments} from "./segments.tsx"

const themes: readonly Theme[] = ["auto", "light", "dark"]

export function Menu(): VNode {
  const {store} = useDesk()
  const open = usePage(s => s.dialog === "menu")
  const box = useRef<HTMLDivElement>(null)
  const button = useRef<HTMLButtonElement>(null)
  const toggle = (to: boolean) => store.dispatch({kind: "dialog", dialog: to ? "menu" : null})

  useEffect(() => {
    if (!open) return
    const onPointer = (event: PointerEvent) => {
      if (!box.current?.contains(event.target as Node)) store.dispatch({kind: "dialog", dialog: null})
    }
    const onKey = (event: KeyboardEvent) => {
      if (event.key !== "Escape") return
      store.dispatch({kind: "dialog", dialog: null})
      button.current?.focus()
    }
    document.addEventListener("pointerdown", onPointer, true)
    document.addEventListener("keydown", onKey)
    return () => {
      document.removeEventListener("pointerdown", onPointer, true)
      document.removeEventListener("keydown", onKey)
    }
  }, [open, store])

  return (
    <div class="menu" ref={box}>
      <button
        type="button"
        class="plain icon"
        ref={button}
        title={words.menu}
        aria-label={words.menu}
        aria-expanded={open}
        onClick={() => toggle(!open)}
      >
        <MoreIcon />
      </button>
      {open && <MenuItems close={() => toggle(false)} />}
    </div>
  )
}

function MenuItems({close}: {close: () => void}): VNode {
  const desk = useDesk()
  const size = usePage(s => s.size)
  const theme = usePage(s => s.theme)
  const offered = usePage(s => s.robots.offered !== null)
  const session = usePage(s => s.session)
  const item = (text: string, act: () => void) => (
    <button
      type="button"
      class="item"
      onClick={() => {
        close()
        act()
      }}
    >
      {text}
    </button>
  )
  return (
    <div class="menu-items">
      {size === "phone" && (
        <>
          <History />
          {item(words.examples, desk.openGallery)}
        </>
      )}
      {offered && item(words.robots.choose, () => desk.store.dispatch({kind: "dialog", dialog: "robots"}))}
      {item(words.newProgram, desk.newProgram)}
      {item(words.openFile, desk.openFile)}
      {item(words.saveFile, desk.saveFile)}
      {item(words.saveHaskell, desk.saveHaskell)}
      {session !== null && (
        <a class="item" target="_blank" rel="noopener" href={`examples/teleop/?session=${session}`}>
          {words.driveByHand}
        </a>
      )}
      {item(words.format, desk.format)}
      <hr />
      <p class="label">{words.theme}</p>
      <Segments
        label={words.theme}
        options={themes.map(t => [t, words.themes[t]])}
        value={theme}
        choose={chosen => desk.store.dispatch({kind: "theme", theme: chosen})}
      />
    </div>
  )
}
