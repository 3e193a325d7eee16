/// What class mode needs of a pupil's page.

import type {Store} from "../../browser/store.ts"
import type {DocumentEditor} from "../../controller/document/document_editor.ts"
import type {PageParts} from "../../controller/document/page_parts.ts"
import type {ProgramLoader} from "../../controller/programs/program_loader.ts"
import type {BrowserStorage} from "../../storage/browser_storage.ts"
import type {ProgramStore} from "../../storage/program_store.ts"
import type {AppController} from "../../ui/app_context.ts"

export interface PageOfClass {
  readonly store: Store
  readonly loader: ProgramLoader
  readonly editor: DocumentEditor
  readonly parts: PageParts
  readonly programStore: ProgramStore
  readonly storage: BrowserStorage
  /// Brings a place of the program into sight, in the text and in the blocks.
  readonly reveal: AppController["showFinding"]
  /// The class code that the page's address contained; empty if none.
  readonly code: string
}
