/// The whole page: the top bar, the regions from left to right the way a program travels, the dialogs.

import type {VNode} from "preact"
import {useLayoutEffect, useRef} from "preact/hooks"
import type {PageState, Region} from "../state/page.ts"
import {words} from "../words/index.ts"
import {Border} from "./border.tsx"
import {BottomBar} from "./bottombar.tsx"
import {GalleryDialog} from "./gallery.tsx"
import {NoticeBar} from "./notice.tsx"
import {useDesk, usePage} from "./pick.ts"
import {RobotBar} from "./robotbar.tsx"
import {RobotsDialog} from "./robots.tsx"
import {RoomRegion} from "./roomregion.tsx"
import {TopBar} from "./topbar.tsx"
import {WorldEditorDialog} from "./worldeditor.tsx"

/// Which regions are to be seen. On a wide page the view decides, on a tablet one of the first two stands
/// beside the room, on a phone there is one.
export function visibleRegions(state: Pick<PageState, "size" | "view" | "region">): readonly Region[] {
  if (state.size === "phone") return [state.region]
  if (state.size === "tablet") return [state.view === "haskell" ? "haskell" : "blocks", "room"]
  if (state.view === "both") return ["blocks", "haskell", "room"]
  return [state.view, "room"]
}

export function App(): VNode {
  const shown = usePage(s => visibleRegions(s).join(" "))
  const size = usePage(s => s.size)
  const layout = usePage(s => s.layout)
  const has = (region: Region) => shown.split(" ").includes(region)
  const style = {
    "--haskell-width": has("blocks") ? `${layout.haskell}px` : "1fr",
    "--room-width": `${layout.room}px`,
    "--canvas-share": layout.canvas,
  }
  return (
    <div class={`page ${size}`} data-regions={shown} style={style}>
      <TopBar />
      <div>
        <RobotBar />
        <NoticeBar />
      </div>
      <main class="regions">
        <BlocksRegion shown={has("blocks")} />
        {has("blocks") && has("haskell") && <Border of="haskell" />}
        <SourceRegion shown={has("haskell")} />
        {has("room") && size !== "phone" && <Border of="room" />}
        <RoomRegion shown={has("room")} />
      </main>
      {size === "phone" && <BottomBar />}
      <GalleryDialog />
      <WorldEditorDialog />
      <RobotsDialog />
    </div>
  )
}

function BlocksRegion({shown}: {shown: boolean}): VNode {
  const desk = useDesk()
  const host = useRef<HTMLDivElement>(null)
  useLayoutEffect(() => {
    if (host.current !== null) desk.mountBlocks(host.current)
  }, [desk])
  return (
    <section class="region blocks" aria-label={words.blocksPane} hidden={!shown}>
      <div class="blocks-host" ref={host} />
    </section>
  )
}

function SourceRegion({shown}: {shown: boolean}): VNode {
  const desk = useDesk()
  const host = useRef<HTMLDivElement>(null)
  useLayoutEffect(() => {
    if (host.current !== null) desk.mountSource(host.current)
  }, [desk])
  return (
    <section class="region haskell" aria-label={words.haskellPane} hidden={!shown}>
      <div class="source-host" ref={host} />
    </section>
  )
}
