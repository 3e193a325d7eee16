/// Interface of the Haskell pane: what it shows, and what it reports.

import type {Finding, Fix, Program} from "../../program/program.ts"
import type {ChangeSet} from "../../program/text_changes.ts"
import type {Side} from "../../wire/classroom/shared_messages.generated.ts"
import type {CommentOnLine} from "./comment_lines.ts"
import type {CompilerInfo, Completer} from "./completion.ts"
import type {Range} from "./decorations.ts"
import type {DropPreview} from "./drop_preview.ts"
import type {NumberDragging} from "./number_drag.ts"
import type {Renamer} from "./rename_panel.ts"
import type {SharedText} from "./shared_text.ts"
import type {Documentation} from "./tooltips.ts"
import type {LineValue} from "./value_widgets.ts"

export interface HaskellPane {
  /// Shows a program. `changes` leads from the shown text to the program's; computed from the texts if absent.
  setProgram(program: Program, changes?: ChangeSet): void
  /// Whether the learner may type; before text can be read it is only shown.
  setEditable(editable: boolean): void
  /// What the compiler knows of names and places, for completion and explanations.
  setTold(told: CompilerInfo): void
  /// Marks the text of the block under the cursor; scrolls to it unless the cursor is in the text itself.
  link(range: Range | null): void
  glow(ranges: readonly Range[]): void
  /// Marks the functions that led to the answer of a question.
  explain(ranges: readonly Range[]): void
  /// Shows values at the ends of lines, and marks the branches that functions took.
  showValues(values: readonly LineValue[], taken: readonly Range[]): void
  /// Shows the teacher's comments below the lines that they are about.
  showComments(comments: readonly CommentOnLine[]): void
  mark(findings: readonly Finding[]): void
  /// Begins to edit the text, as it is, together with another page, whose user has this name. `changed` is called after each change of text and selection.
  share(side: Side, name: string, changed: () => void): SharedText
  /// The text while it is edited together; `null` otherwise.
  shared(): SharedText | null
  endSharing(): void
  /// Where the cursor is.
  cursor(): number
  /// Brings a place into sight and puts the cursor there.
  reveal(range: Range): void
  /// The offset under a place on the screen, and the way it shows itself there; `null` outside of the text.
  offsetAt(x: number, y: number): number | null
  /// Shows where a piece of text would go; `null` ends that.
  previewDrop(carried: DropPreview | null): void
  /// Where the text is on the screen; `null` while it is not to be seen or not to be changed.
  dropArea(): DOMRect | null
  /// What is selected, where the first line in sight starts, and whether the pane has the keyboard.
  position(): PanePosition
  /// Selects and scrolls to what `place` once told.
  goTo(spot: PanePosition): void
  /// Selects a place, and gives the pane the keyboard.
  select(range: Range): void
  dispose(): void
}

export interface PanePosition {
  readonly anchor: number
  readonly head: number
  readonly top: number
  readonly writes: boolean
}

export interface SourceOptions {
  readonly label: string
  /// What a screen reader adds: how to leave.
  readonly description: string
  readonly completer: Completer
  readonly explainer: Documentation
  readonly renamer: Renamer
  /// CodeMirror's own words, for its search and its lists.
  readonly phrases: {readonly [phrase: string]: string}
  /// Letters that a program has at most, and what happens instead when more is put in.
  readonly longest: number
  tooLong(): void
  /// The learner pasted text or dragged it into the pane: the whole text, and the parts that came.
  pasted(text: string, parts: readonly Range[]): void
  /// The learner wants the text laid out anew.
  format(): void
  /// The learner clicked on the values that belong to a block, or asks why about the place of the cursor.
  valueClicked(block: string): void
  asked(offset: number): void
  /// The learner moved the cursor, to this offset.
  cursorMoved(offset: number): void
  /// The dragging of the number at the cursor.
  readonly numbers: NumberDragging
  /// The text was changed in the pane, to `text`; not `isOwn` by another user who edits it, too.
  edited(text: string, changes: ChangeSet, isOwn: boolean): void
  /// The learner chose a way to mend a problem.
  mend(fix: Fix): void
  /// What can be made better at a place that has no problem.
  fixHere(offset: number): Fix | null
}
