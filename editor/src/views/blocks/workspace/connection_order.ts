/// Order of a workspace's connections: Blockly sorts thousands of them by height after each drawing, although few drawings move one past another.

import type * as Blockly from "blockly/core"

/// The lists of one workspace sort only when they are out of order.
export function sortOnlyWhenMoved({connectionDBList}: Blockly.WorkspaceSvg): void {
  for (const list of connectionDBList) {
    const {connections, reorderConnections} = (list ?? {}) as unknown as Partial<SortedList>
    // Another version of Blockly may keep them in another way.
    if (connections === undefined || reorderConnections === undefined) continue
    Object.assign(list as object, {
      reorderConnections(this: SortedList) {
        if (!isInOrder(this.connections)) reorderConnections.call(this)
      },
    })
  }
}

interface SortedList {
  readonly connections: readonly {readonly y: number}[]
  reorderConnections(): void
}

function isInOrder(connections: readonly {readonly y: number}[]): boolean {
  let above = Number.NEGATIVE_INFINITY
  for (const {y} of connections) {
    if (y < above) return false
    above = y
  }
  return true
}
