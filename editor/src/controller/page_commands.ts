/// Commands of dialogs and lists: rooms, gallery, language, and the display of a problem.

import {chooseLanguage} from "../browser/preferences.ts"
import {type ExamplePath, fetchExamplePath, fetchExamples, fetchRooms} from "../browser/remote_resources.ts"
import type {Store} from "../browser/store.ts"
import type {AppController} from "../ui/app_context.ts"
import type {PageParts} from "./document/page_parts.ts"

type PageCommands = Pick<
  AppController,
  "openRooms" | "openGallery" | "examplePath" | "chooseLanguage" | "showFinding"
>

export function pageCommands(store: Store, parts: PageParts): PageCommands {
  const paths = new Map<string, Promise<ExamplePath | null>>()
  let lastPath: Promise<unknown> = Promise.resolve()
  return {
    examplePath(name) {
      const known = paths.get(name)
      if (known !== undefined) return known
      // One after the other: a browser has few connections, and opening an example must not wait for pictures.
      const found = lastPath.then(() => fetchExamplePath(name))
      lastPath = found
      paths.set(name, found)
      return found
    },
    openRooms() {
      store.dispatch({kind: "dialog", dialog: "rooms"})
      if (store.now.rooms === null)
        void fetchRooms(store.now.worlds).then(rooms => store.dispatch({kind: "rooms-read", rooms}))
    },
    openGallery() {
      store.dispatch({kind: "dialog", dialog: "gallery"})
      if (store.now.gallery.kind === "there") return
      store.dispatch({kind: "gallery", gallery: {kind: "asked"}})
      void fetchExamples().then(answer =>
        store.dispatch({
          kind: "gallery",
          gallery: answer.kind === "there" ? {kind: "there", examples: answer.value} : {kind: "failed"},
        }),
      )
    },
    chooseLanguage(language) {
      chooseLanguage(language)
      const address = new URL(window.location.href)
      address.searchParams.delete("lang")
      // `assign` does not reload a page whose address stays the same.
      if (address.href === window.location.href) window.location.reload()
      else window.location.assign(address)
    },
    showFinding(finding) {
      const {size, arrangement, region} = store.now
      if (size === "phone" && region === "room") store.dispatch({kind: "region", region: "blocks"})
      const isBlocksShown =
        size === "phone" ? store.now.region === "blocks" : !arrangement.hidden.includes("blocks")
      if (finding.range !== null) parts.source?.reveal(finding.range)
      if (finding.block === null) return
      store.dispatch({kind: "selected", block: finding.block, in: "blocks"})
      if (isBlocksShown) parts.blocks?.select(finding.block)
    },
  }
}
