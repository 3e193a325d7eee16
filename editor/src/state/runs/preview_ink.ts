/// Ink that the pen would draw in a preview: computed once for each, from its path and the changes of its pen. Pure.

import type {Preview} from "../messages/preview.ts"
import {extendInk, type Ink, type InkFrame} from "./ink.ts"

type DrawnPath = Pick<Preview, "path" | "pen">

/// A preview is drawn in each frame.
const cache = new WeakMap<DrawnPath, Ink>()

export function previewInk(preview: DrawnPath): Ink {
  const known = cache.get(preview)
  if (known !== undefined) return known
  const ink = inkOf(preview)
  cache.set(preview, ink)
  return ink
}

function inkOf({path, pen}: DrawnPath): Ink {
  let ink: Ink = []
  let before: InkFrame | null = null
  let changes = 0
  for (const at of path) {
    while ((pen[changes]?.[0] ?? Number.POSITIVE_INFINITY) <= at.time) changes += 1
    const [, down, colour, width] = pen[changes - 1] ?? [0, 0, 0, 0]
    const frame: InkFrame = {...at, channels: {Pen: [down], PenColor: [colour], PenWidth: [width]}}
    ink = extendInk(ink, before, frame)
    before = frame
  }
  return ink
}
