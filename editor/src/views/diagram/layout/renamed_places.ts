/// Places of moved nodes after a function was renamed: they belong to the node that took its place between the same neighbours. Pure.

import type {NodePlaces} from "@rosy/codegen"
import type {DiagramNode, Network} from "../network/network.ts"

/// The same value where no moved node is gone.
export function placesAfter(before: Network, now: Network, moved: NodePlaces): NodePlaces {
  const [old, fresh] = [before, now].map(({nodes}) => new Map(nodes.map(node => [node.id, node])))
  const gone = Object.keys(moved).flatMap(id => (fresh?.has(id) ? [] : (old?.get(id) ?? [])))
  if (gone.length === 0) return moved
  const added = now.nodes.filter(({id}) => !old?.has(id))
  const places = {...moved}
  for (const node of gone) {
    const own = neighbourhood(before, node)
    const same = added.filter(
      one => one.kind === node.kind && one.parent === node.parent && neighbourhood(now, one) === own,
    )
    const [heir, ...others] = same
    const place = moved[node.id]
    if (heir === undefined || others.length > 0 || place === undefined) continue
    delete places[node.id]
    places[heir.id] = place
  }
  return places
}

/// The edges of a node, and of the joins before it, without its name.
function neighbourhood({edges}: Network, {id}: DiagramNode): string {
  const own = (end: string) => (end === id || end.startsWith(`${id}/`) ? `•${end.slice(id.length)}` : end)
  return edges
    .map(({from, to, role}) => `${own(from)} ${role} ${own(to)}`)
    .filter(edge => edge.includes("•"))
    .sort()
    .join("\n")
}
