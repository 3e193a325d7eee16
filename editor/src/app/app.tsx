/// The whole page: top bar, regions, dialogs.

import type {CSSProperties, VNode} from "preact"
import {useLayoutEffect, useRef} from "preact/hooks"
import {RoomTestDialog} from "../features/rooms/room_test_dialog.tsx"
import {NoticeBar} from "../page/bars/notice_bar.tsx"
import {RobotBar, RobotsDialog} from "../page/bars/robots.tsx"
import {BottomBar, TopBar} from "../page/bars/toolbars.tsx"
import {WelcomeBar} from "../page/bars/welcome_bar.tsx"
import {BackpackDialog} from "../page/dialogs/backpack_dialog.tsx"
import {CompanionsDialog} from "../page/dialogs/companions_dialog.tsx"
import {GalleryDialog} from "../page/dialogs/galleries.tsx"
import {MyProgramsDialog} from "../page/dialogs/my_programs.tsx"
import {ShareDialog} from "../page/dialogs/share_dialog.tsx"
import {KeysDialog} from "../page/dialogs/shortcut_dialog.tsx"
import {WorldEditorDialog} from "../page/dialogs/world_editor.tsx"
import {DiagramRegion} from "../page/regions/diagram_region.tsx"
import {ChallengesDialog, LessonRegion, LessonsDialog} from "../page/regions/lesson_regions.tsx"
import {RegionHeader} from "../page/regions/region_header.tsx"
import {RegionResizeHandle} from "../page/regions/resize_handle.tsx"
import {RoomRegion} from "../page/regions/room_region.tsx"
import {
  boxes,
  type Cell,
  type Grid,
  gridOf,
  type Region,
  regions,
  type Tree,
  viewOf,
  visibleTree,
} from "../state/arrangement.ts"
import type {PageState} from "../state/page_state.ts"
import {useController, usePageState} from "../ui/app_context.ts"
import {words} from "../words/index.ts"

/// What is to be seen. On a wide page the learner decides, on a tablet one of the views of the program stands with the room, on a phone
/// there is one region.
export function visible(state: Pick<PageState, "size" | "arrangement" | "region">): Tree {
  const {tree, hidden} = state.arrangement
  if (state.size === "phone") return state.region
  const views: readonly Region[] = ["blocks", "haskell", "diagram"]
  const view = viewOf(state.arrangement)
  const shown = view === "haskell" || view === "diagram" ? view : "blocks"
  return visibleTree(tree, state.size === "tablet" ? views.filter(one => one !== shown) : hidden) ?? "room"
}

export function App(): VNode {
  const size = usePageState(s => s.size)
  const arrangement = usePageState(s => s.arrangement)
  const region = usePageState(s => s.region)
  const canvas = usePageState(s => s.layout.canvas)
  const grid = gridOf(visible({size, arrangement, region}))
  const shown = (one: Region) => grid.cells.has(one)
  const place = (one: Region) => placeOf(grid.cells.get(one))
  return (
    <div class={`page ${size}`} data-regions={regions.filter(shown).join(" ")}>
      <TopBar />
      <div>
        <RobotBar />
        <NoticeBar />
        {/* Class mode renders its bar there (`classroom/pupil/classroom.tsx`). */}
        <div id="class-bar" />
        <WelcomeBar />
      </div>
      <div class="workplace">
        <LessonRegion />
        <main class="regions" style={{...tracksOf(grid), "--canvas-share": canvas}}>
          <BlocksRegion shown={shown("blocks")} style={place("blocks")} />
          <SourceRegion shown={shown("haskell")} style={place("haskell")} />
          <DiagramRegion shown={shown("diagram")} style={place("diagram")} />
          <RoomRegion shown={shown("room")} style={place("room")} />
          {grid.dividers.map(divider => (
            <RegionResizeHandle key={divider.path} divider={divider} style={placeOf(divider.cell)} />
          ))}
          <Landing />
        </main>
      </div>
      {size === "phone" && <BottomBar />}
      <GalleryDialog />
      <LessonsDialog />
      <ChallengesDialog />
      <MyProgramsDialog />
      <BackpackDialog />
      <CompanionsDialog />
      <WorldEditorDialog />
      <RobotsDialog />
      <KeysDialog />
      <ShareDialog />
      <RoomTestDialog />
    </div>
  )
}

/// The room needs this much for its controls, the program this much to be read, in rem; on a small page at most this share of it.
const leastWidth = {room: 23, program: 13}
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
  const arranging = usePageState(s => s.arranging)
  if (arranging === null || arranging.next === null) return null
  const {region, next} = arranging
  const box = boxes(visibleTree(next.tree, next.hidden) ?? "room").get(region)
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
  const controller = useController()
  const host = useRef<HTMLDivElement>(null)
  useLayoutEffect(() => {
    if (host.current !== null) controller.mountBlocks(host.current)
  }, [controller])
  return (
    <section class="region blocks" aria-label={words.blocksPane} hidden={!shown} style={style}>
      <RegionHeader region="blocks" />
      <div class="blocks-host" ref={host} />
    </section>
  )
}

function SourceRegion({shown, style}: Placed): VNode {
  const controller = useController()
  const host = useRef<HTMLDivElement>(null)
  useLayoutEffect(() => {
    if (host.current !== null) controller.mountSource(host.current)
  }, [controller])
  return (
    <section class="region haskell" aria-label={words.haskellPane} hidden={!shown} style={style}>
      <RegionHeader region="haskell" />
      {/* Haskell is written from left to right in every language. */}
      <div class="source-host" dir="ltr" ref={host} />
    </section>
  )
}
