/// Shape of a block without Blockly: rows of labels, fields and sockets.
///
/// The page builds real blocks from this and asks again whenever `extraState` changed. A field's `key` is a
/// dotted path into `extraState` (`"name"`, `"fields.1.type"`); `setIn` changes it there.

import type {Extra, Json} from "./serialized_blocks.ts"

/// What a thing is, told by colour and by outline (page/README.md): event hexagon, state round, command tag,
/// memory double outline, task statement notch, number pill, choice and own plain.
export type Family = "event" | "state" | "command" | "memory" | "task" | "number" | "choice" | "own"

/// What may be plugged into a socket, apart from its type.
export type Sort = "expression" | "pattern"

/// What may be stacked: definitions (in `where` and `let`) or steps (in a task or another `do`).
export type StackSort = "definition" | "step"

export type Item =
  /// `unit`: the unit of what stands before it.
  | {readonly kind: "label"; readonly text: string; readonly strong?: boolean; readonly unit?: boolean}
  /// Free text. `lines` says that it may be several lines of Haskell.
  | {
      readonly kind: "text"
      readonly key: string
      readonly value: string
      readonly aria: string
      readonly lines?: boolean
    }
  /// A Haskell number literal, as text: `"0.5"`, `"2"`.
  | {readonly kind: "number"; readonly key: string; readonly value: string; readonly aria: string}
  /// A menu; each option is [what the learner sees, the value].
  | {
      readonly kind: "menu"
      readonly key: string
      readonly value: string
      readonly options: readonly (readonly [string, string])[]
      readonly aria: string
    }
  /// A name that this block brings into scope. Rename through `rename`, so that its references follow;
  /// dragging it out makes a `name` block.
  | {
      readonly kind: "binder"
      readonly key: string
      readonly value: string
      readonly aria: string
      /// A name of a type, which is no value: no block that refers to it can be dragged out.
      readonly ofType?: true
    }
  /// A name that this block refers to; not edited by hand.
  | {readonly kind: "reference"; readonly key: string; readonly value: string; readonly aria: string}
  /// A Haskell type, as text.
  | {readonly kind: "type"; readonly key: string; readonly value: string; readonly aria: string}
  /// The type of a definition: the written one, or while `value` is empty the inferred one, which
  /// `Inference.definitions` has.
  | {readonly kind: "signature"; readonly key: string; readonly value: string; readonly aria: string}
  /// A small button, for more or fewer sockets: `press(spec, extra, action)` answers the new `extraState`.
  /// Sockets come and go at the end of their group, so every other socket keeps its name.
  /// The action `look-inside` changes no block: the page shows the definition behind the block. Its text is drawn as a magnifying glass.
  | {readonly kind: "button"; readonly action: string; readonly text: "+" | "−" | "⌕"; readonly aria: string}
  /// `hint` says in a word or two what is wanted here, for an empty socket.
  | {
      readonly kind: "socket"
      readonly name: string
      readonly sort: Sort
      readonly aria: string
      readonly hint?: string
    }
  | {readonly kind: "stack"; readonly name: string; readonly sort: StackSort; readonly aria: string}

export type Row = readonly Item[]

/// How a block connects upwards: it stands alone, plugs into a socket, or stands in a stack. A definition
/// stands alone on the workspace and stacks inside `where` and `let`.
export type Connects = {readonly as: "top"} | {readonly as: Sort} | {readonly as: StackSort}

export interface Shape {
  /// The family it has by itself; where the type decides, `Inference.blocks` knows better.
  readonly family: Family
  readonly connects: Connects
  readonly rows: readonly Row[]
  /// One or two sentences with an example.
  readonly tooltip: string
  /// What a screen reader calls the block.
  readonly aria: string
  /// What Haddock says more about, as its anchors do: `v:wait` a value or constructor, `t:Velocity` a type.
  readonly help?: string
  /// What its menu offers beside Blockly's own: `press(extra, action)` answers the new `extraState`.
  readonly menu?: readonly MenuEntry[]
}

export interface MenuEntry {
  readonly action: string
  readonly text: string
}

/// A copy of `extra` with the value at a dotted path replaced.
export function setIn(extra: Extra, key: string, value: Json): Extra {
  return put(extra, key.split("."), value) as Extra
}

function put(at: Json | undefined, path: readonly string[], value: Json): Json {
  const [first, ...rest] = path
  if (first === undefined) return value
  if (Array.isArray(at)) {
    const copy: Json[] = [...at]
    copy[Number(first)] = put(copy[Number(first)], rest, value)
    return copy
  }
  const object = typeof at === "object" && at !== null ? (at as Extra) : {}
  return {...object, [first]: put(object[first], rest, value)}
}
