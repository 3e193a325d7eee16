/// Block outlines per family, as SVG paths: hexagon for events, rounded for states, tag for commands, pill for numbers, cut corners for choices, square for own types.
/// Memory and Maybe are rounded with a second line, drawn by `renderer.ts`; tasks stand in stacks and have Blockly's notch.
///
/// Pure: height of a side in, SVG path commands out. A side is drawn from its inner edge outwards and back, so the same numbers serve left and right, up and down.

import type {Family} from "@rosy/codegen"

/// One side of a block: x grows outwards, y from the side's first to its last corner.
export interface Side {
  /// Room that the side takes beside the block's contents, in pixels.
  readonly width: (height: number) => number
  /// Commands from (0, 0) to (0, height), in the side's own x and y.
  readonly path: (height: number, draw: Pen) => string
}

/// Relative path commands, mirrored as the side needs.
export interface Pen {
  line(dx: number, dy: number): string
  /// A quarter of a circle that ends at (dx, dy); `bulge` says that it curves outwards.
  arc(dx: number, dy: number, bulge: boolean): string
}

export type Outline = "hexagon" | "pill" | "round" | "square" | "tag" | "cut"

export const outlines: readonly Outline[] = ["hexagon", "pill", "round", "square", "tag", "cut"]

export const outlineOf: Readonly<Record<Family, Outline>> = {
  event: "hexagon",
  state: "round",
  command: "tag",
  memory: "round",
  task: "square",
  number: "pill",
  choice: "cut",
  own: "square",
}

/// Pixels.
const maxPoint = 12
const maxPill = 20
const roundRadius = 11
const squareRadius = 3
const cut = 7

const hexagon: Side = {
  width: height => Math.min(height / 2, maxPoint),
  path: (height, pen) => {
    const out = hexagon.width(height)
    return pen.line(out, height / 2) + pen.line(-out, height / 2)
  },
}

function rounded(most: number): Side {
  const radius = (height: number) => Math.min(height / 2, most)
  return {
    width: radius,
    path: (height, pen) => {
      const r = radius(height)
      return pen.arc(r, r, true) + pen.line(0, height - 2 * r) + pen.arc(-r, r, true)
    },
  }
}

const corners: Side = {
  width: () => cut,
  path: (height, pen) => pen.line(cut, cut) + pen.line(0, height - 2 * cut) + pen.line(-cut, cut),
}

/// The straight edge of a tag: as wide as the other edge is round, so that contents stay centred.
function straight(like: Side): Side {
  return {
    width: like.width,
    path: (height, pen) => {
      const out = like.width(height)
      const r = squareRadius
      return (
        pen.line(out - r, 0) +
        pen.arc(r, r, true) +
        pen.line(0, height - 2 * r) +
        pen.arc(-r, r, true) +
        pen.line(r - out, 0)
      )
    },
  }
}

const pill = rounded(maxPill)

/// Left and right side of each outline; only the tag's differ.
export const sides: Readonly<Record<Outline, {readonly left: Side; readonly right: Side}>> = {
  hexagon: {left: hexagon, right: hexagon},
  pill: {left: pill, right: pill},
  round: {left: rounded(roundRadius), right: rounded(roundRadius)},
  square: {left: rounded(squareRadius), right: rounded(squareRadius)},
  tag: {left: straight(rounded(roundRadius + 4)), right: rounded(roundRadius + 4)},
  cut: {left: corners, right: corners},
}

/// A pen for one side: `right` mirrors x, `up` mirrors y and with it every arc's direction.
export function pen(right: boolean, up: boolean): Pen {
  const x = right ? 1 : -1
  const y = up ? -1 : 1
  return {
    line: (dx, dy) => ` l ${x * dx},${y * dy}`,
    arc: (dx, dy, bulge) => {
      const clockwise = (right !== up) === bulge
      const r = Math.abs(dx)
      return ` a ${r} ${r} 0 0 ${clockwise ? 1 : 0} ${x * dx},${y * dy}`
    },
  }
}

/// Pixels between the tip of an outer outline and what stands first or last in it, which may be a field
/// (`undefined`) or a block of its own outline. Round in round nests tightly, corners keep clear of slopes.
export function padding(outer: Outline, inner: Outline | undefined): number {
  switch (outer) {
    case "hexagon":
      return inner === "hexagon" ? 7 : 14
    case "pill":
      return inner === undefined ? 12 : inner === "pill" ? 4 : inner === "hexagon" ? 12 : 9
    case "round":
    case "tag":
      return inner === undefined ? 10 : inner === "pill" || inner === "round" ? 5 : 7
    case "square":
    case "cut":
      return 9
  }
}
