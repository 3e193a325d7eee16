/// Interface of the block view in codegen's types: options, changes, and what the page can ask of it.

import type {BlockId, BlockProblem, Inference, Level, SavedBlock, SavedWorkspace} from "@rosy/codegen"
import type {NumberDragListener} from "../../browser/number_grip.ts"
import type {CommentOnBlock} from "./appearance/teacher_comments.ts"
import type {BlockValue} from "./appearance/value_labels.ts"
import type {Language} from "./construction/language.ts"
import type {Tone} from "./construction/theme.ts"
import type {BackpackAccess} from "./dragging/backpack_target.ts"
import type {TextDropTarget} from "./dragging/text_drop_target.ts"
import type {SharedClipboard} from "./interaction/clipboard.ts"

export interface BlocksOptions {
  readonly language: Language
  readonly tone: Tone
  readonly level?: Level
  /// Where copied blocks are shared with other tabs.
  readonly clipboard?: SharedClipboard
  /// Where new blocks can be let fall beside the workspace.
  readonly outside?: TextDropTarget
  /// Told when the learner chose another level in the toolbox.
  readonly onLevel?: (level: Level) => void
  /// Where Blockly's pictures are served; nothing is fetched from elsewhere.
  readonly media?: string
  readonly rightToLeft?: boolean
  /// The history that the menus use, when the page keeps one for blocks and text together.
  readonly history?: History
  /// Told when a number is dragged; without it each value is a change like one that is typed.
  readonly numbers?: NumberDragListener
  /// Questions about the run, as far as the page takes them.
  readonly questions?: Questions
  readonly backpack?: BackpackAccess
}

export interface Questions {
  /// Whether there is a run to ask about.
  canAsk(): boolean
  why(functionName: string): void
  whyNot(functionName: string): void
  /// Whether a block is part of a case that a function may take, and the question why it did not.
  hasCase(block: BlockId): boolean
  whyNotCase(block: BlockId): void
  /// Whether a definition has values, and the question why they are as they are.
  hasValue(definition: BlockId): boolean
  whyValue(definition: BlockId): void
}

export interface History {
  undo(): void
  redo(): void
  canUndo(): boolean
  canRedo(): boolean
}

/// The program as blocks, after the learner changed something.
export interface BlocksChange {
  readonly workspace: SavedWorkspace
  readonly inference: Inference
}

export interface BlocksView {
  /// Shows other blocks. Top-level blocks that did not change stay as they are; those that a grown one would cover move down. Never throws: the result
  /// is what Blockly could not show, and the blocks at their new places if some moved, otherwise `null`.
  load(saved: SavedWorkspace): {
    readonly left: readonly SavedBlock[]
    readonly moved: SavedWorkspace | null
  }
  save(): SavedWorkspace
  /// Makes the blocks outside of the visible area that were to be made later.
  makeAll(): void
  /// What inference says about the blocks as they are.
  inference(): Inference
  /// Told after each edit by the learner, and not while something is being moved. Answers how to stop.
  onChange(listener: (change: BlocksChange) => void): () => void
  /// Told when another block is chosen.
  onSelect(listener: (block: BlockId | undefined) => void): () => void
  /// Chooses a block, brings it into view and gives it the focus.
  select(block: BlockId | undefined): void
  /// Brings a block into view and leaves the focus where it is.
  reveal(block: BlockId): void
  /// Outlines the blocks that the cursor in the text is in.
  highlight(blocks: readonly BlockId[]): void
  /// Outlines the definitions of functions, by name, that led to the answer of a question.
  explain(functions: readonly string[]): void
  /// Draws definitions faintly whose text is broken just now: they show what it was before.
  dim(blocks: readonly BlockId[]): void
  /// Lets the definitions of functions glow, by name.
  glow(functions: readonly string[]): void
  /// Marks the blocks that run at the moment that is looked at, until called again.
  showRunning(blocks: readonly BlockId[]): void
  /// Shows values beside definitions, and marks the branches that functions took, until called again.
  showValues(values: readonly BlockValue[], taken: readonly BlockId[]): void
  /// Shows problems from the compiler or a run on their blocks, until called again. `accepted`: the compiler has taken
  /// the program, so what the blocks' own inference has against it is not shown.
  mark(problems: readonly BlockProblem[], accepted?: boolean): void
  /// Shows the teacher's comments at their blocks, until called again.
  showComments(comments: readonly CommentOnBlock[]): void
  setTone(tone: Tone): void
  setLevel(level: Level): void
  /// Shows only the blocks of these words in the toolbox (`lesson_files/toolbox_words.ts`); `null` for those of the level.
  /// Those that need a part which the robot lacks are left out: `missing` has the names of `robot.simulated`.
  restrict(words: readonly string[] | null, missing: readonly string[]): void
  undo(): void
  redo(): void
  canUndo(): boolean
  canRedo(): boolean
  /// How far the blocks are scrolled, in pixels, and how large they are.
  place(): {readonly x: number; readonly y: number; readonly scale: number}
  /// Scrolls and zooms to what `place` once told.
  goTo(place: {readonly x: number; readonly y: number; readonly scale: number}): void
  /// Scrolls to where the blocks begin, and makes them so small that their whole width is seen, as far as they can be read; in a lesson, smaller.
  goToStart(inLesson: boolean): void
  /// Shows everything at once, not larger than it is.
  zoomToFit(): void
  /// Brings top-level blocks that lie out of sight to the others; moves nothing else.
  bringStraysHome(): void
  /// Gives the keyboard to the workspace.
  focus(): void
  /// Gives the keyboard to the search of the toolbox.
  focusSearch(): void
  resize(): void
  dispose(): void
}
