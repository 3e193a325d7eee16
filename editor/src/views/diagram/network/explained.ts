/// Nodes and edges that an answer marks: the functions on the way to it, what they took and gave, and the edges between. Pure.

import type {CausalPath} from "./causal_path.ts"
import type {DiagramNode, Network} from "./network.ts"

export function explained(
  network: Network,
  path: CausalPath,
): {readonly marked: ReadonlySet<string>; readonly lines: ReadonlySet<string>} {
  const marked = new Set(network.nodes.filter(node => isOn(node, path)).map(node => node.id))
  const kinds = new Map(network.nodes.map(node => [node.id, node.kind]))
  const joins = (id: string) => kinds.get(id) === "either" || kinds.get(id) === "all"
  const into = (id: string) => network.edges.filter(edge => edge.to === id)
  const outOf = (id: string) => network.edges.filter(edge => edge.from === id)
  // A join lies on the way when something marked goes through it.
  const through = (id: string): boolean =>
    into(id).some(e => marked.has(e.from) || (joins(e.from) && through(e.from))) &&
    outOf(id).some(e => marked.has(e.to) || joins(e.to))
  for (const {id} of network.nodes) if (joins(id) && through(id)) marked.add(id)
  const lines = network.edges.filter(
    edge => marked.has(edge.from) && marked.has(edge.to) && hasFunction(edge.from, edge.to),
  )
  function hasFunction(from: string, to: string): boolean {
    return [from, to].some(id => kinds.get(id) === "function" || joins(id))
  }
  return {marked, lines: new Set(lines.map(edge => edge.id))}
}

function isOn({kind, key}: DiagramNode, {functions, taken, stores, given}: CausalPath): boolean {
  switch (kind) {
    case "function":
      return functions.has(key)
    case "event":
    case "state":
      return taken.has(key)
    case "channel":
      // An own event is shown by its constructor, which is mostly the name of its type.
      return taken.has(key) || taken.has(key.split(" ")[0] ?? "")
    case "store":
      return stores.has(key)
    case "command":
      return given.has(key)
    default:
      return false
  }
}
