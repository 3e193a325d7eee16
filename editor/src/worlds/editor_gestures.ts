/// Gestures of the world editor: the pointer goes down, moves, goes up. Pure.

import {
  defaultPart,
  drawnPart,
  finished,
  firstPoint,
  isGoal,
  isMovableTool,
  paintLine,
  point,
  tileOf,
  withPoint,
  withThinnedLine,
} from "./drawing_tools.ts"
import {type Gesture, remember, sameWorld, type WorldEditor} from "./editor_value.ts"
import {type Handle, handlesOf, moveHandle} from "./part_handles.ts"
import {partAt} from "./part_hit_testing.ts"
import {movePart} from "./part_movement.ts"
import {paintTile} from "./room_size.ts"
import type {Spot, World} from "./world.ts"
import {limitReached, type Part, samePart} from "./world_parts.ts"

/// A pointer that moved less than this has only clicked, m.
const click = 0.04
/// Points of what is drawn by hand lie so far apart, m: a shape to follow is coarse, a line on the floor is thinned later.
const drawStep = {draw: 0.2, line: 0.05}

export function down(editor: WorldEditor, at: Spot, reach: number): WorldEditor {
  const base = editor.world
  const begin = (gesture: Gesture, now: Partial<WorldEditor> = {}): WorldEditor => ({
    ...editor,
    base,
    gesture,
    ...now,
  })
  const {tool, chosen, world} = editor
  if (tool === "solid" || tool === "hole" || tool === "floor")
    return begin({kind: "paint", last: at}, {world: paintTile(world, at, tileOf[tool]), chosen: null})
  if (tool === "choose") {
    const handle = chosen === null ? null : handleAt(world, chosen, at, reach)
    if (chosen !== null && handle !== null) return begin({kind: "pull", part: chosen, handle, from: at})
    const part = partAt(world, at, reach)
    // A thing below the selected one is not selected by a drag of the selected one.
    const mine = chosen !== null && part !== null && samePart(part, chosen)
    return part === null
      ? {...editor, chosen: null}
      : begin({kind: "move", part: mine ? chosen : part, from: at}, {chosen: part})
  }
  if (tool === "visit" || tool === "draw" || tool === "line") {
    const longer = chosen === null ? null : withPoint(world, chosen, tool, point(editor, at))
    if (chosen !== null && longer !== null) return begin({kind: "follow", part: chosen}, {world: longer})
    const refused = limitReached(world, tool === "line" ? "line" : "goal", false)
    if (refused !== null) return {...editor, refused}
    const begun = firstPoint(world, tool, point(editor, at))
    return begin({kind: "follow", part: begun.part}, {world: begun.world, chosen: begun.part})
  }
  const kind = tool === "wall" ? "wall" : isGoal(tool) ? "goal" : "box"
  const refused = limitReached(world, kind, isMovableTool(tool))
  return refused === null ? begin({kind: "make", from: at}, {chosen: null}) : {...editor, refused}
}

export function move(editor: WorldEditor, at: Spot): WorldEditor {
  const {gesture, base, snap} = editor
  // A click moves nothing, not even onto the grid.
  const clicked = (from: Spot) => Math.hypot(at[0] - from[0], at[1] - from[1]) < click
  switch (gesture?.kind) {
    case "move":
      if (clicked(gesture.from)) return {...editor, world: base}
      return {
        ...editor,
        world: movePart(base, gesture.part, at[0] - gesture.from[0], at[1] - gesture.from[1], snap),
      }
    case "pull":
      if (clicked(gesture.from)) return {...editor, world: base}
      return {...editor, world: moveHandle(base, gesture.part, gesture.handle, at, snap)}
    case "make": {
      const made = drawnPart(editor, gesture.from, at)
      return clicked(gesture.from)
        ? {...editor, world: base, chosen: null}
        : {...editor, world: made.world, chosen: made.part}
    }
    case "follow": {
      const {part} = gesture
      const tool = part.kind === "line" ? "line" : "draw"
      const last = followedPoints(editor.world, part)?.at(-1)
      if (last === undefined) return editor
      // The grid is for corners that are clicked: a line drawn by hand is as round as the hand's way.
      const here = point(tool === "line" ? {...editor, snap: false} : editor, at)
      if (Math.hypot(here[0] - last[0], here[1] - last[1]) < drawStep[tool] - 1e-9) return editor
      // A line that is full has room again when it is thinned.
      const longer = (world: World) => withPoint(world, part, tool, here)
      const now = longer(editor.world) ?? longer(withThinnedLine(editor.world, part))
      return now === null ? {...editor, refused: "points"} : {...editor, world: now, refused: null}
    }
    case "paint": {
      const {tool} = editor
      if (tool !== "solid" && tool !== "hole" && tool !== "floor") return editor
      return {
        ...editor,
        world: paintLine(editor.world, gesture.last, at, tileOf[tool]),
        gesture: {kind: "paint", last: at},
      }
    }
    case undefined:
      return editor
  }
}

export function up(editor: WorldEditor): WorldEditor {
  const {gesture, base} = editor
  if (gesture === null) return editor
  // A click with a thing in hand puts down one of the usual size.
  const now =
    gesture.kind === "make" && editor.chosen === null
      ? (({world, part}) => ({...editor, world, chosen: part}))(defaultPart(editor, gesture.from))
      : editor
  const drawn = gesture.kind === "follow" ? withThinnedLine(now.world, gesture.part) : now.world
  const whole = {...now, world: finished(drawn), gesture: null}
  const done = sameWorld(whole.world, base) ? {...whole, world: base} : remember(whole, base)
  // After something was put down it can be moved at once; tiles and points go on.
  return gesture.kind === "make" ? {...done, tool: "choose"} : done
}

/// The points of what a pointer draws on its way; `undefined` for places that are only clicked.
function followedPoints(world: World, part: Part): readonly Spot[] | undefined {
  if (part.kind === "line") return world.lines[part.index]?.points
  const goal = part.kind === "goal" ? world.goals[part.index] : undefined
  return goal?.kind === "draw" ? goal.points : undefined
}

/// The nearest handle within the pointer's reach.
function handleAt(world: World, part: Part, at: Spot, reach: number): Handle | null {
  let best: {handle: Handle; gap: number} | null = null
  for (const handle of handlesOf(world, part)) {
    const gap = Math.hypot(handle.at[0] - at[0], handle.at[1] - at[1])
    if (gap <= reach * 1.4 && (best === null || gap < best.gap)) best = {handle, gap}
  }
  return best?.handle ?? null
}
