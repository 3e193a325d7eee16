/// The top bar: what is open, how it is seen, and Run.

import type {VNode} from "preact"
import {type View, viewOf} from "../state/arrangement.ts"
import {awaitsProgram} from "../state/page.ts"
import {words} from "../words/index.ts"
import {ArrangeMenu} from "./arrange.tsx"
import {History} from "./history.tsx"
import {LogoIcon} from "./icons.tsx"
import {Menu} from "./menu.tsx"
import {useDesk, usePage} from "./pick.ts"
import {RunButton} from "./runbutton.tsx"
import {Segments} from "./segments.tsx"

export function TopBar(): VNode {
  const desk = useDesk()
  const size = usePage(s => s.size)
  return (
    <header class="topbar">
      <h1 class="logo">
        <LogoIcon />
        <span>{words.rosy}</span>
      </h1>
      <ProgramName />
      {size !== "phone" && (
        <button type="button" class="plain" onClick={() => desk.openGallery()}>
          {words.examples}
        </button>
      )}
      <span class="space" />
      {size !== "phone" && <ViewSwitch />}
      {size !== "phone" && <ArrangeMenu />}
      <span class="space" />
      {size !== "phone" && <History />}
      {size !== "phone" && <RunButton />}
      <Menu />
    </header>
  )
}

function ProgramName(): VNode {
  const {store} = useDesk()
  const name = usePage(s => s.name)
  const saved = usePage(s => s.saved)
  const awaited = usePage(awaitsProgram)
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
  const {store} = useDesk()
  const size = usePage(s => s.size)
  const view = usePage(s => viewOf(s.arrangement))
  const options: readonly View[] = size === "wide" ? ["blocks", "both", "haskell"] : ["blocks", "haskell"]
  return (
    <Segments
      label={words.view}
      options={options.map(v => [v, words.views[v]])}
      value={size === "wide" || view !== "both" ? view : "blocks"}
      choose={chosen => store.dispatch({kind: "view", view: chosen})}
    />
  )
}
