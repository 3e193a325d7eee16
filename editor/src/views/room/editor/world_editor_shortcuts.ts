/// Keyboard shortcuts on the world editor's canvas, and the edit or view change of each.

import {isChord, type KeyPress, type Keys} from "../../../state/shortcuts.ts"
import type {WorldEdit} from "../../../worlds/editor_value.ts"
import type {Spot} from "../../../worlds/world.ts"

export const worldKeys = {
  step: ["ArrowUp", "ArrowDown", "ArrowLeft", "ArrowRight"],
  turnLeft: [","],
  turnRight: ["."],
  press: ["Enter", "Space"],
  duplicate: ["Mod-d"],
  delete: ["Delete", "Backspace"],
  cancel: ["Escape"],
  closer: ["+"],
  further: ["-"],
  whole: ["0"],
} as const satisfies Keys

export type WorldKey =
  | WorldEdit
  | {readonly kind: "closer"}
  | {readonly kind: "further"}
  | {readonly kind: "whole"}

const arrows: Readonly<Record<string, Spot>> = {
  ArrowLeft: [-1, 0],
  ArrowRight: [1, 0],
  ArrowUp: [0, 1],
  ArrowDown: [0, -1],
}
/// What Shift makes of the keys that turn, on many keyboards.
const unshifted: Readonly<Record<string, string>> = {"<": ",", ">": "."}

/// What a key on the canvas means; `null` for what means nothing here. With Shift a step is a fine one.
export function worldKey({key, ctrlKey, metaKey, altKey, shiftKey: fine}: KeyPress): WorldKey | null {
  const press = {key: unshifted[key] ?? key, ctrlKey, metaKey, altKey, shiftKey: false}
  const names = Object.keys(worldKeys) as (keyof typeof worldKeys)[]
  const name = names.find(name => worldKeys[name].some(chord => isChord(press, chord)))
  switch (name) {
    case undefined:
      return null
    case "step": {
      const [dx, dy] = arrows[key] ?? [0, 0]
      return {kind: "step", dx, dy, fine}
    }
    case "turnLeft":
      return {kind: "turn", steps: 1, fine}
    case "turnRight":
      return {kind: "turn", steps: -1, fine}
    default:
      return {kind: name}
  }
}
