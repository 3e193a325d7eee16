/// What panels may ask for. `main.ts` makes it from the store, the blocks, the text, the room and the rim.

import type {Kept} from "../run/storage.ts"
import type {Fix} from "../state/fixes.ts"
import type {KeySection} from "../state/keys.ts"
import type {Finding} from "../state/program.ts"
import type {Store} from "../store.ts"

export interface Desk {
  readonly store: Store
  /// The three regions that are not Preact's: each is given its element once.
  mountBlocks(host: HTMLElement): void
  mountSource(host: HTMLElement): void
  mountRoom(canvas: HTMLCanvasElement): void
  /// The world editor has its canvas; what it gives back ends with it.
  mountWorldEditor(canvas: HTMLCanvasElement): () => void
  /// Runs the program with new luck.
  run(): void
  openGallery(): void
  /// Shows the rooms that there are.
  openRooms(): void
  openExample(name: string): void
  openKept(id: string): void
  kept(): readonly Kept[]
  newProgram(): void
  openFile(): void
  saveFile(): void
  saveHaskell(): void
  /// The values of the run, for a spreadsheet.
  saveTable(): void
  /// Looks `factor` times as close at the room.
  zoomRoom(factor: number): void
  wholeRoom(): void
  savePicture(): void
  /// Starts a film of the room, or ends it and saves it.
  film(going: boolean): void
  undo(): void
  redo(): void
  /// The keys that the page listens to.
  keys(): readonly KeySection[]
  /// Mends the program, in one step.
  mend(fix: Fix): void
  /// Lays the text out anew, without losing anything.
  format(): void
  /// Opens the page again in another language.
  speak(language: string): void
  /// Brings the block and the text of a problem into sight.
  show(finding: Finding): void
}
