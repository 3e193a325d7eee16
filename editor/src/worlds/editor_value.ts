/// World editor as a value: the edited world, the selection, the current gesture, its events and the history of undo. Pure.

import type {Tool} from "./drawing_tools.ts"
import type {Handle} from "./part_handles.ts"
import type {Spot, World} from "./world.ts"
import type {Part, PartLimit} from "./world_parts.ts"

export type Gesture =
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
  /// The gesture under way, and the world before it began.
  readonly gesture: Gesture | null
  readonly base: World
  /// The keyboard's cross-hair; `null` while a pointer is used.
  readonly aim: Spot | null
  /// The limit that the last edit would have exceeded, so that it was refused; `null` for none.
  readonly refused: PartLimit | null
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

export function remember(editor: WorldEditor, before: World): WorldEditor {
  return {...editor, base: editor.world, past: [...editor.past.slice(-maxPast + 1), before], future: []}
}

export function sameWorld(a: World, b: World): boolean {
  return a === b || JSON.stringify(a) === JSON.stringify(b)
}
