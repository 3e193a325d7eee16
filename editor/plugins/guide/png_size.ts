/// Size of a PNG picture in pixels, from its header (PNG specification, section 11.2.1).

export function pngSize(png: Uint8Array): {readonly width: number; readonly height: number} {
  const view = new DataView(png.buffer, png.byteOffset, png.byteLength)
  if (png.byteLength < 24 || view.getUint32(0) !== 0x89504e47) throw new Error("expected a PNG file")
  return {width: view.getUint32(16), height: view.getUint32(20)}
}
