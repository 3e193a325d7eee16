/// Commands that export the program and what the page shows: files, links, prints, pictures and recordings of the room.

import {pageAddress} from "../../browser/browser_window.ts"
import {startRecording, takePicture} from "../../browser/canvas_recording.ts"
import {linkAddress} from "../../browser/link_address.ts"
import {download, downloadBlob, fileName} from "../../browser/local_files.ts"
import type {Store} from "../../browser/store.ts"
import {memoryNames} from "../../program/written_memories.ts"
import type {AppController} from "../../ui/app_context.ts"
import {toCsv} from "../../values/quantities.ts"
import {readPalette} from "../../views/room/palette.ts"
import {words} from "../../words/index.ts"
import type {ColourScheme} from "../document/colour_scheme.ts"
import type {DocumentEditor} from "../document/document_editor.ts"
import type {PageParts} from "../document/page_parts.ts"
import type {ProgramLoader} from "./program_loader.ts"
import {share} from "./sharing.ts"

type FileCommands = Pick<
  AppController,
  "saveFile" | "saveHaskell" | "saveTable" | "share" | "saveSharedPage" | "print" | "openInRosy"
>

/// Fetched when a page is saved for the first time.
async function sharedPageModules() {
  const [{makePage}, {standaloneBlocks}] = await Promise.all([
    import("../../features/shared_page/make_page.ts"),
    import("../../features/shared_page/block_drawing.ts"),
  ])
  return {makePage, standaloneBlocks}
}

export function fileCommands(
  store: Store,
  parts: PageParts,
  editor: DocumentEditor,
  loader: ProgramLoader,
  colours: ColourScheme,
): FileCommands {
  const name = (ending: string) => fileName(store.now.name, ending)
  return {
    saveFile: () => download(name("rosy"), loader.projectText(), "application/json"),
    saveHaskell: () => download(name("hs"), loader.haskell(), "text/plain"),
    saveTable: () =>
      download(name("csv"), toCsv(store.now.room.recording, memoryNames(store.now.network)), "text/csv"),
    share() {
      editor.flush()
      store.dispatch({kind: "shared", shared: null})
      store.dispatch({kind: "dialog", dialog: "share"})
      const [text, name] = [loader.projectText(), store.now.name || words.unnamed]
      void linkAddress(pageAddress())
        .then(address => share(text, name, address))
        .then(shared => store.dispatch({kind: "shared", shared}))
    },
    async saveSharedPage() {
      const modules = await sharedPageModules().catch(() => null)
      if (modules === null) {
        // The notice would lie behind the dialog.
        store.dispatch({kind: "dialog", dialog: null})
        store.dispatch({kind: "notice", notice: {kind: "no-reader"}})
        return
      }
      const {makePage, standaloneBlocks} = modules
      editor.flush()
      editor.showBlocks()
      parts.blocks?.makeAll()
      // Blocks are drawn in light colours, which are legible on both grounds; the browser shows nothing of the change.
      let blocks: string | null = null
      try {
        colours.applyLight()
        if (parts.blocksHost !== null) blocks = standaloneBlocks(parts.blocksHost, words.regions.blocks)
      } finally {
        colours.apply()
      }
      const html = await makePage(store.now, blocks, loader.projectText(), await linkAddress(pageAddress()))
      download(name("html"), html, "text/html")
    },
    print() {
      store.dispatch({kind: "dialog", dialog: null})
      window.print()
    },
    openInRosy() {
      editor.flush()
      const address = {page: pageAddress(), reach: "page"} as const
      void share(loader.projectText(), store.now.name, address).then(({link}) =>
        window.open(link, "_blank", "noopener"),
      )
    },
  }
}

type RoomCommands = Pick<
  AppController,
  "savePicture" | "filmRun" | "startFilm" | "endFilm" | "zoomRoom" | "fitRoom"
>

/// Fetched when a film is made for the first time.
async function filmModules() {
  const [film, file] = await Promise.all([
    import("../../features/shared_page/film.ts"),
    import("../../features/shared_page/film_file.ts"),
  ])
  return {...film, ...file}
}

export function roomCommands(store: Store, parts: PageParts): RoomCommands {
  let end: (() => void) | null = null
  const save = (ending: string, blob: Blob) => downloadBlob(fileName(store.now.name, ending), blob)
  const failed = (isLive: boolean) => store.dispatch({kind: "notice", notice: {kind: "no-film", isLive}})
  return {
    savePicture() {
      if (parts.roomCanvas === null) return
      void takePicture(parts.roomCanvas).then(picture => picture !== null && save("png", picture))
    },
    async filmRun(kind) {
      if (end !== null || parts.roomCanvas === null) return
      const palette = readPalette(parts.roomCanvas)
      const cancelled = new AbortController()
      const {signal} = cancelled
      end = () => cancelled.abort()
      const modules = await filmModules().catch(() => null)
      const film = modules?.filmOf(store.now.room) ?? null
      if (modules === null || film === null) {
        end = null
        if (modules !== null) return failed(false)
        return store.dispatch({kind: "notice", notice: {kind: "no-reader"}})
      }
      const pace = modules.paceOf(film)
      const progress = (part: number) => {
        const percent = Math.floor(part * 100)
        const {film: before} = store.now
        if (before?.kind === "run" && before.percent === percent) return
        store.dispatch({kind: "film", film: {kind: "run", percent, pace}})
      }
      progress(0)
      const make = kind === "gif" ? modules.gifOf : modules.webmOf
      const file = await make(film, {palette, progress, signal})
      end = null
      store.dispatch({kind: "film", film: null})
      if (file !== null) save(kind, file)
      else if (!signal.aborted) failed(false)
    },
    startFilm() {
      if (parts.roomCanvas === null || end !== null) return
      const recording = startRecording(parts.roomCanvas, film => {
        end = null
        store.dispatch({kind: "film", film: null})
        if (film === null) failed(true)
        else save("webm", film)
      })
      if (recording === null) return
      end = () => recording.stop()
      store.dispatch({kind: "film", film: {kind: "live"}})
    },
    endFilm: () => end?.(),
    zoomRoom: factor => parts.room?.zoom(factor),
    fitRoom: () => parts.room?.whole(),
  }
}
