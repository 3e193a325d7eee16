/// Geometry on the floor: numbers, points and angles. Pure.

import type {Spot} from "./world.ts"

/// Positions on the grid are multiples of this, m; angles of that, rad.
export const gridStep = 0.1
export const gridTurn = Math.PI / 12

/// A tenth of a millimetre is as fine as a world is written.
export const tidy = (value: number): number => Math.round(value * 1e4) / 1e4 + 0
export const clamp = (value: number, least: number, most: number): number =>
  Math.min(most, Math.max(least, value))
export const onGrid = (value: number, step: number = gridStep): number =>
  tidy(Math.round(value / step) * step)

/// An angle in (-π, π], so that a thing that is turned round and round keeps a readable number.
export function wrapped(angle: number): number {
  const turned = angle - 2 * Math.PI * Math.ceil((angle - Math.PI) / (2 * Math.PI))
  return Math.abs(turned) < 1e-9 ? 0 : turned
}

export const plus = ([x, y]: Spot, dx: number, dy: number): Spot => [x + dx, y + dy]
export const turnedBy = ([x, y]: Spot, angle: number): Spot => [
  x * Math.cos(angle) - y * Math.sin(angle),
  x * Math.sin(angle) + y * Math.cos(angle),
]

/// The nearest place to `at` on the line from `a` to `b`.
export function nearestOn(a: Spot, b: Spot, at: Spot): Spot {
  const [dx, dy] = [b[0] - a[0], b[1] - a[1]]
  const square = dx * dx + dy * dy
  const t = square === 0 ? 0 : clamp(((at[0] - a[0]) * dx + (at[1] - a[1]) * dy) / square, 0, 1)
  return [a[0] + t * dx, a[1] + t * dy]
}
export const distance = (a: Spot, b: Spot): number => Math.hypot(a[0] - b[0], a[1] - b[1])

// Changing a list
