/// Top bar: program name, view switch, Run. On a phone also the bottom bar: the visible region, and Run within reach of the thumb.

import type {RefObject, VNode} from "preact"
import {useLayoutEffect, useRef} from "preact/hooks"
import {type Region, setVisible, type View, viewOf} from "../../state/arrangement.ts"
import {awaitsProgram} from "../../state/page_state.ts"
import {useController, usePageState} from "../../ui/app_context.ts"
import {SegmentedControl} from "../../ui/controls.tsx"
import {BlocksIcon, DiagramIcon, LogoIcon, RoomIcon, StarIcon, TextIcon} from "../../ui/icons.tsx"
import {words} from "../../words/index.ts"
import {LayoutMenu} from "./layout_menu.tsx"
import {MainMenu} from "./main_menu.tsx"
import {RunButton, UndoRedo} from "./run_controls.tsx"

export function TopBar(): VNode {
  const controller = useController()
  const size = usePageState(s => s.size)
  const bar = useRef<HTMLElement>(null)
  const embedded = usePageState(s => s.embedded)
  useFullness(bar)
  if (embedded) return <EmbeddedBar />
  return (
    <header class="topbar" ref={bar}>
      <h1 class="logo">
        <LogoIcon />
        <span>{words.rosy}</span>
      </h1>
      <ProgramName />
      {size !== "phone" && (
        <button type="button" class="plain to-menu" onClick={() => controller.openLessons()}>
          {words.lessons.title}
        </button>
      )}
      {size !== "phone" && (
        <button
          type="button"
          class="plain icon to-menu"
          title={words.challenges.title}
          aria-label={words.challenges.title}
          onClick={() => controller.openChallenges()}
        >
          <StarIcon />
        </button>
      )}
      {size !== "phone" && (
        <button type="button" class="plain to-menu" onClick={() => controller.openGallery()}>
          {words.examples}
        </button>
      )}
      {size !== "phone" && (
        <button type="button" class="plain my-programs" onClick={() => controller.openMyPrograms()}>
          {words.myPrograms.title}
        </button>
      )}
      <span class="space" />
      {size !== "phone" && <ViewSwitch />}
      {size !== "phone" && <LayoutMenu />}
      <span class="space" />
      {size !== "phone" && <UndoRedo />}
      {size !== "phone" && <RunButton />}
      <MainMenu />
    </header>
  )
}

/// Sets `data-full` of a bar that has no room for all that is in it: at 1 and more the style sheet leaves out what the menu has as well.
/// How wide words are depends on the language, so it is measured.
function useFullness(bar: RefObject<HTMLElement>): void {
  useLayoutEffect(() => {
    const element = bar.current
    if (element === null) return
    const measure = () => {
      for (let full = 0; full <= fullest; full++) {
        element.dataset["full"] = String(full)
        if (element.scrollWidth <= element.clientWidth) return
      }
    }
    const watcher = new ResizeObserver(measure)
    watcher.observe(element)
    for (const part of element.children) watcher.observe(part)
    return () => watcher.disconnect()
  })
}

/// My programs, the word beside the logo, the word of the diagram, lessons, challenges and examples.
const fullest = 4

/// What an embedded page needs: the program's name, Run, and the way to a page of its own.
function EmbeddedBar(): VNode {
  const controller = useController()
  const size = usePageState(s => s.size)
  const name = usePageState(s => s.name)
  return (
    <header class="topbar">
      <h1 class="logo">
        <LogoIcon />
        <span class="hidden-text">{words.rosy}</span>
      </h1>
      <span class="embedded-name">{name === "" ? words.unnamed : name}</span>
      <span class="space" />
      <button type="button" class="plain" onClick={() => controller.openInRosy()}>
        {words.share.openInRosy}
      </button>
      {size !== "phone" && <RunButton />}
    </header>
  )
}

function ProgramName(): VNode {
  const {store} = useController()
  const name = usePageState(s => s.name)
  const saved = usePageState(s => s.saved)
  const awaited = usePageState(awaitsProgram)
  return (
    <div class="program-name">
      <span class="grower" data-text={name === "" ? words.unnamed : name}>
        <input
          type="text"
          size={1}
          aria-label={words.programName}
          value={name}
          placeholder={words.unnamed}
          maxLength={60}
          spellcheck={false}
          onInput={event => store.dispatch({kind: "renamed", name: event.currentTarget.value})}
          onKeyDown={event => event.key === "Enter" && event.currentTarget.blur()}
        />
      </span>
      <span class="saved" data-testid="saved">
        {!awaited && words.saved[saved]}
      </span>
    </div>
  )
}

function ViewSwitch(): VNode {
  const {store} = useController()
  const size = usePageState(s => s.size)
  const view = usePageState(s => viewOf(s.arrangement))
  const options: readonly View[] =
    size === "wide" ? ["blocks", "both", "haskell"] : ["blocks", "haskell", "diagram"]
  return (
    <>
      <SegmentedControl
        label={words.view}
        options={options.map(v => [v, words.views[v]])}
        value={size === "wide" || view !== "both" ? view : "blocks"}
        choose={chosen => store.dispatch({kind: "view", view: chosen})}
      />
      {size === "wide" && <DiagramSwitch />}
    </>
  )
}

/// Shows the diagram beside what else is shown.
function DiagramSwitch(): VNode {
  const {store} = useController()
  const shown = usePageState(s => !s.arrangement.hidden.includes("diagram"))
  return (
    <button
      type="button"
      class="plain diagram-switch"
      aria-label={words.diagram.show}
      aria-pressed={shown}
      title={words.diagram.showHint}
      onClick={() =>
        store.dispatch({kind: "arranged", arrangement: setVisible(store.now.arrangement, "diagram", !shown)})
      }
    >
      <DiagramIcon />
      <span>{words.diagram.show}</span>
    </button>
  )
}

const regions: readonly (readonly [Region, () => VNode])[] = [
  ["blocks", BlocksIcon],
  ["haskell", TextIcon],
  ["diagram", DiagramIcon],
  ["room", RoomIcon],
]

export function BottomBar(): VNode {
  const {store} = useController()
  const region = usePageState(s => s.region)
  return (
    <nav class="bottombar" aria-label={words.region}>
      {regions.map(([name, Icon]) => (
        <button
          type="button"
          key={name}
          class="region-button"
          aria-pressed={name === region}
          onClick={() => store.dispatch({kind: "region", region: name})}
        >
          <Icon />
          <span>{words.regions[name]}</span>
        </button>
      ))}
      <RunButton />
    </nav>
  )
}
