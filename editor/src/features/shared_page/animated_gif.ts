/// Animated GIF from pictures of one size. A picture holds only the pixels that differ from the one before; pictures without a difference lengthen it. Pure.

import {applyPalette, type Colour, GIFEncoder, quantize} from "gifenc"

/// Colours of a file; the last of the 256 numbers means "as in the picture before".
const mostColours = 255

export class AnimatedGif {
  private readonly encoder = GIFEncoder()
  private readonly palette: readonly Colour[]
  private readonly width: number
  private readonly height: number
  private isEmpty = true
  private before: Uint8Array | null = null
  /// The picture that is written when its duration is known.
  private pending: {readonly index: Uint8Array; delay: number} | null = null

  /// `samples` are pictures (RGBA) in which all important colours occur.
  constructor(width: number, height: number, samples: readonly Uint8ClampedArray[]) {
    this.width = width
    this.height = height
    const all = new Uint8ClampedArray(samples.reduce((length, sample) => length + sample.length, 0))
    let at = 0
    for (const sample of samples) {
      all.set(sample, at)
      at += sample.length
    }
    const colours = quantize(all, mostColours)
    // A colour table of a GIF has a power of two of entries.
    this.palette = [...colours, ...Array<Colour>(mostColours + 1 - colours.length).fill([0, 0, 0])]
  }

  /// Adds a picture (RGBA) that is shown for so many milliseconds, in hundredths of a second.
  add(pixels: Uint8ClampedArray, delay: number): void {
    const index = applyPalette(pixels, this.palette.slice(0, mostColours))
    const {before, pending} = this
    const changed =
      before === null ? index : index.map((colour, i) => (colour === before[i] ? mostColours : colour))
    if (pending !== null && changed.every(colour => colour === mostColours)) {
      pending.delay += delay
      return
    }
    this.write()
    this.pending = {index: changed, delay}
    this.before = index
  }

  /// The file.
  finish(): Uint8Array<ArrayBuffer> {
    this.write()
    this.encoder.finish()
    return this.encoder.bytes()
  }

  private write(): void {
    if (this.pending === null) return
    const {index, delay} = this.pending
    this.encoder.writeFrame(index, this.width, this.height, {
      ...(this.isEmpty ? {palette: this.palette} : {}),
      delay,
      transparent: true,
      transparentIndex: mostColours,
      dispose: 1,
    })
    this.isEmpty = false
  }
}
