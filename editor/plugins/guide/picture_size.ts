/// Size of a picture of the guide in CSS pixels, from its file.

export interface PictureSize {
  readonly width: number
  readonly height: number
}

export function pictureSize(path: string, file: Uint8Array): PictureSize {
  return path.endsWith(".svg") ? svgSize(new TextDecoder().decode(file)) : pngSize(file)
}

/// From the header (PNG specification, section 11.2.1). Pictures are taken with two pixels per CSS pixel.
function pngSize(png: Uint8Array): PictureSize {
  const view = new DataView(png.buffer, png.byteOffset, png.byteLength)
  if (png.byteLength < 24 || view.getUint32(0) !== 0x89504e47) throw new Error("expected a PNG file")
  return {width: Math.round(view.getUint32(16) / 2), height: Math.round(view.getUint32(20) / 2)}
}

/// From the root element, which has both in pixels.
function svgSize(svg: string): PictureSize {
  const [, width, height] = /^<svg [^>]*\bwidth="(\d+)" height="(\d+)"/.exec(svg) ?? []
  if (width === undefined || height === undefined) throw new Error("expected an SVG file with its size")
  return {width: Number(width), height: Number(height)}
}
