/// State of the world editor: applies an event to the edited world, the selection and the undo history. Pointer and keyboard crosshair produce the same three events:
/// down, move, up. Pure.

import type {Tool} from "./drawing_tools.ts"
import {down, move, up} from "./editor_gestures.ts"
import {remember, sameWorld, type WorldEdit, type WorldEditor} from "./editor_value.ts"
import {clamp, gridStep, gridTurn, onGrid, tidy} from "./geometry.ts"
import {duplicate, movePart, turnPart} from "./part_movement.ts"
import {resizeWorld} from "./room_size.ts"
import type {Spot, World} from "./world.ts"
import {exceededLimit, exists, type Part, removePart} from "./world_parts.ts"

/// One centimetre, one degree.
const fineStep = 0.01
const fineTurn = Math.PI / 180
/// How far around the cross-hair is meant, m.
const aimReach = 0.12

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
    refused: null,
  }
}

export function edit(before: WorldEditor, event: WorldEdit): WorldEditor {
  // Another event finishes the gesture that has begun.
  const goesOn =
    event.kind === "move" || event.kind === "up" || event.kind === "cancel" || event.kind === "step"
  const now = goesOn || event.kind === "press" ? before : settled(before)
  // The reason of a refusal is shown until the next edit.
  const editor = goesOn ? now : {...now, refused: null}
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
      return chosen === null ? editor : changed(editor, turnPart(editor.world, chosen, by))
    }
    case "delete": {
      const {chosen} = editor
      if (chosen === null || chosen.kind === "start") return editor
      return {...changed(editor, removePart(editor.world, chosen)), chosen: null}
    }
    case "duplicate": {
      const more = editor.chosen === null ? null : duplicate(editor.world, editor.chosen)
      if (more === null) return editor
      const refused = exceededLimit(more.world)
      return refused === null ? {...changed(editor, more.world), chosen: more.part} : {...editor, refused}
    }
    case "resize":
      return changed(editor, resizeWorld(editor.world, event.width, event.height))
    case "change": {
      const refused = exceededLimit(event.world)
      if (refused !== null) return {...editor, refused}
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

function step(editor: WorldEditor, dx: number, dy: number, fine: boolean): WorldEditor {
  const by = fine ? fineStep : gridStep
  const {chosen, tool, gesture} = editor
  if (tool === "choose" && chosen !== null && gesture === null)
    return changed(editor, movePart(editor.world, chosen, dx * by, dy * by, editor.snap && !fine))
  const [x, y] = editor.aim ?? middle(editor.world)
  const [width, height] = editor.world.size
  const aim: Spot = [tidy(clamp(x + dx * by, 0, width)), tidy(clamp(y + dy * by, 0, height))]
  return {...move(editor, aim), aim}
}

const middle = (world: World): Spot => [onGrid(world.size[0] / 2), onGrid(world.size[1] / 2)]

/// Whether a tool goes on with what is chosen: points are added to a line, or to a goal of several points.
function continues(editor: WorldEditor, tool: Tool): boolean {
  const {chosen, world} = editor
  if (chosen?.kind === "line") return tool === "line"
  return chosen?.kind === "goal" && world.goals[chosen.index]?.kind === tool
}

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
