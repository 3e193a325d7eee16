/// Sizes of the diagram's nodes, boxes, and routes that do not come from the layout engine. Pixels of the drawing; x to the right, y down. Pure.

import type {DiagramNode} from "../network/network.ts"

export interface Point {
  readonly x: number
  readonly y: number
}

export interface Box extends Point {
  readonly w: number
  readonly h: number
}

/// Mean advance of a semibold character of the page's font at 14 px, with some to spare.
const charWidth = 8.1

/// Height of a container's title, and the border around what it holds.
export const titleHeight = 34
export const inset = 18

/// Mean advance of a character of a topic's name, at 11.5 px.
const smallCharWidth = 6.6

/// The name of a topic under the name of its node, or the type of its messages where the name is not known.
export const topicText = ({topic}: Pick<DiagramNode, "topic">): string | null =>
  topic === null ? null : (topic.name ?? topic.type)

/// The size of a node that is not an open container.
export function sizeOf(node: DiagramNode): {w: number; h: number} {
  const text = Math.max(node.label.length * charWidth, (topicText(node)?.length ?? 0) * smallCharWidth)
  switch (node.kind) {
    case "either":
      return {w: 12, h: 12}
    case "all":
      return {w: 8, h: 36}
    case "sample":
      return {w: 44, h: 44}
    case "event":
    case "channel":
      return {w: Math.max(76, text + 44), h: topicText(node) === null ? 44 : 54}
    case "state":
      return {w: Math.max(76, text + 36), h: 40}
    case "store":
      return {w: Math.max(92, text + 30), h: 62}
    case "command":
    case "done":
      return {w: Math.max(76, text + 46), h: topicText(node) === null ? 44 : 54}
    case "task":
    case "chart":
      return {w: Math.max(120, text + 64), h: 48}
    default:
      return {w: Math.max(76, text + 28), h: 44}
  }
}

export function overlaps(a: Box, b: Box, margin = 0): boolean {
  return (
    a.x < b.x + b.w + margin &&
    b.x < a.x + a.w + margin &&
    a.y < b.y + b.h + margin &&
    b.y < a.y + a.h + margin
  )
}

export const sameBox = (a: Box, b: Box): boolean => a.x === b.x && a.y === b.y && a.w === b.w && a.h === b.h

/// Space between a node and an edge that goes around it.
const detour = 16

/// A route from the right side of a node to the left side of another one; back below both where the target is further left.
export function routeBetween(from: Box, to: Box): readonly Point[] {
  const start = {x: from.x + from.w, y: from.y + from.h / 2}
  const end = {x: to.x, y: to.y + to.h / 2}
  if (end.x >= start.x + detour) {
    if (Math.abs(start.y - end.y) < 1) return [start, end]
    const middle = (start.x + end.x) / 2
    return [start, {x: middle, y: start.y}, {x: middle, y: end.y}, end]
  }
  const below = Math.max(from.y + from.h, to.y + to.h) + detour
  const right = start.x + detour
  const left = end.x - detour
  return [start, {x: right, y: start.y}, {x: right, y: below}, {x: left, y: below}, {x: left, y: end.y}, end]
}

/// Where a text stands on a route: the middle of its longest horizontal piece, and the length of that.
export function labelPlace(route: readonly Point[]): Point & {readonly room: number} {
  let best = {x: route[0]?.x ?? 0, y: route[0]?.y ?? 0, room: 0}
  route.slice(1).forEach((end, i) => {
    const start = route[i] ?? end
    const room = Math.abs(end.x - start.x)
    if (Math.abs(end.y - start.y) < 1 && room > best.room) best = {x: (start.x + end.x) / 2, y: start.y, room}
  })
  return best
}

const distance = (a: Point, b: Point) => Math.hypot(a.x - b.x, a.y - b.y)

/// An SVG path along a route, with rounded corners.
export function pathOf(route: readonly Point[], radius = 8): string {
  const [first, ...rest] = route
  if (first === undefined) return ""
  const number = (n: number) => `${Math.round(n * 10) / 10}`
  const at = ({x, y}: Point) => `${number(x)} ${number(y)}`
  let path = `M${at(first)}`
  rest.forEach((corner, i) => {
    const before = route[i]
    const after = rest[i + 1]
    if (before === undefined || after === undefined) {
      path += `L${at(corner)}`
      return
    }
    const r = Math.min(radius, distance(before, corner) / 2, distance(corner, after) / 2)
    path += `L${at(towards(corner, before, r))}Q${at(corner)} ${at(towards(corner, after, r))}`
  })
  return path
}

function towards(from: Point, to: Point, length: number): Point {
  const whole = distance(from, to)
  const t = whole === 0 ? 0 : length / whole
  return {x: from.x + (to.x - from.x) * t, y: from.y + (to.y - from.y) * t}
}
