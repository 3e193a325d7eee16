/// Interface of the application controller as components use it, and the hooks that read it. A component is rendered again only when its selection of the state changes.

import {useComputed} from "@preact/signals"
import type {TextFile} from "@rosy/codegen/text-file"
import {createContext} from "preact"
import {useContext} from "preact/hooks"
import type {Outline} from "../browser/block_picture.ts"
import type {ExamplePath} from "../browser/remote_resources.ts"
import type {Store} from "../browser/store.ts"
import type {RoomTests} from "../jobs/room_tests.ts"
import type {Finding, Fix} from "../program/program.ts"
import type {FoundConfusables, PageState} from "../state/page_state.ts"
import type {KeySection} from "../state/shortcuts.ts"
import type {PackedClip} from "../storage/backpack_store.ts"
import type {StoredProgram} from "../storage/stored_values.ts"
import type {NetworkEditing} from "../views/diagram/editing.ts"
import type {CausalPath} from "../views/diagram/network/causal_path.ts"
import type {OutlineLine} from "../views/diagram/network/outline.ts"
import type {LessonEditorCommands} from "./lesson_editor_commands.ts"

/// The programs of the program store, and the commands of their dialog.
export interface MyPrograms {
  list(): readonly StoredProgram[]
  deleted(): readonly StoredProgram[]
  picture(id: string): readonly Outline[]
  isOpen(id: string): boolean
  /// The Haskell of a program as it is stored; `null` if there is none.
  haskell(id: string): string | null
  open(id: string): void
  rename(id: string, name: string): void
  duplicate(id: string): void
  remove(id: string): void
  restore(id: string): void
}

/// Definitions that every program of this browser can take.
export interface Backpack {
  list(): readonly PackedClip[]
  /// The definitions of the open program that can be put in.
  candidates(): readonly string[]
  open(): void
  put(name: string): void
  /// Writes a clip into the open program and closes the dialog.
  take(clip: PackedClip): void
  remove(clip: PackedClip): void
}

export interface AppController {
  readonly store: Store
  /// The three regions that are not Preact's: each is given its element once.
  mountBlocks(host: HTMLElement): void
  mountSource(host: HTMLElement): void
  mountRoom(canvas: HTMLCanvasElement): void
  mountDiagram(host: HTMLElement): void
  readonly diagram: {
    /// Places everything anew.
    tidy(): void
    /// Whether a drag moves a node, and connects none.
    setMoving(on: boolean): void
    list(path: CausalPath): readonly OutlineLine[]
    /// Selects the block and the text of a node.
    choose(id: string): void
    /// Edits of the program in the diagram; `null` until the diagram is loaded.
    editing(): NetworkEditing | null
    saveSvg(): void
    savePng(): void
  }
  /// The world editor has its canvas; what it gives back ends with it.
  mountWorldEditor(canvas: HTMLCanvasElement): () => void
  /// Runs the program with a new random seed.
  run(): void
  openGallery(): void
  /// The path that an example drives; `null` when the service cannot compute it.
  examplePath(name: string): Promise<ExamplePath | null>
  /// Shows the rooms that there are.
  openRooms(): void
  openExample(name: string): void
  openMyPrograms(): void
  readonly backpack: Backpack
  /// Shows the list of lessons.
  openLessons(): void
  openChallenges(): void
  /// Opens a lesson and its program at the first step that is not done.
  openLesson(name: string): void
  /// The address that contains a lesson, given as its text.
  lessonLink(file: string): Promise<string>
  goToStep(place: number): void
  /// Opens the program again that the step began with.
  restartStep(): void
  /// Closes the lesson; its program stays.
  leaveLesson(): void
  readonly lessonEditor: LessonEditorCommands
  readonly myPrograms: MyPrograms
  newProgram(): void
  /// Builds and runs a program before the learner's eyes; called again, it ends.
  demonstrate(): void
  openFile(): void
  /// Opens a file that has been read already.
  openText(name: string, content: TextFile): void
  /// Opens the recording of a run on a real robot.
  openRecording(): void
  saveFile(): void
  saveHaskell(): void
  readonly roomTests: RoomTests
  /// Opens the share dialog.
  share(): void
  /// Saves the program with the film of the last run as a file that needs no service.
  saveSharedPage(): Promise<void>
  print(): void
  /// Opens the program of an embedded page in a page of its own.
  openInRosy(): void
  /// The values of the run, for a spreadsheet.
  saveTable(): void
  /// Looks `factor` times as close at the room.
  zoomRoom(factor: number): void
  fitRoom(): void
  savePicture(): void
  /// Saves the recorded run as a film.
  filmRun(kind: "webm" | "gif"): Promise<void>
  /// Begins a film of the room where there is no run to film.
  startFilm(): void
  /// Saves the film that was begun, or gives up the film of a run.
  endFilm(): void
  undo(): void
  redo(): void
  /// The keys that the page listens to.
  keys(): readonly KeySection[]
  /// Mends the program, in one step.
  applyFix(fix: Fix): void
  /// Writes what is meant in the place of characters that look right and are not, in one step.
  repairCharacters(offered: FoundConfusables): void
  /// Lays the text out anew, without losing anything.
  format(): void
  /// Makes this text the program, in one undo step.
  showProgram(text: string): void
  /// Opens the page again in another language.
  chooseLanguage(language: string): void
  /// Brings the block and the text of a problem into sight.
  showFinding(finding: Pick<Finding, "range" | "block">): void
}

export const ControllerContext = createContext<AppController | null>(null)

export function useController(): AppController {
  const controller = useContext(ControllerContext)
  if (controller === null) throw new Error("expected a panel inside the page, found none")
  return controller
}

export function usePageState<T>(choose: (state: PageState) => T): T {
  const {store} = useController()
  return useComputed(() => choose(store.drawn.value)).value
}
