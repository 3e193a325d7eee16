/// PNG pictures with a palette: a screenshot of the page has few colours, so one byte per pixel makes it a third of the size.
///
/// In: a PNG as Chromium writes it (8 bits per channel, not interlaced). Out: the same picture with at most 256 colours (PNG specification, sections 9 and 11).

import {deflateSync, inflateSync} from "node:zlib"

const signature = Buffer.from([0x89, 0x50, 0x4e, 0x47, 0x0d, 0x0a, 0x1a, 0x0a])

interface Pixels {
  readonly width: number
  readonly height: number
  /// Red, green and blue of each pixel.
  readonly rgb: Uint8Array
}

export function withPalette(png: Buffer): Buffer {
  const {width, height, rgb} = decode(png)
  const colours = paletteOf(rgb)
  const nearest = new Map<number, number>()
  const rows = Buffer.alloc((width + 1) * height)
  for (let y = 0; y < height; y += 1)
    for (let x = 0; x < width; x += 1) {
      const colour = colourAt(rgb, y * width + x)
      let found = nearest.get(colour)
      if (found === undefined) {
        found = nearestTo(colour, colours)
        nearest.set(colour, found)
      }
      rows[y * (width + 1) + 1 + x] = found
    }
  const header = Buffer.alloc(13)
  header.writeUInt32BE(width, 0)
  header.writeUInt32BE(height, 4)
  // 8 bits per pixel, colour type 3 (palette).
  header.set([8, 3, 0, 0, 0], 8)
  const palette = Buffer.from(colours.flatMap(colour => [colour >> 16, (colour >> 8) & 255, colour & 255]))
  const data = deflateSync(rows, {level: 9})
  return Buffer.concat([
    signature,
    chunk("IHDR", header),
    chunk("PLTE", palette),
    chunk("IDAT", data),
    chunk("IEND", Buffer.alloc(0)),
  ])
}

const colourAt = (rgb: Uint8Array, pixel: number): number =>
  ((rgb[3 * pixel] ?? 0) << 16) | ((rgb[3 * pixel + 1] ?? 0) << 8) | (rgb[3 * pixel + 2] ?? 0)

/// The most frequent colours, no two of which are nearly the same.
function paletteOf(rgb: Uint8Array): readonly number[] {
  const counts = new Map<number, number>()
  for (let pixel = 0; 3 * pixel < rgb.length; pixel += 1) {
    const colour = colourAt(rgb, pixel)
    counts.set(colour, (counts.get(colour) ?? 0) + 1)
  }
  const frequent = [...counts].sort((a, b) => b[1] - a[1]).map(([colour]) => colour)
  const chosen: number[] = []
  for (const colour of frequent) {
    if (chosen.length === 256) break
    if (chosen.every(one => distance(one, colour) > 150)) chosen.push(colour)
  }
  return chosen
}

function nearestTo(colour: number, colours: readonly number[]): number {
  let best = 0
  let least = Number.POSITIVE_INFINITY
  for (const [i, one] of colours.entries()) {
    const far = distance(one, colour)
    if (far < least) {
      best = i
      least = far
    }
  }
  return best
}

/// The square of the distance in RGB.
function distance(a: number, b: number): number {
  const [red, green, blue] = [
    (a >> 16) - (b >> 16),
    ((a >> 8) & 255) - ((b >> 8) & 255),
    (a & 255) - (b & 255),
  ]
  return red * red + green * green + blue * blue
}

function chunk(type: string, data: Buffer): Buffer {
  const body = Buffer.concat([Buffer.from(type, "latin1"), data])
  const length = Buffer.alloc(4)
  length.writeUInt32BE(data.length)
  const sum = Buffer.alloc(4)
  sum.writeUInt32BE(crc32(body))
  return Buffer.concat([length, body, sum])
}

/// PNG specification, annex D.
function crc32(data: Uint8Array): number {
  let sum = 0xffffffff
  for (const byte of data) {
    sum ^= byte
    for (let bit = 0; bit < 8; bit += 1) sum = sum & 1 ? (sum >>> 1) ^ 0xedb88320 : sum >>> 1
  }
  return (sum ^ 0xffffffff) >>> 0
}

function decode(png: Buffer): Pixels {
  const [width, height, depth, kind, interlaced] = [
    png.readUInt32BE(16),
    png.readUInt32BE(20),
    png[24],
    png[25],
    png[28],
  ]
  // Colour type 2: red, green, blue; 6: with transparency.
  if (depth !== 8 || (kind !== 2 && kind !== 6) || interlaced !== 0)
    throw new Error("expected a PNG with 8 bits per channel, not interlaced")
  const channels = kind === 2 ? 3 : 4
  const parts: Buffer[] = []
  for (let at = 8; at < png.length; at += 12 + png.readUInt32BE(at))
    if (png.toString("latin1", at + 4, at + 8) === "IDAT")
      parts.push(png.subarray(at + 8, at + 8 + png.readUInt32BE(at)))
  const rows = unfilter(inflateSync(Buffer.concat(parts)), width * channels, height, channels)
  const rgb = new Uint8Array(3 * width * height)
  for (let pixel = 0; pixel < width * height; pixel += 1)
    for (let i = 0; i < 3; i += 1) rgb[3 * pixel + i] = rows[channels * pixel + i] ?? 0
  return {width, height, rgb}
}

/// Undoes the filters of the rows (PNG specification, section 9).
function unfilter(data: Buffer, bytes: number, height: number, channels: number): Uint8Array {
  const out = new Uint8Array(bytes * height)
  for (let y = 0; y < height; y += 1) {
    const filter = data[y * (bytes + 1)] ?? 0
    for (let x = 0; x < bytes; x += 1) {
      const left = x < channels ? 0 : (out[y * bytes + x - channels] ?? 0)
      const up = y === 0 ? 0 : (out[(y - 1) * bytes + x] ?? 0)
      const corner = x < channels || y === 0 ? 0 : (out[(y - 1) * bytes + x - channels] ?? 0)
      const raw = data[y * (bytes + 1) + 1 + x] ?? 0
      out[y * bytes + x] = raw + predicted(filter, left, up, corner)
    }
  }
  return out
}

function predicted(filter: number, left: number, up: number, corner: number): number {
  switch (filter) {
    case 1:
      return left
    case 2:
      return up
    case 3:
      return (left + up) >> 1
    case 4: {
      const [a, b, c] = [Math.abs(up - corner), Math.abs(left - corner), Math.abs(left + up - 2 * corner)]
      return a <= b && a <= c ? left : b <= c ? up : corner
    }
    default:
      return 0
  }
}
