/// The words of the world editor and of the gallery of rooms in English.

import type {Spot} from "../../worlds/world.ts"
import {measuresOf} from "../number_formats.ts"

const {metres, degrees} = measuresOf("en")
const place = ([x, y]: Spot) => `${metres(x)}, ${metres(y)}`

export const world = {
  rooms: "Rooms",
  roomsLead: "Choose where the robot drives. Your program stays as it is.",
  roomsLoading: "Looking for the rooms…",
  choose: (name: string) => `Room to drive in: ${name}`,
  change: "Change this room",
  /// Title of a room of the gallery that the learner has changed.
  changed: (room: string) => `${room}, changed`,
  title: "Change this room",
  done: "Done",
  leave: "Leave it as it was",
  tools: "What to draw",
  toolNames: {
    choose: "Choose",
    wall: "Wall",
    box: "Block",
    crate: "Box to push",
    round: "Post",
    drum: "Drum to push",
    solid: "Wall tiles",
    hole: "Holes",
    floor: "Floor",
    reach: "Come here",
    touch: "Touch here",
    avoid: "Stay away",
    visit: "Visit all",
    lap: "Lap line",
    draw: "Draw this",
  },
  toolHints: {
    choose: "Drag things to move them. Drag a handle to change or turn them.",
    wall: "Drag from one end of the wall to the other.",
    box: "Drag from corner to corner. A block stays where it is.",
    crate: "Drag from corner to corner. The robot can push this box.",
    round: "Drag from the middle to the rim. A post stays where it is.",
    drum: "Drag from the middle to the rim. The robot can push this drum.",
    solid: "Drag over the floor to fill tiles with wall.",
    hole: "Drag over the floor to make holes. The robot's wheels drop into them.",
    floor: "Drag over walls or holes to make them floor again.",
    reach: "Drag a circle. The robot should come into it.",
    touch: "Drag a circle. The robot should bump into something there.",
    avoid: "Drag a circle. The robot should stay out of it.",
    visit: "Click each place that the robot should visit.",
    lap: "Drag the line that each lap crosses.",
    draw: "Draw the path that the robot should follow, or click its corners.",
  },
  sheetLabel:
    "The room from above. Arrow keys move what is chosen, or a cross-hair; Enter begins and ends a drawing; comma and full stop turn; Delete takes away.",
  aimAt: (at: Spot) => `At ${place(at)}`,
  startFaults: {
    outside: "The robot would start outside the room. Move it before you go on.",
    wall: "The robot would start inside a wall; it needs 0.35 metres of free floor. Move it before you go on.",
    hole: "The robot would start over a hole; it needs floor under it. Move it before you go on.",
  },
  refused: {
    things: (most: number) =>
      `A room can hold at most ${most} walls, boxes and posts. Delete one before you draw another.`,
    movable: (most: number) =>
      `At most ${most} things in a room can be pushed. Delete one, or draw one that stands still.`,
    goals: (most: number) => `A room can have at most ${most} goals. Delete one before you add another.`,
  },
  snap: "Snap to the grid",
  room: "This room",
  name: "Name",
  width: "Width",
  height: "Height",
  x: "x",
  y: "y",
  angle: "Angle",
  radius: "Radius",
  length: "Length",
  movable: "Can be pushed",
  mass: "Weight",
  delete: "Take away",
  duplicate: "One more",
  things: "In this room",
  goalTitle: "What to do",
  tolerance: "How near",
  laps: "Laps",
  timed: "In a given time",
  within: "Time",
  avoids: {bumps: "The robot should bump into nothing", holes: "No wheel should drop"},
  realistic: "Wheels slip, as on a real floor",
  dock: "A dock where the robot starts",
  scanner: "The robot has a distance sensor",
  openFile: "Open a room…",
  saveFile: "Save this room",
  start: "Start of the robot",
  wall: (n: number) => `Wall ${n}`,
  box: (n: number, movable: boolean) => `${movable ? "Box" : "Block"} ${n}`,
  round: (n: number, movable: boolean) => `${movable ? "Drum" : "Post"} ${n}`,
  /// What a goal without a title of its own is called; the service says the same (`world/goals.py`).
  goals: {
    reach: "Come to the place",
    touch: "Touch the thing",
    avoid: "Stay away",
    visit: "Visit all the places",
    lap: "Drive a lap",
    draw: "Draw the shape",
  },
  /// Parts of a room for a screen reader: what it is and where. `name` is the part's short name.
  described: {
    start: (name: string, at: Spot, angle: number) => `${name} at ${place(at)}, looking ${degrees(angle)}`,
    line: (name: string, from: Spot, to: Spot) => `${name} from ${place(from)} to ${place(to)}`,
    box: (name: string, at: Spot, [w, h]: Spot, angle: number) =>
      `${name} at ${place(at)}, ${metres(w)} by ${metres(h)}${angle === 0 ? "" : `, turned ${degrees(angle)}`}`,
    circle: (name: string, at: Spot, r: number) => `${name} at ${place(at)}, radius ${metres(r)}`,
    points: (name: string, n: number) => `${name}, ${n} points`,
    at: (name: string, at: Spot) => `${name} at ${place(at)}`,
  },
} as const
