/// Bar of the room region: choice of the robot and of the room, safety rules, sound.

import type {VNode} from "preact"
import {useController, usePageState} from "../../ui/app_context.ts"
import {IconButton} from "../../ui/controls.tsx"
import {ChevronIcon, EditIcon, RobotsIcon, ShieldIcon, SoundIcon} from "../../ui/icons.tsx"
import {words} from "../../words/index.ts"
import {nameOfRoom} from "../dialogs/galleries.tsx"
import {DragHandle, HideButton} from "./region_header.tsx"

export function RoomBar(): VNode {
  const controller = useController()
  const {store} = controller
  const name = usePageState(s => (s.room.world === null ? "" : nameOfRoom(s.room.world)))
  const muted = usePageState(s => s.muted)
  const there = usePageState(s => s.room.world !== null)
  const held = usePageState(s => s.robots.held?.name ?? null)
  const twin = usePageState(s => s.robots.twin)
  return (
    <div class="roombar">
      <DragHandle region="room" />
      <h2>{words.room}</h2>
      <RobotChoice />
      {(held === null || twin) && (
        <button
          type="button"
          class="plain room-choice"
          aria-label={words.world.choose(name)}
          title={words.world.choose(name)}
          onClick={() => controller.openRooms()}
        >
          <span>{name}</span>
          <ChevronIcon />
        </button>
      )}
      <IconButton
        label={words.world.change}
        hidden={held !== null}
        disabled={!there}
        onClick={() => store.dispatch({kind: "world-editor-opened"})}
      >
        <EditIcon />
      </IconButton>
      <CompanionsButton />
      <span class="space" />
      <SafetySwitch />
      <IconButton
        label={muted ? words.soundOff : words.soundOn}
        aria-pressed={!muted}
        onClick={() => store.dispatch({kind: "muted", muted: !muted})}
      >
        <SoundIcon muted={muted} />
      </IconButton>
      <HideButton region="room" />
    </div>
  )
}

/// Opens the choice of the other robots. A real robot has none beside it.
function CompanionsButton(): VNode {
  const {store} = useController()
  const there = usePageState(s => s.room.world !== null)
  const held = usePageState(s => s.robots.held !== null)
  const number = usePageState(s => s.companions.length)
  return (
    <IconButton
      label={words.companions.more}
      hint={words.companions.hint}
      hidden={held}
      disabled={!there}
      data-testid="companions"
      onClick={() => store.dispatch({kind: "dialog", dialog: "companions"})}
    >
      <RobotsIcon />
      {number > 0 && <span class="count">{number}</span>}
    </IconButton>
  )
}

/// Switch of the safety rules, which hold for the simulated robot and for real ones alike.
function SafetySwitch(): VNode {
  const {store} = useController()
  const on = usePageState(s => s.safety.on)
  return (
    <IconButton
      label={words.safety.name}
      hint={on ? words.safety.on : words.safety.off}
      aria-pressed={on}
      data-testid="safety-switch"
      onClick={() => store.dispatch({kind: "safety-switched", on: !on})}
    >
      <ShieldIcon on={on} />
    </IconButton>
  )
}

/// Which robot it is, where there is a choice.
function RobotChoice(): VNode | null {
  const {store} = useController()
  const offered = usePageState(s => s.robots.offered !== null)
  const held = usePageState(s => s.robots.held?.name ?? null)
  if (!offered) return null
  return (
    <button
      type="button"
      class="plain robot-choice"
      aria-label={`${words.robots.choose}: ${held ?? words.robots.simulated}`}
      title={words.robots.choose}
      data-testid="robot-choice"
      onClick={() => store.dispatch({kind: "dialog", dialog: "robots"})}
    >
      {held ?? words.robots.simulatedShort}
    </button>
  )
}
