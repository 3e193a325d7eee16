/// What class mode needs of a pupil's page.

import type {BrowserStorage} from "../browser/browser_storage.ts"
import type {ProgramStore} from "../browser/program_store.ts"
import type {DocumentEditor} from "../controller/document_editor.ts"
import type {PageParts} from "../controller/page_parts.ts"
import type {ProgramLoader} from "../controller/program_loader.ts"
import type {AppController} from "../page/app_context.ts"
import type {Store} from "../state/store.ts"

export interface PageOfClass {
  readonly store: Store
  readonly loader: ProgramLoader
  readonly editor: DocumentEditor
  readonly parts: PageParts
  readonly shelf: ProgramStore
  readonly storage: BrowserStorage
  /// Brings a place of the program into sight, in the text and in the blocks.
  readonly reveal: AppController["showFinding"]
  /// The class code that the page's address contained; empty if none.
  readonly code: string
}
