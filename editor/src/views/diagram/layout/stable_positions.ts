/// Stable positions: joins a new layout of a scope with the one before, so that an edit moves only what it changes. Pure.
///
/// A node that was there before with the same size keeps its place. A node that is new, or has another size and would cover others, goes to the
/// free place nearest to where the new layout has it, relative to its neighbours.

import type {DiagramEdge} from "../network/network.ts"
import {type Box, overlaps, type Point, routeBetween, sameBox} from "./geometry.ts"

/// Positions in a scope, relative to its upper left corner.
export interface ScopeLayout {
  readonly boxes: ReadonlyMap<string, Box>
  readonly routes: ReadonlyMap<string, readonly Point[]>
}

/// Free space around a node that is placed between others, and the step of the search for it.
const margin = 16
const searchStep = 22

/// Width up to which a node, such as the dot of an `Either`, has room between two others that are neighbours in a layout.
const slender = 14

export function joinLayouts(
  before: ScopeLayout | undefined,
  fresh: ScopeLayout,
  edges: readonly DiagramEdge[],
): ScopeLayout {
  if (before === undefined || before.boxes.size === 0) return fresh
  const old = (id: string) => before.boxes.get(id) ?? renamed(id, before, fresh, edges)
  const boxes = new Map<string, Box>()
  const moving: string[] = []
  for (const [id, {w, h}] of fresh.boxes) {
    const was = old(id)
    if (was !== undefined && was.w === w && was.h === h) boxes.set(id, was)
    else moving.push(id)
  }
  // Those that have a place to keep come before those that are new.
  for (const id of moving.filter(one => old(one) !== undefined)) place(id, old(id))
  for (const id of moving.filter(one => old(one) === undefined)) place(id, undefined)

  function place(id: string, was: Point | undefined): void {
    const size = fresh.boxes.get(id)
    if (size === undefined) return
    const wanted = was === undefined ? beside(id, size) : {...size, x: was.x, y: was.y}
    boxes.set(id, freePlace(wanted, [...boxes.values()]))
  }
  /// Where the new layout has it, moved as its neighbours were; a slender one directly before what it leads to.
  function beside(id: string, box: Box): Box {
    const next = boxes.get(edges.find(e => e.from === id)?.to ?? "")
    if (box.w <= slender && next !== undefined) return directlyBefore(next, box)
    const neighbours = edges.flatMap(e => (e.from === id ? [e.to] : e.to === id ? [e.from] : []))
    const offsets = [...neighbours, ...fresh.boxes.keys()].flatMap(other => {
      const now = boxes.get(other)
      const then = fresh.boxes.get(other)
      return now === undefined || then === undefined ? [] : [{x: now.x - then.x, y: now.y - then.y}]
    })
    const offset = offsets[0] ?? {x: 0, y: 0}
    return {...box, x: Math.max(0, box.x + offset.x), y: Math.max(0, box.y + offset.y)}
  }
  return {boxes, routes: routesOf(before, fresh, boxes, edges)}
}

/// Puts nodes where the learner moved them; what would lie below them makes way. The dot or bar before a moved function goes with it.
export function withMoved(
  scope: ScopeLayout,
  moved: ReadonlyMap<string, Point>,
  edges: readonly DiagramEdge[],
): ScopeLayout {
  const boxes = new Map<string, Box>()
  const put = (id: string, wanted: Box) => {
    const taken = [...boxes.values()]
    boxes.set(id, taken.some(other => overlaps(wanted, other)) ? freePlace(wanted, taken) : wanted)
  }
  // What was moved last is last.
  for (const [id, {x, y}] of moved) {
    const box = scope.boxes.get(id)
    if (box !== undefined) put(id, {...box, x, y})
  }
  if (boxes.size === 0) return scope
  for (const [id, box] of scope.boxes) {
    if (boxes.has(id)) continue
    const next = edges.find(e => e.from === id)?.to ?? ""
    const target = box.w <= slender && moved.has(next) ? boxes.get(next) : undefined
    put(id, target === undefined ? box : directlyBefore(target, box))
  }
  const ordered = new Map([...scope.boxes.keys()].map(id => [id, boxes.get(id) as Box]))
  return {boxes: ordered, routes: routesOf(scope, scope, ordered, edges)}
}

/// The place directly before a node that a slender one leads to.
const directlyBefore = (next: Box, box: Box): Box => ({
  ...box,
  x: Math.max(0, next.x - margin - box.w),
  y: Math.max(0, next.y + (next.h - box.h) / 2),
})

/// The place of the node that had the same neighbours and is gone: the node under its former name.
function renamed(
  id: string,
  before: ScopeLayout,
  fresh: ScopeLayout,
  edges: readonly DiagramEdge[],
): Box | undefined {
  const gone = [...before.boxes.keys()].filter(other => !fresh.boxes.has(other))
  const signature = (of: string, all: Iterable<string>) =>
    [...all]
      .filter(edge => edge.startsWith(`${of} → `) || edge.includes(` → ${of} `))
      .map(edge => edge.replace(of, ""))
      .sort()
      .join("\n")
  const own = signature(
    id,
    edges.map(e => e.id),
  )
  if (own === "") return undefined
  const same = gone.filter(other => signature(other, before.routes.keys()) === own)
  return same.length === 1 ? before.boxes.get(same[0] ?? "") : undefined
}

/// The place nearest to a wanted one that is free, first above and below, then to the right.
function freePlace(wanted: Box, taken: readonly Box[]): Box {
  const isFree = (box: Box) => box.x >= 0 && box.y >= 0 && !taken.some(other => overlaps(box, other, margin))
  const bottom = Math.max(0, ...taken.map(box => box.y + box.h)) + margin
  const reach = Math.ceil(bottom / searchStep) + 1
  for (let right = 0; right < 3; right++)
    for (let n = 0; n <= reach; n++)
      for (const side of [1, -1]) {
        const box = {...wanted, x: wanted.x + right * searchStep * 2, y: wanted.y + side * n * searchStep}
        if (isFree(box)) return box
      }
  return {...wanted, y: bottom}
}

function routesOf(
  before: ScopeLayout,
  fresh: ScopeLayout,
  boxes: ReadonlyMap<string, Box>,
  edges: readonly DiagramEdge[],
): ReadonlyMap<string, readonly Point[]> {
  const routes = new Map<string, readonly Point[]>()
  for (const {id, from, to} of edges) {
    const [a, b] = [boxes.get(from), boxes.get(to)]
    if (a === undefined || b === undefined) continue
    const stayed = (layout: ScopeLayout) => {
      const [c, d] = [layout.boxes.get(from), layout.boxes.get(to)]
      return c !== undefined && d !== undefined && sameBox(a, c) && sameBox(b, d)
        ? layout.routes.get(id)
        : undefined
    }
    routes.set(id, stayed(before) ?? stayed(fresh) ?? routeBetween(a, b))
  }
  return routes
}
