/// Sharing of the open program: its link, the QR code of the link, and the markup that embeds it; and the opening of linked programs.

import {parseProject, saveProject} from "@rosy/codegen"
import type {LinkAddress} from "../../browser/link_address.ts"
import {fragmentOf, type LinkedProgram, programIn} from "../../browser/share_link.ts"
import type {Shared} from "../../state/page_state.ts"

/// `page` is the address of the page without query and fragment.
export async function share(projectText: string, name: string, {page, reach}: LinkAddress): Promise<Shared> {
  const fragment = await fragmentOf(projectText)
  const {qrCodeOf} = await import("../../ui/qr_code.ts")
  const code = qrCodeOf(page + (await fragmentOf(withoutPlaces(projectText))))
  return {link: page + fragment, code, embed: iframe(`${page}embed${fragment}`, name), reach}
}

/// The project without the blocks of its definitions, which are drawn from the text: about a third of the letters in short examples, and so fewer and larger dots.
function withoutPlaces(projectText: string): string {
  const parsed = parseProject(projectText)
  if (!parsed.ok) return projectText
  const {layout} = parsed.project
  return layout === undefined
    ? projectText
    : saveProject({...parsed.project, layout: {...layout, declarations: []}})
}

/// CSS pixels of an embedded page: wide enough for blocks beside the room.
const embeddedWidth = 960
const embeddedHeight = 600

function iframe(address: string, name: string): string {
  const title = name.replaceAll("&", "&amp;").replaceAll('"', "&quot;").replaceAll("<", "&lt;")
  return `<iframe src="${address}" title="${title}" width="${embeddedWidth}" height="${embeddedHeight}"></iframe>`
}

/// The project that an address contains. Text that is no project was damaged before it was linked.
export async function linkedProject(fragment: string): Promise<LinkedProgram> {
  const linked = await programIn(fragment)
  return linked.kind === "program" && !parseProject(linked.text).ok ? {kind: "damaged"} : linked
}
