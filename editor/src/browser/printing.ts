/// Printing: while the browser prints, a sheet with the program's name, its blocks as an SVG drawing, and its Haskell stands in the place of the page.

export interface Printed {
  readonly name: string
  readonly haskell: string
  /// The host of the block workspace; `null` before it is mounted.
  readonly blocks: HTMLElement | null
}

/// Pixels around the blocks.
const margin = 8

export function watchPrint(printed: () => Printed, before: () => void, after: () => void): void {
  let sheet: HTMLElement | null = null
  window.addEventListener("beforeprint", () => {
    before()
    sheet = sheetOf(printed())
    document.body.append(sheet)
  })
  window.addEventListener("afterprint", () => {
    sheet?.remove()
    sheet = null
    after()
  })
}

function sheetOf({name, haskell, blocks}: Printed): HTMLElement {
  const sheet = document.createElement("article")
  sheet.className = "print-sheet"
  const title = document.createElement("h1")
  title.textContent = name
  const text = document.createElement("pre")
  text.textContent = haskell
  const drawing = blocks === null ? null : drawingOf(blocks)
  sheet.append(title, ...(drawing === null ? [] : [drawing]), text)
  return sheet
}

/// The blocks as a drawing below elements with the classes of the workspace: its style sheets apply there.
function drawingOf(host: HTMLElement): HTMLElement | null {
  const drawing = blockDrawing(host)
  if (drawing === null) return null
  const workspace = document.createElement("div")
  workspace.className = host.querySelector(".blocklySvg")?.parentElement?.className ?? ""
  workspace.append(drawing)
  const frame = document.createElement("div")
  frame.className = "rosyBlocks print-blocks"
  frame.append(workspace)
  return frame
}

/// All blocks in their own drawing, without the scroll position and the scale of the workspace; `null` without blocks. `adopt` may change
/// the copy of the blocks while all of their originals are drawn.
export function blockDrawing(
  host: HTMLElement,
  adopt: (original: SVGGElement, copy: SVGGElement) => void = () => {},
): SVGSVGElement | null {
  const svg = host.querySelector<SVGSVGElement>("svg.blocklySvg")
  const canvas = svg?.querySelector<SVGGElement>(".blocklyBlockCanvas")
  if (svg === null || canvas === undefined || canvas === null) return null
  // Blocks have no size in a region that is not shown, and culled ones while they are not drawn.
  const region = host.closest<HTMLElement>("[hidden]")
  region?.removeAttribute("hidden")
  const culled = [...canvas.querySelectorAll(".rosyAway")]
  for (const block of culled) block.classList.remove("rosyAway")
  const {x, y, width, height} = canvas.getBBox()
  const copy = canvas.cloneNode(true) as SVGGElement
  if (width > 0) adopt(canvas, copy)
  for (const block of culled) block.classList.add("rosyAway")
  region?.setAttribute("hidden", "")
  if (width === 0) return null
  copy.removeAttribute("transform")
  copy.style.removeProperty("transform")
  const drawing = svg.cloneNode(false) as SVGSVGElement
  drawing.replaceChildren(
    ...[...svg.querySelectorAll(":scope > defs")].map(defs => defs.cloneNode(true)),
    copy,
  )
  drawing.removeAttribute("style")
  drawing.removeAttribute("tabindex")
  drawing.setAttribute("viewBox", [x - margin, y - margin, width + 2 * margin, height + 2 * margin].join(" "))
  drawing.setAttribute("width", `${width + 2 * margin}`)
  drawing.removeAttribute("height")
  return drawing
}
