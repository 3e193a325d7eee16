/// Main menu: files, theme, language.

import type {VNode} from "preact"
import {guidePage} from "../../help/help_links.ts"
import type {Theme} from "../../state/page_state.ts"
import {useController, usePageState} from "../../ui/app_context.ts"
import {SegmentedControl, usePopup} from "../../ui/controls.tsx"
import {MoreIcon} from "../../ui/icons.tsx"
import {words} from "../../words/index.ts"
import {languages} from "../../words/language_choice.ts"
import {UndoRedo} from "./run_controls.tsx"

const themes: readonly Theme[] = ["auto", "light", "dark"]

export function MainMenu(): VNode {
  const {open, box, button, close, toggle} = usePopup("menu")
  /// The entry that had the focus is gone then.
  const leave = () => {
    close()
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
        onClick={toggle}
      >
        <MoreIcon />
      </button>
      {open && <MenuItems close={leave} />}
    </div>
  )
}

function MenuItems({close}: {close: () => void}): VNode {
  const controller = useController()
  const size = usePageState(s => s.size)
  const theme = usePageState(s => s.theme)
  const offered = usePageState(s => s.robots.offered !== null)
  const session = usePageState(s => s.session)
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
      {size === "phone" && <UndoRedo />}
      <div class="from-bar">
        {item(words.lessons.title, controller.openLessons)}
        {item(words.challenges.title, controller.openChallenges)}
        {item(words.examples, controller.openGallery)}
      </div>
      {item(words.myPrograms.title, controller.openMyPrograms)}
      {item(words.backpack.title, controller.backpack.open)}
      {offered &&
        item(words.robots.choose, () => controller.store.dispatch({kind: "dialog", dialog: "robots"}))}
      {item(words.newProgram, controller.newProgram)}
      {item(words.openFile, controller.openFile)}
      {item(words.recordings.open, controller.openRecording)}
      {item(words.saveFile, controller.saveFile)}
      {item(words.saveHaskell, controller.saveHaskell)}
      {item(words.share.menu, controller.share)}
      {session !== null && (
        <a class="item" target="_blank" rel="noopener" href={`examples/teleop/?session=${session}`}>
          {words.driveByHand}
        </a>
      )}
      {item(words.roomTests.menu, controller.roomTests.open)}
      {item(words.format, controller.format)}
      {item(words.keys.menu, () => controller.store.dispatch({kind: "dialog", dialog: "keys"}))}
      <a class="item" target="_blank" rel="noopener" href={guidePage}>
        {words.guide.menu}
      </a>
      <a class="item" target="_blank" rel="noopener" href="licenses.txt">
        {words.about(import.meta.env["VITE_ROSY_VERSION"])}
      </a>
      <hr />
      <p class="label">{words.theme}</p>
      <SegmentedControl
        label={words.theme}
        options={themes.map(t => [t, words.themes[t]])}
        value={theme}
        choose={chosen => controller.store.dispatch({kind: "theme", theme: chosen})}
      />
      <p class="label">{words.language}</p>
      <SegmentedControl
        label={words.language}
        options={Object.entries(languages).map(([language, name]) => [language, name] as const)}
        value={document.documentElement.lang}
        choose={controller.chooseLanguage}
      />
    </div>
  )
}
