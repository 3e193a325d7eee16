/// Room region: bar, canvas with overlays, time bar, and tabs.

import type {CSSProperties, VNode} from "preact"
import {useLayoutEffect, useRef} from "preact/hooks"
import {PreviewNote} from "../../features/preview/preview_note.tsx"
import {TwinNote} from "../../features/runs/twin_note.tsx"
import {RobotWhy, WhyPanel} from "../../features/why/why_panel.tsx"
import {useController, usePageState} from "../../ui/app_context.ts"
import {words} from "../../words/index.ts"
import {RoomsDialog} from "../dialogs/galleries.tsx"
import {CanvasResizeHandle} from "./resize_handle.tsx"
import {RoomBar} from "./room_bar.tsx"
import {Goals, Hands, Held, Override, Readout} from "./room_overlays.tsx"
import {Tabs} from "./room_tabs.tsx"
import {RoomViewControls} from "./room_view_controls.tsx"
import {ContinueBar, TimeBar} from "./time_bar.tsx"

export function RoomRegion({shown, style}: {shown: boolean; style: CSSProperties}): VNode {
  const controller = useController()
  const canvas = useRef<HTMLCanvasElement>(null)
  const world = usePageState(s => s.room.world?.name ?? "")
  const held = usePageState(s => s.robots.held?.name ?? null)
  useLayoutEffect(() => {
    if (canvas.current !== null) controller.mountRoom(canvas.current)
  }, [controller])
  return (
    <section class="region room" aria-label={words.room} hidden={!shown} style={style}>
      <div class="room-parts">
        <RoomBar />
        <div class="canvas-host">
          {/* biome-ignore-start lint/a11y/noNoninteractiveTabindex: the robot is moved and the view zoomed by keys */}
          {/* biome-ignore-start lint/a11y/noInteractiveElementToNoninteractiveRole: an application takes keys */}
          <canvas
            ref={canvas}
            role="application"
            tabIndex={0}
            aria-label={held === null ? words.roomLabel(world) : words.robots.floor(held)}
            aria-describedby="robot-readout"
          />
          {/* biome-ignore-end lint/a11y/noNoninteractiveTabindex: see above */}
          {/* biome-ignore-end lint/a11y/noInteractiveElementToNoninteractiveRole: see above */}
          <Hands />
          <Held />
          <Readout />
          <Override />
          <Goals />
          <PreviewNote />
          <TwinNote />
          <RobotWhy />
          <RoomViewControls />
        </div>
        <TimeBar />
        <ContinueBar />
        <WhyPanel />
        <CanvasResizeHandle />
        <Tabs />
      </div>
      <RoomsDialog />
    </section>
  )
}
