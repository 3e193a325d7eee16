/// What a click or a tap in the room asks about: an LED, the robot, or a point of its trail. Pure.

import {robot as robotTable} from "@rosy/codegen/robot"
import type {Trail} from "../../state/runs/room_state.ts"
import {aboutRobot, type SimulatedRobot, usualRobot} from "../../worlds/world.ts"
import type {Pose} from "./poses.ts"

/// `time` is in seconds of the run; `null` is the displayed moment.
export type QuestionTarget =
  | {readonly kind: "robot"}
  | {readonly kind: "place"; readonly time: number | null}
  | {readonly kind: "led"; readonly command: "Led1" | "Led2"}
  /// What the robot says.
  | {readonly kind: "speech"; readonly text: string; readonly time: number}

export interface Spot {
  readonly x: number
  readonly y: number
}

/// How far around a pointer is meant, in CSS pixels: a mouse or a pen, and a finger.
export const pointerReach = 8
export const fingerReach = 22

/// m.
const {leds} = robotTable.simulated[robotTable.usual].body
/// From the middle of an LED, m. It is drawn with half of this; the LEDs are 52 mm apart.
const ledReach = 0.04

/// The LED or else the robot where it is drawn, else the nearest point of the trail within `reach` metres: of points equally near the latest.
export function targetAt(
  robot: Pose | null,
  trail: Trail,
  at: Spot,
  reach: number,
  kind: SimulatedRobot = usualRobot,
): QuestionTarget | null {
  const away = ({x, y}: Spot) => Math.hypot(x - at.x, y - at.y)
  if (robot !== null && away(robot) < Math.max(aboutRobot(kind).body.radius, reach)) {
    // From far away an LED is no target: it is smaller than what a pointer can mean. Only the usual robot has them.
    if (kind !== usualRobot || ledReach < reach / 2) return {kind: "robot"}
    const distances = leds.map(led => away(inRoom(robot, led)))
    const led = distances.indexOf(Math.min(...distances))
    if ((distances[led] ?? ledReach) < ledReach) return {kind: "led", command: led === 0 ? "Led1" : "Led2"}
    return {kind: "robot"}
  }
  let nearest: number | null = null
  let least = reach
  for (const piece of trail)
    for (const point of piece) {
      const distance = away(point)
      if (distance > least) continue
      nearest = point.time
      least = distance
    }
  return nearest === null ? null : {kind: "place", time: nearest}
}

/// A point of the robot's base where it is in the room.
function inRoom({x, y, theta}: Pose, [ahead, left]: readonly [number, number]): Spot {
  const [cos, sin] = [Math.cos(theta), Math.sin(theta)]
  return {x: x + ahead * cos - left * sin, y: y + ahead * sin + left * cos}
}
