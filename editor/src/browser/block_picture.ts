/// Small picture of a program's blocks: their outlines in their colours, without words, as text that the program store keeps.

import {decode, list, number, object, parseJson, string} from "../wire/decode.ts"

/// An outline of a block in the coordinates of the workspace.
export interface Outline {
  readonly x: number
  readonly y: number
  readonly path: string
  readonly colour: string
}

/// Blocks of a picture: more are smaller than a pixel on a card.
const mostOutlines = 150

const outlines = list(
  object<Outline>(get => ({
    x: get("x", number),
    y: get("y", number),
    path: get("path", string),
    colour: get("colour", string),
  })),
)

/// The outlines of the blocks below `host`, outer blocks before inner blocks; `null` before there are any.
export function takeBlockPicture(host: HTMLElement | null): string | null {
  const svg = host?.querySelector<SVGSVGElement>("svg.blocklySvg")
  const canvas = svg?.querySelector<SVGGElement>(".blocklyBlockCanvas")
  if (canvas === null || canvas === undefined) return null
  const found: Outline[] = []
  const walk = (parent: Element, x: number, y: number) => {
    for (const group of parent.children) {
      if (found.length >= mostOutlines) return
      if (!(group instanceof SVGGElement) || !group.classList.contains("blocklyDraggable")) continue
      const at = translation(group)
      const path = group.querySelector<SVGPathElement>(":scope > .blocklyPath")
      const colour = path?.getAttribute("fill") ?? ""
      const d = path?.getAttribute("d") ?? ""
      if (d !== "") found.push({x: Math.round(x + at.x), y: Math.round(y + at.y), path: d, colour})
      walk(group, x + at.x, y + at.y)
    }
  }
  walk(canvas, 0, 0)
  return found.length === 0 ? null : JSON.stringify(found)
}

/// The outlines of a stored picture; none where it is damaged.
export function readBlockPicture(picture: string | null): readonly Outline[] {
  const read = decode(outlines, picture === null ? [] : parseJson(picture))
  // A picture comes from storage: only a path and a colour may reach the page.
  return read.kind === "ok" ? read.value.filter(o => /^#[0-9a-f]{3,8}$/i.test(o.colour)) : []
}

function translation(group: SVGGElement): {readonly x: number; readonly y: number} {
  const found = /translate\(\s*(-?[\d.e-]+)(?:[\s,]+(-?[\d.e-]+))?/.exec(
    group.getAttribute("transform") ?? "",
  )
  return {x: Number(found?.[1] ?? 0), y: Number(found?.[2] ?? 0)}
}
