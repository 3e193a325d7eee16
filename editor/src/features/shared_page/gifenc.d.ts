/// The part of gifenc (MIT) that the page uses; the package has no types of its own.

declare module "gifenc" {
  export type Colour = readonly [red: number, green: number, blue: number]

  export interface Encoder {
    writeFrame(
      index: Uint8Array,
      width: number,
      height: number,
      options: {
        /// Of the first frame for the whole file.
        readonly palette?: readonly Colour[]
        /// Milliseconds; written as hundredths of a second.
        readonly delay: number
        readonly transparent?: boolean
        readonly transparentIndex?: number
        /// What becomes of the frame before the next one (GIF89a, section 23); 1: it stays.
        readonly dispose?: number
      },
    ): void
    finish(): void
    bytes(): Uint8Array<ArrayBuffer>
  }

  export function GIFEncoder(): Encoder
  /// At most `most` colours that stand for those of the pixels (RGBA).
  export function quantize(pixels: Uint8ClampedArray, most: number): Colour[]
  /// The number of the nearest colour of each pixel (RGBA).
  export function applyPalette(pixels: Uint8ClampedArray, palette: readonly Colour[]): Uint8Array
}
