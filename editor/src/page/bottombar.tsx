/// On a phone: which region is seen, and Run within reach of the thumb.

import type {VNode} from "preact"
import type {Region} from "../state/arrangement.ts"
import {words} from "../words/index.ts"
import {BlocksIcon, RoomIcon, TextIcon} from "./icons.tsx"
import {useDesk, usePage} from "./pick.ts"
import {RunButton} from "./runbutton.tsx"

const regions: readonly (readonly [Region, () => VNode])[] = [
  ["blocks", BlocksIcon],
  ["haskell", TextIcon],
  ["room", RoomIcon],
]

export function BottomBar(): VNode {
  const {store} = useDesk()
  const region = usePage(s => s.region)
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
