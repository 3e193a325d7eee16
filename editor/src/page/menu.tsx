/// The small menu: files, sound and colours.

import type {VNode} from "preact"
import type {Theme} from "../state/page.ts"
import {words} from "../words/index.ts"
import {languages} from "../words/languages.ts"
import {History} from "./history.tsx"
import {MoreIcon} from "./icons.tsx"
import {useDesk, usePage} from "./pick.ts"
import {usePopup} from "./popup.ts"
import {Segments} from "./segments.tsx"

const themes: readonly Theme[] = ["auto", "light", "dark"]

export function Menu(): VNode {
  const {open, box, button, toggle} = usePopup("menu")
  /// The entry that had the focus is gone then.
  const leave = () => {
    toggle(false)
    button.current?.focus()
  }
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
      {open && <MenuItems close={leave} />}
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
      {item(words.keys.menu, () => desk.store.dispatch({kind: "dialog", dialog: "keys"}))}
      <hr />
      <p class="label">{words.theme}</p>
      <Segments
        label={words.theme}
        options={themes.map(t => [t, words.themes[t]])}
        value={theme}
        choose={chosen => desk.store.dispatch({kind: "theme", theme: chosen})}
      />
      <p class="label">{words.language}</p>
      <Segments
        label={words.language}
        options={Object.entries(languages).map(([language, name]) => [language, name] as const)}
        value={document.documentElement.lang}
        choose={desk.speak}
      />
    </div>
  )
}
