/// Where the room lies on the canvas: metres with y up, to pixels with y down. Pure.

export interface Camera {
  /// Pixels in a metre.
  readonly scale: number
  /// Where the room's lower left corner is, in pixels.
  readonly left: number
  readonly bottom: number
}

/// Room left free around the world, in pixels.
const margin = 18

/// The largest whole view of a world of `width` × `height` metres on a canvas of `w` × `h` pixels.
export function fit(width: number, height: number, w: number, h: number): Camera {
  const scale = Math.max(1, Math.min((w - 2 * margin) / width, (h - 2 * margin) / height))
  return {scale, left: (w - width * scale) / 2, bottom: (h + height * scale) / 2}
}

export function toScreen(camera: Camera, x: number, y: number): {x: number; y: number} {
  return {x: camera.left + x * camera.scale, y: camera.bottom - y * camera.scale}
}

export function toRoom(camera: Camera, x: number, y: number): {x: number; y: number} {
  return {x: (x - camera.left) / camera.scale, y: (camera.bottom - y) / camera.scale}
}
