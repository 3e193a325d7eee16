/// What happens between the page and real robots: choosing one, having it, stopping it, losing it. Pure.

import type {ServiceMessage} from "./messages.ts"
import type {PageEvent, PageState, Step} from "./page.ts"
import {type Held, openFloor} from "./robots.ts"
import {clearRoom} from "./room.ts"
import {isActive, nextRun} from "./run.ts"

export type RobotEvent = Extract<
  PageEvent,
  {
    kind: "robots-unlocked" | "robot-taken" | "robot-left" | "estop-pressed" | "free-pressed" | "out-of-sight"
  }
>
export type RobotMessage = Extract<ServiceMessage, {op: "robots" | "robot"}>

const still = (state: PageState): Step => ({state, orders: []})

/// A real robot is driving, or is about to.
export function drives(state: Pick<PageState, "robots" | "run">): boolean {
  return state.robots.held !== null && isActive(state.run)
}

export function robotEvent(state: PageState, event: RobotEvent): Step {
  const {robots} = state
  const {held} = robots
  switch (event.kind) {
    case "robots-unlocked": {
      const asked = {...state, robots: {...robots, code: event.code, refused: null}}
      return robots.offered?.locked
        ? {state: asked, orders: [{kind: "send", message: {op: "unlock", code: event.code}}]}
        : still(asked)
    }
    case "robot-taken": {
      const {robot, who} = event
      const run = nextRun(state.run, {kind: "reset-pressed"})
      const asked = {...state, run, robots: {...robots, who, refused: null}}
      return {
        state: asked,
        orders: [{kind: "send", message: {op: "take", robot, who, run: state.runs}}],
      }
    }
    case "robot-left":
      return held === null
        ? still(state)
        : {state: letGo(state), orders: [{kind: "send", message: {op: "leave"}}]}
    case "estop-pressed":
      return held === null ? still(state) : {state, orders: [{kind: "send", message: {op: "estop"}}]}
    case "free-pressed":
      return held === null ? still(state) : {state, orders: [{kind: "send", message: {op: "free"}}]}
    case "out-of-sight": {
      if (held === null || !isActive(state.run)) return still(state)
      const run = nextRun(state.run, {kind: "stop-pressed"})
      const notice = {kind: "out-of-sight", name: held.name} as const
      return {state: {...state, run, notice}, orders: [{kind: "send", message: {op: "stop"}}]}
    }
  }
}

export function robotHeard(state: PageState, message: RobotMessage): Step {
  const {robots} = state
  if (message.op === "robots") {
    const {locked} = message
    const told = {...state, robots: {...robots, offered: {locked, robots: message.robots}}}
    // After a lost connection the page opens them again by itself.
    return locked && robots.code !== null
      ? {state: told, orders: [{kind: "send", message: {op: "unlock", code: robots.code}}]}
      : still(told)
  }
  const {link, ...rest} = message.robot
  if (link === "gone") {
    if (robots.held === null) return still(state)
    const {name, why} = rest
    return still({...letGo(state), notice: {kind: "robot-gone", name, why}})
  }
  const held: Held = {...rest, link}
  if (robots.held?.name === held.name) return still({...state, robots: {...robots, held}})
  const room = {...clearRoom(state.room, state.runs), world: openFloor(held.name)}
  const dialog = state.dialog === "robots" ? null : state.dialog
  return still({...state, robots: {...robots, held}, room, lines: [], follows: true, clock: "going", dialog})
}

/// The robot is no longer this page's; the service tells of the simulated one's room.
export function letGo(state: PageState): PageState {
  return {
    ...state,
    run: isActive(state.run) ? nextRun(state.run, {kind: "stop-pressed"}) : state.run,
    robots: {...state.robots, held: null},
    room: {...clearRoom(state.room, null), world: null},
    lines: [],
    follows: false,
  }
}

/// The service refused something about robots: it is said where they are chosen.
export function robotRefused(state: PageState, message: string): PageState {
  const code = state.robots.offered?.locked ? null : state.robots.code
  return {...state, robots: {...state.robots, refused: message, code}}
}
