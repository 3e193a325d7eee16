/// The world editor as a value: the world being drawn, what is chosen, what the hand is doing, and everything that can
/// be undone. A pointer and the keyboard's cross-hair say the same three things: down, move, up. Pure.

import {finished, isGoal, make, makeUsual, paintLine, point, type Tool, tileOf, withPoint} from "./making.ts"
import {
  doubled,
  exists,
  type Handle,
  handlesOf,
  hasRoomFor,
  moved,
  type Part,
  painted,
  partAt,
  pulled,
  removed,
  resized,
  samePart,
  turned,
} from "./parts.ts"
import {clamp, gridStep, gridTurn, onGrid, tidy} from "./plane.ts"
import type {Spot, World, WorldGoal} from "./world.ts"

type Gesture =
  | {readonly kind: "move"; readonly part: Part; readonly from: Spot}
  | {readonly kind: "pull"; readonly part: Part; readonly handle: Handle; readonly from: Spot}
  | {readonly kind: "make"; readonly from: Spot}
  | {readonly kind: "follow"; readonly part: Part}
  | {readonly kind: "paint"; readonly last: Spot}

export interface WorldEditor {
  /// The world as it was opened.
  readonly opened: World
  readonly world: World
  readonly past: readonly World[]
  readonly future: readonly World[]
  readonly tool: Tool
  readonly chosen: Part | null
  readonly snap: boolean
  /// What the hand does now, and the world before it began.
  readonly gesture: Gesture | null
  readonly base: World
  /// The keyboard's cross-hair; `null` while a pointer is used.
  readonly aim: Spot | null
}

export type WorldEdit =
  /// A pointer or the cross-hair: a place in the room, and how far around it is meant (m).
  | {readonly kind: "down"; readonly at: Spot; readonly reach: number}
  | {readonly kind: "move"; readonly at: Spot}
  | {readonly kind: "up"}
  /// What was begun is taken back.
  | {readonly kind: "cancel"}
  | {readonly kind: "tool"; readonly tool: Tool}
  | {readonly kind: "snap"; readonly snap: boolean}
  | {readonly kind: "choose"; readonly part: Part | null}
  /// The arrow keys: so many steps of the grid, or with `fine` of a centimetre.
  | {readonly kind: "step"; readonly dx: number; readonly dy: number; readonly fine: boolean}
  /// The cross-hair is pressed: begins and ends what a pointer begins and ends.
  | {readonly kind: "press"}
  | {readonly kind: "turn"; readonly steps: number; readonly fine: boolean}
  | {readonly kind: "delete"}
  | {readonly kind: "duplicate"}
  | {readonly kind: "resize"; readonly width: number; readonly height: number}
  /// A panel changed the world, or a file replaced it.
  | {readonly kind: "change"; readonly world: World}
  | {readonly kind: "undo"}
  | {readonly kind: "redo"}

/// Worlds that can be gone back to.
const maxPast = 300
/// One centimetre, one degree.
const fineStep = 0.01
const fineTurn = Math.PI / 180
/// How far around the cross-hair is meant, m.
const aimReach = 0.12
/// A hand that moved less than this has only clicked, m.
const click = 0.04
/// Points of a shape that is drawn by hand lie so far apart, m.
const drawStep = 0.2

export function openEditor(world: World): WorldEditor {
  return {
    opened: world,
    world,
    past: [],
    future: [],
    tool: "choose",
    chosen: null,
    snap: true,
    gesture: null,
    base: world,
    aim: null,
  }
}

export function edit(before: WorldEditor, event: WorldEdit): WorldEditor {
  // Whatever the hand has begun counts as done when something else is done.
  const goesOn =
    event.kind === "move" || event.kind === "up" || event.kind === "cancel" || event.kind === "step"
  const editor = goesOn || event.kind === "press" ? before : settled(before)
  switch (event.kind) {
    case "down":
      return down({...editor, aim: null}, event.at, event.reach)
    case "move":
      return move(editor, event.at)
    case "up":
      return up(editor)
    case "cancel":
      return editor.gesture === null
        ? {...editor, chosen: null, tool: "choose"}
        : {...editor, world: editor.base, gesture: null, chosen: kept(editor.base, editor.chosen)}
    case "tool":
      return {
        ...settled(editor),
        tool: event.tool,
        chosen: continues(editor, event.tool) ? editor.chosen : null,
      }
    case "snap":
      return {...editor, snap: event.snap}
    case "choose":
      return {...editor, tool: "choose", chosen: kept(editor.world, event.part)}
    case "step":
      return step(editor, event.dx, event.dy, event.fine)
    case "press": {
      const at = editor.aim ?? middle(editor.world)
      return editor.gesture === null ? {...down(editor, at, aimReach), aim: at} : up(editor)
    }
    case "turn": {
      const {chosen} = editor
      const by = event.steps * (event.fine ? fineTurn : gridTurn)
      return chosen === null ? editor : changed(editor, turned(editor.world, chosen, by))
    }
    case "delete": {
      const {chosen} = editor
      if (chosen === null || chosen.kind === "start") return editor
      return {...changed(editor, removed(editor.world, chosen)), chosen: null}
    }
    case "duplicate": {
      const more = editor.chosen === null ? null : doubled(editor.world, editor.chosen)
      return more === null ? editor : {...changed(editor, more.world), chosen: more.part}
    }
    case "resize":
      return changed(editor, resized(editor.world, event.width, event.height))
    case "change": {
      const now = changed(editor, event.world)
      return {...now, chosen: kept(event.world, now.chosen)}
    }
    case "undo": {
      const last = editor.past.at(-1)
      if (last === undefined) return editor
      const past = editor.past.slice(0, -1)
      return {...editor, past, future: [editor.world, ...editor.future], ...at(last, editor.chosen)}
    }
    case "redo": {
      const [after, ...future] = editor.future
      if (after === undefined) return editor
      return {...editor, past: [...editor.past, editor.world], future, ...at(after, editor.chosen)}
    }
  }
}

export const isChanged = (editor: WorldEditor): boolean => !sameWorld(editor.world, editor.opened)

// The hand

function down(editor: WorldEditor, at: Spot, reach: number): WorldEditor {
  const base = editor.world
  const begin = (gesture: Gesture, now: Partial<WorldEditor> = {}): WorldEditor => ({
    ...editor,
    base,
    gesture,
    ...now,
  })
  const {tool, chosen, world} = editor
  if (tool === "solid" || tool === "hole" || tool === "floor")
    return begin({kind: "paint", last: at}, {world: painted(world, at, tileOf[tool]), chosen: null})
  if (tool === "choose") {
    const handle = chosen === null ? null : handleAt(world, chosen, at, reach)
    if (chosen !== null && handle !== null) return begin({kind: "pull", part: chosen, handle, from: at})
    const part = partAt(world, at, reach)
    // What lies under a chosen thing is not taken from beneath the hand.
    const mine = chosen !== null && part !== null && samePart(part, chosen)
    return part === null
      ? {...editor, chosen: null}
      : begin({kind: "move", part: mine ? chosen : part, from: at}, {chosen: part})
  }
  if (tool === "visit" || tool === "draw") {
    const longer = chosen === null ? null : withPoint(world, chosen, tool, point(editor, at))
    if (chosen !== null && longer !== null) return begin({kind: "follow", part: chosen}, {world: longer})
    if (!hasRoomFor(world, "goal")) return editor
    const first = point(editor, at)
    const goal: WorldGoal =
      tool === "visit"
        ? {kind: "visit", title: "", within: null, points: [first], r: 0.3}
        : {kind: "draw", title: "", within: null, points: [first], tolerance: 0.15}
    const part: Part = {kind: "goal", index: world.goals.length}
    return begin({kind: "follow", part}, {world: {...world, goals: [...world.goals, goal]}, chosen: part})
  }
  const kind = tool === "wall" ? "wall" : isGoal(tool) ? "goal" : "box"
  return hasRoomFor(world, kind) ? begin({kind: "make", from: at}, {chosen: null}) : editor
}

function move(editor: WorldEditor, at: Spot): WorldEditor {
  const {gesture, base, snap} = editor
  // A hand that has only clicked moves nothing: not even onto the grid.
  const clicked = (from: Spot) => Math.hypot(at[0] - from[0], at[1] - from[1]) < click
  switch (gesture?.kind) {
    case "move":
      if (clicked(gesture.from)) return {...editor, world: base}
      return {
        ...editor,
        world: moved(base, gesture.part, at[0] - gesture.from[0], at[1] - gesture.from[1], snap),
      }
    case "pull":
      if (clicked(gesture.from)) return {...editor, world: base}
      return {...editor, world: pulled(base, gesture.part, gesture.handle, at, snap)}
    case "make": {
      const made = make(editor, gesture.from, at)
      return clicked(gesture.from)
        ? {...editor, world: base, chosen: null}
        : {...editor, world: made.world, chosen: made.part}
    }
    case "follow": {
      const goal = gesture.part.kind === "goal" ? editor.world.goals[gesture.part.index] : undefined
      if (goal?.kind !== "draw") return editor
      const last = goal.points.at(-1)
      const here = point(editor, at)
      if (last !== undefined && Math.hypot(here[0] - last[0], here[1] - last[1]) < drawStep - 1e-9)
        return editor
      return {...editor, world: withPoint(editor.world, gesture.part, "draw", here) ?? editor.world}
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

function up(editor: WorldEditor): WorldEditor {
  const {gesture, base} = editor
  if (gesture === null) return editor
  // A click with a thing in hand puts down one of the usual size.
  const now =
    gesture.kind === "make" && editor.chosen === null
      ? (({world, part}) => ({...editor, world, chosen: part}))(makeUsual(editor, gesture.from))
      : editor
  const whole = {...now, world: finished(now.world), gesture: null}
  const done = sameWorld(whole.world, base) ? {...whole, world: base} : remember(whole, base)
  // After something was put down it can be moved at once; tiles and points go on.
  return gesture.kind === "make" ? {...done, tool: "choose"} : done
}

// The cross-hair

function step(editor: WorldEditor, dx: number, dy: number, fine: boolean): WorldEditor {
  const by = fine ? fineStep : gridStep
  const {chosen, tool, gesture} = editor
  if (tool === "choose" && chosen !== null && gesture === null)
    return changed(editor, moved(editor.world, chosen, dx * by, dy * by, editor.snap && !fine))
  const [x, y] = editor.aim ?? middle(editor.world)
  const [width, height] = editor.world.size
  const aim: Spot = [tidy(clamp(x + dx * by, 0, width)), tidy(clamp(y + dy * by, 0, height))]
  return {...move(editor, aim), aim}
}

const middle = (world: World): Spot => [onGrid(world.size[0] / 2), onGrid(world.size[1] / 2)]

/// Whether a tool goes on with what is chosen: points are added to a goal of several points.
function continues(editor: WorldEditor, tool: Tool): boolean {
  const {chosen, world} = editor
  return chosen?.kind === "goal" && world.goals[chosen.index]?.kind === tool
}

/// A pointer that reaches far still takes the nearest handle.
function handleAt(world: World, part: Part, at: Spot, reach: number): Handle | null {
  let best: {handle: Handle; gap: number} | null = null
  for (const handle of handlesOf(world, part)) {
    const gap = Math.hypot(handle.at[0] - at[0], handle.at[1] - at[1])
    if (gap <= reach * 1.4 && (best === null || gap < best.gap)) best = {handle, gap}
  }
  return best?.handle ?? null
}

// What can be undone

const kept = (world: World, part: Part | null): Part | null =>
  part !== null && exists(world, part) ? part : null
const at = (world: World, chosen: Part | null) => ({
  world,
  base: world,
  gesture: null,
  chosen: kept(world, chosen),
})

function settled(editor: WorldEditor): WorldEditor {
  return editor.gesture === null ? editor : up(editor)
}

function changed(editor: WorldEditor, world: World): WorldEditor {
  return sameWorld(editor.world, world) ? editor : remember({...editor, world}, editor.world)
}

function remember(editor: WorldEditor, before: World): WorldEditor {
  return {...editor, base: editor.world, past: [...editor.past.slice(-maxPast + 1), before], future: []}
}

export function sameWorld(a: World, b: World): boolean {
  return a === b || JSON.stringify(a) === JSON.stringify(b)
}
