/// Keyboard navigation in the diagram: the node that an arrow key leads to. Pure.

import {type DiagramNode, isJoin, type Network} from "../network/network.ts"
import type {Layout} from "./layout.ts"

/// The node that an arrow key leads to: along the edges to the left and to the right, else the next one above or below. Of several edges
/// one to a marked node comes first, so that the keys follow the way to an answer.
export function neighbour(
  network: Network,
  places: Layout["boxes"],
  node: DiagramNode,
  key: string,
  marked: ReadonlySet<string> = new Set(),
): string | null {
  const isStop = (id: string) => !isJoin(network, id)
  const along = (id: string, forwards: boolean): string | null => {
    const next = network.edges.flatMap(({from, to}) =>
      forwards ? (from === id ? [to] : []) : to === id ? [from] : [],
    )
    for (const one of [...next.filter(other => marked.has(other)), ...next]) {
      const found = isStop(one) ? one : along(one, forwards)
      if (found !== null) return found
    }
    return null
  }
  if (key === "ArrowRight") return along(node.id, true)
  if (key === "ArrowLeft") return along(node.id, false)
  if (key !== "ArrowUp" && key !== "ArrowDown") return null
  const here = places.get(node.id)
  if (here === undefined) return null
  const sign = key === "ArrowDown" ? 1 : -1
  let best: {id: string; distance: number} | null = null
  for (const other of network.nodes) {
    const box = places.get(other.id)
    if (box === undefined || other.id === node.id || !isStop(other.id)) continue
    const dy = (box.y - here.y) * sign
    if (dy <= 0) continue
    // What is straight above or below comes before what is nearer and to the side.
    const distance = dy + 2 * Math.abs(box.x + box.w / 2 - here.x - here.w / 2)
    if (best === null || distance < best.distance) best = {id: other.id, distance}
  }
  return best?.id ?? null
}
