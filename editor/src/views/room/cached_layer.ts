/// Cached canvas layer, larger than the visible canvas by a margin, so that the view can pan over it before it must be drawn again.

import type {Camera, Size} from "./camera.ts"

export interface Layer {
  /// In metres with y up; draw with this, also to add to what is there.
  readonly ctx: CanvasRenderingContext2D
  /// Whether the layer still covers the view; if not, it is empty now and to be drawn anew.
  covers(camera: Camera, size: Size): boolean
  /// Puts what is kept where the camera is, on a canvas of the same size.
  show(target: CanvasRenderingContext2D, camera: Camera): void
  /// Makes `covers` say no the next time.
  forget(): void
}

/// `margin` is a share of the view on each side; none is needed while the view cannot move.
export function openLayer(margin: () => number): Layer {
  const canvas = document.createElement("canvas")
  const ctx = canvas.getContext("2d")
  if (ctx === null) throw new Error("expected a canvas with a 2d context, found none")
  let at: (Camera & Size & {readonly share: number}) | null = null

  const offset = (camera: Camera) =>
    at === null ? {x: 0, y: 0} : {x: camera.left - at.left, y: camera.bottom - at.bottom}

  return {
    ctx,
    covers(camera, size) {
      const share = margin()
      const {x, y} = offset(camera)
      const same = at !== null && at.w === size.w && at.h === size.h && at.ratio === size.ratio
      if (at !== null && same && at.scale === camera.scale && at.share === share)
        if (Math.abs(x) <= share * size.w + 1e-6 && Math.abs(y) <= share * size.h + 1e-6) return true
      at = {...camera, ...size, share}
      const width = Math.max(1, Math.round(size.w * size.ratio * (1 + 2 * share)))
      const height = Math.max(1, Math.round(size.h * size.ratio * (1 + 2 * share)))
      if (canvas.width !== width) canvas.width = width
      if (canvas.height !== height) canvas.height = height
      ctx.setTransform(1, 0, 0, 1, 0, 0)
      ctx.clearRect(0, 0, width, height)
      const k = size.ratio * camera.scale
      const left = (camera.left + share * size.w) * size.ratio
      const bottom = (camera.bottom + share * size.h) * size.ratio
      ctx.setTransform(k, 0, 0, -k, left, bottom)
      return false
    },
    show(target, camera) {
      if (at === null) return
      const {x, y} = offset(camera)
      target.setTransform(1, 0, 0, 1, 0, 0)
      // Whole pixels: a picture between two pixels is a blurred one.
      const left = Math.round((x - at.share * at.w) * at.ratio)
      const top = Math.round((y - at.share * at.h) * at.ratio)
      target.drawImage(canvas, left, top)
    },
    forget() {
      at = null
    },
  }
}
