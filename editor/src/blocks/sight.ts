/// What the learner can see of the workspace, and blocks that are out of sight.

import type * as Blockly from "blockly/core"
import {Events} from "blockly/core"

export function inSight(workspace: Blockly.WorkspaceSvg, block: Blockly.BlockSvg): boolean {
  const view = workspace.getMetricsManager().getViewMetrics(true)
  const box = block.getBoundingRectangle()
  return (
    box.left >= view.left &&
    box.top >= view.top &&
    box.left < view.left + view.width &&
    box.top < view.top + view.height
  )
}

/// Pixels between a stray that was brought home and the blocks it comes to.
const homeGap = 28

/// A stray is a top-level block that is further from the middle one than a learner would scroll.
export function straysOf(workspace: Blockly.WorkspaceSvg): readonly Blockly.BlockSvg[] {
  const tops = workspace.getTopBlocks(true)
  if (tops.length < 2) return []
  const view = workspace.getMetricsManager().getViewMetrics(true)
  const boxes = tops.map(block => block.getBoundingRectangle())
  const median = (values: number[]) => values.sort((a, b) => a - b)[Math.floor(values.length / 2)]!
  const middle = {x: median(boxes.map(box => box.left)), y: median(boxes.map(box => box.top))}
  return tops.filter((_, at) => {
    const box = boxes[at]!
    return (
      Math.abs(box.left - middle.x) > view.width * 1.5 || Math.abs(box.top - middle.y) > view.height * 2.5
    )
  })
}

export function bringHome(workspace: Blockly.WorkspaceSvg): void {
  const strays = straysOf(workspace)
  if (strays.length === 0) return
  const home = workspace.getTopBlocks(true).filter(block => !strays.includes(block))
  const boxes = home.map(block => block.getBoundingRectangle())
  let y = Math.max(...boxes.map(box => box.bottom)) + homeGap
  const x = Math.min(...boxes.map(box => box.left))
  Events.setGroup(true)
  for (const block of strays) {
    const box = block.getBoundingRectangle()
    block.moveBy(x - box.left, y - box.top, ["cleanup"])
    y += box.getHeight() + homeGap
  }
  Events.setGroup(false)
}
