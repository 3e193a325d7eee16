/// The whole page: the top bar, the regions from left to right the way a program travels, the dialogs.

import type {CSSProperties, VNode} from "preact"
import {useLayoutEffect, useRef} from "preact/hooks"
import {
  boxes,
  type Cell,
  type Grid,
  gridOf,
  type Region,
  regions,
  seen,
  type Tree,
} from "../state/arrangement.ts"
import type {PageState} from "../state/page.ts"
import {words} from "../words/index.ts"
import {RegionBorder} from "./border.tsx"
import {BottomBar} from "./bottombar.tsx"
import {GalleryDialog} from "./gallery.tsx"
import {RegionHead} from "./grip.tsx"
import {KeysDialog} from "./keys.tsx"
import {NoticeBar} from "./notice.tsx"
import {useDesk, usePage} from "./pick.ts"
import {RobotBar} from "./robotbar.tsx"
import {RobotsDialog} from "./robots.tsx"
import {RoomRegion} from "./roomregion.tsx"
import {TopBar} from "./topbar.tsx"
import {WorldEditorDialog} from "./worldeditor.tsx"

/// What is to be seen. On a wide page the learner decides, on a tablet one of the views of the program stands with the room, on a phone
/// there is one region.
export function visible(state: Pick<PageState, "size" | "arrangement" | "region">): Tree {
  const {tree, hidden} = state.arrangement
  if (state.size === "phone") return state.region
  const view = hidden.includes("blocks") && !hidden.includes("haskell") ? "blocks" : "haskell"
  return seen(tree, state.size === "tablet" ? [view] : hidden) ?? "room"
}

export function App(): VNode {
  const size = usePage(s => s.size)
  const arrangement = usePage(s => s.arrangement)
  const region = usePage(s => s.region)
  const canvas = usePage(s => s.layout.canvas)
  const grid = gridOf(visible({size, arrangement, region}))
  const shown = (one: Region) => grid.cells.has(one)
  const place = (one: Region) => placeOf(grid.cells.get(one))
  return (
    <div class={`page ${size}`} data-regions={regions.filter(shown).join(" ")}>
      <TopBar />
      <div>
        <RobotBar />
        <NoticeBar />
      </div>
      <main class="regions" style={{...tracksOf(grid), "--canvas-share": canvas}}>
        <BlocksRegion shown={shown("blocks")} style={place("blocks")} />
        <SourceRegion shown={shown("haskell")} style={place("haskell")} />
        <RoomRegion shown={shown("room")} style={place("room")} />
        {grid.dividers.map(divider => (
          <RegionBorder key={divider.path} divider={divider} style={placeOf(divider.cell)} />
        ))}
        <Landing />
      </main>
      {size === "phone" && <BottomBar />}
      <GalleryDialog />
      <WorldEditorDialog />
      <RobotsDialog />
      <KeysDialog />
    </div>
  )
}

/// The room needs this much for its controls, the program this much to be read, in rem; on a small page at most this share of it.
const leastWidth = {room: 24, program: 13}
const leastHeight = 9
const mostOfPage = 45

function tracksOf({columns, rows, cells}: Grid): CSSProperties {
  const only = (n: number) => {
    const inside = [...cells].filter(([, {column}]) => column[0] <= n && n < column[1])
    return inside.every(([one]) => one === "room")
  }
  // Parts of less than 1 in all would leave some of the page empty.
  const track = (least: number, share: number) => `minmax(min(${least}rem, ${mostOfPage}%), ${share * 100}fr)`
  return {
    gridTemplateColumns: columns
      .map((share, i) => track(only(i + 1) ? leastWidth.room : leastWidth.program, share))
      .join(" "),
    gridTemplateRows: rows.map(share => track(leastHeight, share)).join(" "),
  }
}

function placeOf(cell: Cell | undefined): CSSProperties {
  if (cell === undefined) return {}
  const {column, row} = cell
  return {gridColumn: `${column[0]} / ${column[1]}`, gridRow: `${row[0]} / ${row[1]}`}
}

/// Where the region that is being moved would be.
function Landing(): VNode | null {
  const arranging = usePage(s => s.arranging)
  if (arranging === null || arranging.next === null) return null
  const {region, next} = arranging
  const box = boxes(seen(next.tree, next.hidden) ?? "room").get(region)
  if (box === undefined) return null
  const share = (n: number) => `${n * 100}%`
  return (
    <div
      class="landing"
      style={{
        insetInlineStart: share(box.x),
        top: share(box.y),
        width: share(box.w),
        height: share(box.h),
      }}
    />
  )
}

interface Placed {
  readonly shown: boolean
  readonly style: CSSProperties
}

function BlocksRegion({shown, style}: Placed): VNode {
  const desk = useDesk()
  const host = useRef<HTMLDivElement>(null)
  useLayoutEffect(() => {
    if (host.current !== null) desk.mountBlocks(host.current)
  }, [desk])
  return (
    <section class="region blocks" aria-label={words.blocksPane} hidden={!shown} style={style}>
      <RegionHead region="blocks" />
      <div class="blocks-host" ref={host} />
    </section>
  )
}

function SourceRegion({shown, style}: Placed): VNode {
  const desk = useDesk()
  const host = useRef<HTMLDivElement>(null)
  useLayoutEffect(() => {
    if (host.current !== null) desk.mountSource(host.current)
  }, [desk])
  return (
    <section class="region haskell" aria-label={words.haskellPane} hidden={!shown} style={style}>
      <RegionHead region="haskell" />
      {/* Haskell is written from left to right in every language. */}
      <div class="source-host" dir="ltr" ref={host} />
    </section>
  )
}
