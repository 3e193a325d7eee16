/// Commands that export the program and what the page shows: files, links, prints, pictures and recordings of the room.

import {pageAddress} from "../browser/browser_window.ts"
import {type CanvasRecording, startRecording, takePicture} from "../browser/canvas_recording.ts"
import {download, downloadBlob, fileName} from "../browser/local_files.ts"
import type {AppController} from "../page/app_context.ts"
import {toCsv} from "../state/quantities.ts"
import type {Store} from "../state/store.ts"
import {words} from "../words/index.ts"
import type {DocumentEditor} from "./document_editor.ts"
import type {PageParts} from "./page_parts.ts"
import type {ProgramLoader} from "./program_loader.ts"
import {share} from "./sharing.ts"

type FileCommands = Pick<
  AppController,
  "saveFile" | "saveHaskell" | "saveTable" | "share" | "print" | "openInRosy"
>

export function fileCommands(store: Store, editor: DocumentEditor, loader: ProgramLoader): FileCommands {
  const name = (ending: string) => fileName(store.now.name, ending)
  return {
    saveFile: () => download(name("rosy"), loader.projectText(), "application/json"),
    saveHaskell: () => download(name("hs"), loader.haskell(), "text/plain"),
    saveTable: () => download(name("csv"), toCsv(store.now.room.recording), "text/csv"),
    share() {
      editor.flush()
      store.dispatch({kind: "shared", shared: null})
      store.dispatch({kind: "dialog", dialog: "share"})
      void share(loader.projectText(), store.now.name || words.unnamed, pageAddress()).then(shared =>
        store.dispatch({kind: "shared", shared}),
      )
    },
    print() {
      store.dispatch({kind: "dialog", dialog: null})
      window.print()
    },
    openInRosy() {
      editor.flush()
      void share(loader.projectText(), store.now.name, pageAddress()).then(({link}) =>
        window.open(link, "_blank", "noopener"),
      )
    },
  }
}

type RoomCommands = Pick<AppController, "savePicture" | "setRecording" | "zoomRoom" | "fitRoom">

export function roomCommands(store: Store, parts: PageParts): RoomCommands {
  let recording: CanvasRecording | null = null
  const save = (ending: string, blob: Blob) => downloadBlob(fileName(store.now.name, ending), blob)
  return {
    savePicture() {
      if (parts.roomCanvas === null) return
      void takePicture(parts.roomCanvas).then(picture => picture !== null && save("png", picture))
    },
    setRecording(going) {
      if (!going) return recording?.stop()
      if (parts.roomCanvas === null || recording !== null) return
      recording = startRecording(parts.roomCanvas, film => {
        recording = null
        store.dispatch({kind: "films", films: false})
        if (film === null) store.dispatch({kind: "notice", notice: {kind: "no-film"}})
        else save("webm", film)
      })
      store.dispatch({kind: "films", films: recording !== null})
    },
    zoomRoom: factor => parts.room?.zoom(factor),
    fitRoom: () => parts.room?.whole(),
  }
}
