/// Gathers the shared page from the open program: loaded when a person first saves one.

import {hash, script} from "virtual:film-player"
import type {LinkAddress} from "../../browser/link_address.ts"
import {fragmentOf} from "../../browser/share_link.ts"
import type {PageState} from "../../state/page_state.ts"
import colours from "../../styles/haskell_colours.css?inline"
import sheet from "../../styles/shared_page.css?inline"
import tokens from "../../styles/tokens.css?inline"
import {words} from "../../words/index.ts"
import {colouredText} from "./coloured_text.ts"
import {sharedPage} from "./document.ts"
import {filmOf} from "./film.ts"

/// `blocks` is their drawing (`block_drawing.ts`), `projectText` the program as a file.
export async function makePage(
  {name, document: {program}, room}: PageState,
  blocks: string | null,
  projectText: string,
  {page, reach}: LinkAddress,
): Promise<string> {
  const {documentElement} = document
  const version = import.meta.env["VITE_ROSY_VERSION"] ?? ""
  return sharedPage({
    language: documentElement.lang,
    direction: documentElement.dir === "rtl" ? "rtl" : "ltr",
    version,
    name: name || words.unnamed,
    blocks,
    haskell: colouredText(program),
    film: filmOf(room),
    isFilmOlder: room.source !== null && room.source !== program.text,
    link: page + (await fragmentOf(projectText)),
    reach,
    styles: followingSystem(tokens) + colours + sheet,
    player: {script, hash},
    words: {
      blocks: words.regions.blocks,
      haskell: words.regions.haskell,
      room: words.room,
      pause: words.pause,
      time: words.lookBack,
      open: words.share.openInRosy,
      ...words.sharedPage,
      made: words.sharedPage.made(version),
    },
  })
}

/// The page's colours, with the dark ones where the reader's system is dark: a shared page has no choice of its own.
function followingSystem(sheet: string): string {
  const at = sheet.indexOf(":root[data-theme")
  const dark = sheet.slice(at).replace(/^:root\[data-theme="?dark"?\]/, ":root")
  return `${sheet.slice(0, at)}@media screen and (prefers-color-scheme:dark){${dark}}`
}
