/// Events of the browser window: dropped files, changed links, printing, window size, visibility and keyboard shortcuts.

import {watchFragment, watchShortcuts, watchSize, watchVisibility} from "../browser/browser_window.ts"
import {watchDrops} from "../browser/local_files.ts"
import {watchPrint} from "../browser/printing.ts"
import type {Store} from "../browser/store.ts"
import {isDriving} from "../state/robot_ownership.ts"
import {isActive} from "../state/runs/run_state.ts"
import type {AppController} from "../ui/app_context.ts"
import {words} from "../words/index.ts"
import type {ColourScheme} from "./document/colour_scheme.ts"
import type {DocumentEditor} from "./document/document_editor.ts"
import type {PageParts} from "./document/page_parts.ts"
import type {ProgramRequests} from "./program_requests.ts"
import type {FileOpening} from "./programs/recordings.ts"

export function watchWindow(store: Store, files: FileOpening, requests: ProgramRequests): void {
  watchDrops(files.opened, files.openedFolder)
  watchFragment(fragment => void requests.openLink(fragment))
  watchSize(size => store.dispatch({kind: "size", size}))
  watchVisibility(() => store.dispatch({kind: "out-of-sight"}))
}

/// Prints are light, and contain the pending edit.
export function watchPrinting(
  store: Store,
  parts: PageParts,
  editor: DocumentEditor,
  colours: ColourScheme,
): void {
  watchPrint(
    () => ({
      name: store.now.name || words.unnamed,
      haskell: store.now.document.program.text,
      blocks: parts.blocksHost,
    }),
    () => {
      editor.flush()
      editor.showBlocks()
      parts.blocks?.makeAll()
      colours.applyLight()
    },
    colours.apply,
  )
}

export function watchKeys(
  store: Store,
  {run, undo, redo, saveFile}: Pick<AppController, "run" | "undo" | "redo" | "saveFile">,
): void {
  watchShortcuts({
    emergency() {
      if (!isDriving(store.now)) return false
      store.dispatch({kind: "estop-pressed"})
      return true
    },
    space() {
      if (!isActive(store.now.run)) return false
      store.dispatch({kind: "stop-pressed"})
      return true
    },
    run() {
      if (store.now.worldEditor === null) run()
    },
    undo,
    redo,
    save: saveFile,
    help: () => store.dispatch({kind: "dialog", dialog: "keys"}),
  })
}
