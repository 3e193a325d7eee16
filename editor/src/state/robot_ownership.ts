/// Robot ownership: the page's requests to take, stop and release a real robot, and the service's answers. Pure.

import {isLarge, type World} from "../worlds/world.ts"
import type {ServiceMessage} from "./messages/messages.ts"
import type {RobotEvent} from "./page_events.ts"
import type {PageState} from "./page_state.ts"
import {floorOf, type OwnedRobot} from "./robots.ts"
import {clearRoom} from "./runs/room_state.ts"
import {isActive, nextRun} from "./runs/run_state.ts"
import {noRuns} from "./runs/run_tree.ts"
import {sending, still, type Transition} from "./transition.ts"

export type RobotMessage = Extract<ServiceMessage, {op: "robots" | "robot"}>

/// A real robot is driving, or is about to.
export function isDriving({robots, run, replay}: Pick<PageState, "robots" | "run" | "replay">): boolean {
  return robots.held !== null && isActive(run) && run.run !== replay
}

export function reduceRobotEvent(state: PageState, event: RobotEvent): Transition {
  const {robots} = state
  const {held} = robots
  switch (event.kind) {
    case "robots-unlocked": {
      const asked = {...state, robots: {...robots, code: event.code, refused: null}}
      return robots.offered?.locked ? sending(asked, {op: "unlock", code: event.code}) : still(asked)
    }
    case "robot-taken": {
      const {robot, who} = event
      const run = nextRun(state.run, {kind: "reset-pressed"})
      const asked = {...state, run, robots: {...robots, who, refused: null}}
      return sending(asked, {op: "take", robot, who, run: state.runs})
    }
    case "robot-left":
      return held === null ? still(state) : sending(withoutRobot(state), {op: "leave"})
    case "estop-pressed":
      return held === null ? still(state) : sending(state, {op: "estop"})
    case "twin-switched": {
      const switched = {...state, robots: {...robots, twin: event.on}}
      return still(held === null || !isActive(state.run) ? onFloor(switched) : state)
    }
    case "free-pressed":
      return held === null ? still(state) : sending(state, {op: "free"})
    case "out-of-sight": {
      if (held === null || !isActive(state.run)) return still(state)
      const run = nextRun(state.run, {kind: "stop-pressed"})
      const notice = {kind: "out-of-sight", name: held.name} as const
      return sending({...state, run, notice}, {op: "stop"})
    }
  }
}

export function reduceRobotMessage(state: PageState, message: RobotMessage): Transition {
  const {robots} = state
  if (message.op === "robots") {
    const {op: _, ...offered} = message
    const {locked} = offered
    const told = {...state, robots: {...robots, offered}}
    // After a lost connection the page opens them again by itself.
    return locked && robots.code !== null ? sending(told, {op: "unlock", code: robots.code}) : still(told)
  }
  const {link, ...rest} = message.robot
  if (link === "gone") {
    if (robots.held === null) return still(state)
    const {name, why} = rest
    return still({...withoutRobot(state), notice: {kind: "robot-gone", name, why}})
  }
  const held: OwnedRobot = {...rest, link}
  if (robots.held?.name === held.name) return still({...state, robots: {...robots, held}})
  const dialog = state.dialog === "robots" ? null : state.dialog
  const room = robots.held === null ? state.room.world : robots.room
  return still({...onFloor({...state, robots: {...robots, held, room}}), clock: "going", dialog})
}

/// A real robot before a run on its floor, or in the room in which its twin drives. No runs were there yet.
function onFloor(state: PageState): PageState {
  const {held} = state.robots
  if (held === null) return state
  const world = floorOf(state.robots, held.name)
  return {
    ...state,
    room: {...clearRoom(state.room, state.runs), world},
    runTree: noRuns,
    lines: [],
    follows: world.open === true || isLarge(world),
  }
}

/// The service tells of the simulator's room while the page has a real robot: a twin drives there.
export function withSimulatedRoom(state: PageState, room: World): PageState {
  const told = {...state, robots: {...state.robots, room}}
  const known = state.robots.room
  // After a reset it is the same room.
  const isSame = known !== null && JSON.stringify(known) === JSON.stringify(room)
  return state.robots.twin && !isSame ? onFloor(told) : told
}

/// Without the robot; the service then sends the room of the simulated one.
export function withoutRobot(state: PageState): PageState {
  return {
    ...state,
    run: isActive(state.run) ? nextRun(state.run, {kind: "stop-pressed"}) : state.run,
    robots: {...state.robots, held: null, room: null},
    room: {...clearRoom(state.room, null), world: null},
    runTree: noRuns,
    lines: [],
    follows: false,
  }
}

/// With a refusal about robots, which the dialog of robots shows.
export function withRobotRefusal(state: PageState, message: string): PageState {
  const code = state.robots.offered?.locked ? null : state.robots.code
  return {...state, robots: {...state.robots, refused: message, code}}
}
