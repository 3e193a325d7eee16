/// Values on blocks: what a function took last and gave, as a small label on the lower edge of its definition.
///
/// A label is a child of its block's group, so it moves and scales with the block; it takes no space in the layout of the blocks.

import type {BlockId} from "@rosy/codegen"
import * as Blockly from "blockly/core"

export interface BlockValue {
  readonly block: BlockId
  readonly text: string
  /// The text without folds.
  readonly whole: string
  readonly isOld: boolean
  /// Characters that the label has room for, so that it does not become narrower with each value.
  readonly room: number
}

/// Width of a character of the label's font, and sizes of the label, in units of the workspace.
const character = 6.6
const height = 20
const padding = 7
/// From the side of the block to the label, and how far the label overlaps the block: it stays clear of the next definition.
const indent = 14
const overlap = 8

export class ValueLabels {
  private readonly workspace: Blockly.WorkspaceSvg
  private readonly clicked: (block: BlockId) => void
  private readonly groups = new Map<BlockId, SVGGElement>()
  private values: readonly BlockValue[] = []

  /// A click or a tap on a label is told with its block.
  constructor(workspace: Blockly.WorkspaceSvg, clicked: (block: BlockId) => void) {
    this.workspace = workspace
    this.clicked = clicked
  }

  show(values: readonly BlockValue[]): void {
    this.values = values
    const shown = new Set(values.map(value => value.block))
    for (const [id, group] of this.groups)
      if (!shown.has(id)) {
        group.remove()
        this.groups.delete(id)
      }
    for (const value of values) this.draw(value)
  }

  /// Blocks were replaced or have other sizes.
  refresh(): void {
    this.show(this.values)
  }

  private draw({block: id, text, whole, isOld, room}: BlockValue): void {
    const block = this.workspace.getBlockById(id)
    if (block === null) return
    const group = this.groups.get(id) ?? made(() => this.clicked(id))
    this.groups.set(id, group)
    const root = block.getSvgRoot()
    if (group.parentNode !== root) root.append(group)
    group.classList.toggle("old", isOld)
    const [title, box, label] = group.children
    const width = room * character + 2 * padding
    const x = block.RTL ? -indent - width : indent
    group.setAttribute("transform", `translate(${x}, ${block.height - overlap})`)
    box?.setAttribute("width", `${width}`)
    if (title !== undefined && title.textContent !== whole) title.textContent = whole
    if (label !== undefined && label.textContent !== text) label.textContent = text
  }
}

/// A pointer that moved further than this dragged the block, CSS pixels.
const still = 8

function made(clicked: () => void): SVGGElement {
  const {SVG_NS} = Blockly.utils.dom
  const group = document.createElementNS(SVG_NS, "g") as SVGGElement
  group.setAttribute("class", "rosyValue")
  // The Haskell pane tells the same as text.
  group.setAttribute("aria-hidden", "true")
  const box = document.createElementNS(SVG_NS, "rect")
  box.setAttribute("height", `${height}`)
  box.setAttribute("rx", "5")
  const label = document.createElementNS(SVG_NS, "text")
  label.setAttribute("x", `${padding}`)
  label.setAttribute("y", `${height / 2}`)
  let pressed = {x: 0, y: 0}
  group.addEventListener("pointerdown", ({clientX: x, clientY: y}) => {
    pressed = {x, y}
  })
  group.addEventListener("click", ({clientX: x, clientY: y}) => {
    if (Math.hypot(x - pressed.x, y - pressed.y) <= still) clicked()
  })
  group.append(document.createElementNS(SVG_NS, "title"), box, label)
  return group
}
