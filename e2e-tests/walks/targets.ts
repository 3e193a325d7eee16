/// What a hand can reach on the page at one moment: places that nothing else covers.

import type {Page} from "@playwright/test"

export interface Target {
  readonly x: number
  readonly y: number
  /// The block that it is on, or "".
  readonly block: string
  readonly words: string
}

export type TargetKind =
  | "block"
  | "entry"
  | "menu"
  | "name"
  | "button"
  | "hole"
  | "category"
  | "offered"
  | "line"

/// In the page: parts by selector, and where in each a hand presses.
const parts: Readonly<Record<TargetKind, {readonly selector: string; readonly corner: boolean}>> = {
  block: {selector: ".blocklySvg .blocklyBlockCanvas .blocklyDraggable > .blocklyPath", corner: true},
  entry: {selector: ".blocklySvg .blocklyBlockCanvas .rosyEntry", corner: false},
  menu: {selector: ".blocklySvg .blocklyBlockCanvas .blocklyDropdownField", corner: false},
  name: {selector: ".blocklySvg .blocklyBlockCanvas .rosyBinder", corner: false},
  button: {selector: ".blocklySvg .blocklyBlockCanvas .rosyPress", corner: false},
  hole: {selector: ".blocklySvg .blocklyBlockCanvas .blocklyOutlinePath", corner: true},
  category: {selector: ".blocklyToolboxCategory", corner: false},
  offered: {selector: ".blocklyFlyout .blocklyBlockCanvas > .blocklyDraggable > .blocklyPath", corner: true},
  line: {selector: "[data-testid=haskell] .cm-line", corner: false},
}

export function targets(page: Page, kind: TargetKind): Promise<readonly Target[]> {
  return page.evaluate(
    ({selector, corner}) =>
      [...document.querySelectorAll(selector)].flatMap(part => {
        const box = part.getBoundingClientRect()
        const x = box.left + (corner ? Math.min(9, box.width / 2) : Math.min(box.width / 2, 40))
        const y = box.top + (corner ? Math.min(12, box.height / 2) : box.height / 2)
        if (box.width === 0 || x < 0 || y < 0 || x >= innerWidth || y >= innerHeight) return []
        const there = document.elementFromPoint(x, y)
        const own = part.closest(".blocklyDraggable")
        const hit =
          there !== null &&
          (part === there || part.contains(there) || (corner && there.closest(".blocklyDraggable") === own))
        return hit
          ? [{x, y, block: own?.getAttribute("data-id") ?? "", words: (part.textContent ?? "").trim()}]
          : []
      }),
    parts[kind],
  )
}
