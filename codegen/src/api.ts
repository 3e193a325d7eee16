/// Types of the results of codegen's public functions.

import type {Family, Shape} from "./block_shape.ts"
import type {BlockId, Extra, Place, SavedBlock, SavedWorkspace} from "./serialized_blocks.ts"

/// What a learner must know about a block. `input` names the socket it is about, if one.
export interface BlockProblem {
  readonly severity: "error" | "warning"
  /// As in protocol/README.md §1: `type-mismatch`, `hole`, `not-in-scope`, `ambiguous`, `duplicate`, `loose`, …
  readonly kind: string
  readonly block: BlockId | undefined
  readonly input?: string | undefined
  /// First what, one sentence.
  readonly message: string
  /// Then why, or what to do; may be empty.
  readonly hint: string
  /// Of a `conflict`: who it is between.
  readonly conflict?: ConflictNames | undefined
}

/// A command, the function whose command stays in force, and the one whose command it replaces.
export interface ConflictNames {
  readonly command: string
  readonly winner: string
  readonly loser: string
}

/// Whether a block may go somewhere; if not, why, as one sentence for the learner. `doubt` is a sentence that says why only GHC knows whether a block
/// that the blocks accept compiles there.
export type Verdict =
  | {readonly fits: true; readonly doubt?: string | undefined}
  | {readonly fits: false; readonly why: string}

/// The block that refers to a definition at some place, or, with `holds`, that holds a step in its stack of that name; if none may go there, why, as
/// one sentence for the learner.
export type Reference =
  | {readonly fits: true; readonly block: SavedBlock; readonly holds?: string}
  | {readonly fits: false; readonly why: string}

export interface TypeInfo {
  /// As Haskell writes it: `"Bumper -> Maybe Sound"`.
  readonly type: string
  readonly family: Family
}

/// The types in a group of definitions that were inferred together, or in the whole program.
export interface InferredTypes {
  readonly blocks: ReadonlyMap<BlockId, TypeInfo>
  /// Keyed by `socketKey(block, input)`.
  readonly sockets: ReadonlyMap<string, TypeInfo>
}

/// What type inference knows about a workspace.
export interface Inference extends InferredTypes {
  /// Per definition block: its name and the type for its header.
  readonly definitions: ReadonlyMap<
    BlockId,
    {readonly name: string; readonly type: string; readonly family: Family}
  >
  readonly problems: readonly BlockProblem[]
  /// Per definition block the types of its group. A session's next answer has the same value again when nothing is told of that definition that was not told before.
  readonly stamps: ReadonlyMap<BlockId, InferredTypes>
}

export function socketKey(block: BlockId, input: string): string {
  return `${block}/${input}`
}

/// Offsets in UTF-16 units, as JavaScript and CodeMirror count; `end` is exclusive.
export interface Span {
  readonly start: number
  readonly end: number
}

/// A kind of block, as far as the page needs it: how it looks and how its buttons change it.
export interface BlockView {
  readonly type: string
  shape(extra: Extra): Shape
  /// The `extraState` after a button was pressed.
  press(extra: Extra, action: string): Extra
}

/// Answers many questions about one state of the workspace; make one per drag.
export interface Checker {
  /// May `block` (with all it carries) go to `place`? A block that is there already would be pushed out.
  /// `block` may be new, or one of the workspace's, which is then taken from where it is.
  fits(place: Place, block: SavedBlock | BlockId): Verdict
}

/// Answers about one workspace as it changes. What was found out about a definition is remembered as long as it is the very same value and what it
/// uses has the same types; the answers are those that `infer`, `checker` and `namesInScope` give.
export interface Session {
  infer(workspace: SavedWorkspace): Inference
  checker(workspace: SavedWorkspace): Checker
  namesInScope(workspace: SavedWorkspace, place: Place): readonly InScope[]
  /// What a definition leaves behind when it is dropped on a socket, and what holds a step there: `definition` is one of the workspace's, or a
  /// new one with a name that nothing else has.
  referenceTo(workspace: SavedWorkspace, place: Place, definition: SavedBlock | BlockId): Reference
  /// Whether a definition that `simulate` runs overrides a reaction or a task, or is one that is overridden.
  overriddenReaction(workspace: SavedWorkspace, definition: BlockId): OverriddenReaction | undefined
}

/// A reaction or a task, the function or task whose commands would replace its own, and the block without both that lets the first go before the second.
export interface OverriddenReaction {
  readonly reaction: string
  readonly driver: string
  readonly priority: SavedBlock
}

export type Level = "tasks" | "reactions" | "haskell"

export interface ToolboxCategory {
  readonly name: string
  readonly family: Family
  readonly items: readonly ToolboxItem[]
}

export interface ToolboxItem {
  /// Words for the search.
  readonly label: string
  /// More words that find it.
  readonly also?: string
  /// Other names of the thing that it commands: who searches for one wants this item first.
  readonly names?: string
  readonly block: SavedBlock
}

/// A name that can be used at some place, with the block that says it.
export interface InScope {
  readonly name: string
  readonly type: string
  readonly family: Family
  readonly block: SavedBlock
  readonly fits: boolean
}

/// Renaming changes several blocks at once: their new `extraState`, to be set in one undo step.
export type Renaming =
  | {readonly ok: true; readonly changes: readonly {readonly block: BlockId; readonly extra: Extra}[]}
  | {readonly ok: false; readonly why: string}

export interface PrintedProgram {
  readonly text: string
  /// Every node's span; nested. Those made from a block say so.
  readonly spans: readonly (Span & {
    readonly block: BlockId | undefined
    readonly input: string | undefined
  })[]
}

export interface Project {
  readonly name: string
  readonly haskell: string
  readonly layout: {
    readonly declarations: readonly LaidOut[]
    readonly loose: readonly SavedBlock[]
    /// Where nodes of the diagram were moved to; absent where none was.
    readonly diagram?: NodePlaces
  }
  readonly world: string | {readonly [key: string]: unknown}
  readonly settings: {readonly [key: string]: unknown}
}

/// By the node's id: x to the right and y down in the node's scope, px.
export interface NodePlaces {
  readonly [node: string]: readonly [number, number]
}

export interface LaidOut {
  readonly name: string
  readonly hash: string
  readonly blocks: SavedBlock
}

export type ProjectOutcome =
  /// `notice` tells that the layout was damaged; the text is complete, and missing blocks are made from it.
  | {
      readonly ok: true
      readonly project: Project
      readonly notice?: {readonly message: string; readonly hint: string}
    }
  | {readonly ok: false; readonly message: string; readonly hint: string}

export type {SavedWorkspace}
