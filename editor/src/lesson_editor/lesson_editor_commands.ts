/// Commands of the lesson editor, as its components use them.

import type {DraftEdit, LessonDraft} from "./draft.ts"

export interface LessonEditorCommands {
  /// Begins a lesson with the room and the program of the page.
  begin(): void
  /// Shows a draft in the editor.
  open(name: string): void
  /// Makes a draft of a lesson from a file or a link, and shows it in the editor.
  openFile(text: string): void
  /// Closes the editor; the draft stays.
  close(): void
  remove(name: string): void
  edit(edit: DraftEdit): void
  /// The draft as it is now, between frames as well; `null` while none is shown.
  draft(): LessonDraft | null
  /// Takes the room of the page.
  useRoom(): void
  /// Takes the program of the page.
  useProgram(as: "start" | "solution"): void
  /// Opens the room and a program of the draft on the page.
  show(what: "start" | "solution"): void
  /// Shows the lesson as a pupil sees it, from its beginning.
  tryOut(): void
  /// During a trial: opens the solution in place of the program.
  trySolution(): void
  /// From the trial to the editor, with the program that was open before.
  back(): void
  save(): void
  /// The address that contains the lesson for pupils, without its solution.
  link(draft: LessonDraft): Promise<string>
}
