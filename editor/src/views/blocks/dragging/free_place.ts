/// The free place nearest to where a block was dropped, so that no definition covers another. Pure.

export interface Box {
  readonly left: number
  readonly right: number
  readonly top: number
  readonly bottom: number
}

/// Workspace units between a block that gives way and the one that it would cover.
const gap = 20

/// How far right and down `box` has to move so that it covers none of `others`; the shortest way, down before up.
export function nearestFreePlace(
  box: Box,
  others: readonly Box[],
): {readonly right: number; readonly down: number} {
  const isFree = (right: number, down: number) =>
    !others.some(other => covers(moved(box, right, down), other))
  if (isFree(0, 0)) return {right: 0, down: 0}
  const rights = [0, ...others.flatMap(o => [o.right + gap - box.left, o.left - gap - box.right])]
  const downs = [0, ...others.flatMap(o => [o.bottom + gap - box.top, o.top - gap - box.bottom])]
  let best = {right: 0, down: Math.max(...downs)}
  let least = Number.POSITIVE_INFINITY
  for (const down of downs)
    for (const right of rights) {
      // Upwards is a little further: a program is read from top to bottom.
      const far = Math.abs(right) + (down < 0 ? 1.5 * -down : down)
      if (far >= least || !isFree(right, down)) continue
      best = {right, down}
      least = far
    }
  return best
}

/// Workspace units that are left free beside a block that was brought into view.
const margin = 12

/// How far right `box` has to move to be seen whole, or from its left edge on where it is wider than the view. Pure.
export function shiftIntoView(box: Pick<Box, "left" | "right">, view: Pick<Box, "left" | "right">): number {
  if (box.left >= view.left && box.right <= view.right) return 0
  const width = box.right - box.left
  return Math.max(view.left + margin, Math.min(box.left, view.right - margin - width)) - box.left
}

function moved({left, right, top, bottom}: Box, x: number, y: number): Box {
  return {left: left + x, right: right + x, top: top + y, bottom: bottom + y}
}

function covers(one: Box, other: Box): boolean {
  return one.left < other.right && other.left < one.right && one.top < other.bottom && other.top < one.bottom
}
