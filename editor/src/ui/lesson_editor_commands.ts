/// Commands of the lesson editor, as its components use them.

import type {Signal} from "@preact/signals"
import type {Rehearsal} from "../jobs/rehearsal.ts"
import type {DraftEdit, LessonDraft} from "../lesson_files/draft.ts"

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
  /// The program of the page.
  program(): string
  /// Opens the room of the draft on the page, and a program of it.
  show(program: string): void
  /// The latest rehearsal of a draft in this tab; `null` before the first.
  readonly rehearsal: Signal<Rehearsal | null>
  /// Lets the service run the solution and the wrong attempts of the draft.
  rehearse(): void
  /// Shows the lesson as a pupil sees it, from its beginning, and rehearses it.
  tryOut(): void
  /// During a trial: opens the solution in place of the program.
  trySolution(): void
  /// From the trial to the editor, with the program that was open before.
  back(): void
  save(): void
  /// The address that contains the lesson for pupils, without its solution.
  link(draft: LessonDraft): Promise<string>
}
