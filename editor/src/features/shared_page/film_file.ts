/// Film of a whole recorded run as a file, at the pace of the run: WebM by the browser's recorder, which takes as long as the film, or an animated GIF.

import {startRecording} from "../../browser/canvas_recording.ts"
import type {Size} from "../../views/room/camera.ts"
import type {Palette} from "../../views/room/palette.ts"
import {AnimatedGif} from "./animated_gif.ts"
import {durationOf, type Film, paceOf} from "./film.ts"
import {drawFilm} from "./film_drawing.ts"

export interface FilmMaking {
  readonly palette: Palette
  /// The part that is done, 0 to 1.
  progress(part: number): void
  /// Ends the work; there is no file then.
  readonly signal: AbortSignal
}

/// Sides of the drawn picture, CSS pixels. WebM has twice as many pixels each way.
const widest = 480
const highest = 400
const webmRatio = 2

/// Milliseconds between two pictures.
const webmGap = 33
export const gifGap = 80
/// The last picture is shown longer, ms.
const endDuration = 1000

/// Pictures of a film in which colours are looked for, at most.
const mostSamples = 12

export function sizeOf({world: {size}}: Film, ratio: number): Size {
  const [width, height] = size
  const scale = Math.min(widest / width, highest / height)
  // Video codecs take even sides only.
  const even = (side: number) => 2 * Math.round((side * scale) / 2)
  return {w: even(width), h: even(height), ratio}
}

const wait = (ms: number) => new Promise(resolve => setTimeout(resolve, ms))

function canvasOf({w, h, ratio}: Size): {canvas: HTMLCanvasElement; ctx: CanvasRenderingContext2D} {
  const canvas = document.createElement("canvas")
  canvas.width = w * ratio
  canvas.height = h * ratio
  const ctx = canvas.getContext("2d", {alpha: false, willReadFrequently: ratio === 1})
  if (ctx === null) throw new Error("expected a canvas with a 2d context, found none")
  return {canvas, ctx}
}

/// `null` when it was cancelled, or when the browser can make no such film.
export async function webmOf(film: Film, {palette, progress, signal}: FilmMaking): Promise<Blob | null> {
  const size = sizeOf(film, webmRatio)
  const {canvas, ctx} = canvasOf(size)
  const {from, to} = durationOf(film)
  const pace = paceOf(film)
  drawFilm(ctx, film, from, size, palette)
  let ended: (film: Blob | null) => void = () => {}
  const made = new Promise<Blob | null>(resolve => {
    ended = resolve
  })
  const recording = startRecording(canvas, ended)
  if (recording === null) return null
  const length = ((to - from) / pace) * 1000 + endDuration
  let passed = 0
  let last = performance.now()
  while (passed < length && !signal.aborted) {
    await wait(webmGap)
    const now = performance.now()
    // A page in the background is drawn once a second.
    if (document.hidden) recording.pause()
    else {
      recording.resume()
      passed += now - last
      drawFilm(ctx, film, Math.min(to, from + (passed / 1000) * pace), size, palette)
      progress(Math.min(1, passed / length))
    }
    last = now
  }
  recording.stop()
  const file = await made
  return signal.aborted ? null : file
}

/// `null` when it was cancelled.
export async function gifOf(film: Film, {palette, progress, signal}: FilmMaking): Promise<Blob | null> {
  const size = sizeOf(film, 1)
  const {ctx} = canvasOf(size)
  const pictureAt = (time: number) => {
    drawFilm(ctx, film, time, size, palette)
    return ctx.getImageData(0, 0, size.w, size.h).data
  }
  const gif = new AnimatedGif(size.w, size.h, sampleTimes(film).map(pictureAt))
  const times = gifTimes(film)
  for (const [i, time] of times.entries()) {
    gif.add(pictureAt(time), i === times.length - 1 ? endDuration : gifGap)
    progress((i + 1) / times.length)
    await wait(0)
    if (signal.aborted) return null
  }
  return new Blob([gif.finish()], {type: "image/gif"})
}

/// The times of the run, s, that a GIF shows; the last is the end.
export function gifTimes(film: Film): readonly number[] {
  const {from, to} = durationOf(film)
  const step = (gifGap / 1000) * paceOf(film)
  const count = Math.ceil((to - from) / step)
  return [...Array.from({length: count}, (_, i) => from + i * step), to]
}

/// Times at which all colours of the film are seen: its ends, and where something of the robot lights up or is pressed.
export function sampleTimes(film: Film): readonly number[] {
  const {from, to} = durationOf(film)
  const changes = film.shots.filter(shot => shot[4]).map(([ms]) => ms / 1000)
  const every = Math.max(1, Math.ceil(changes.length / mostSamples))
  return [from, ...changes.filter((_, i) => i % every === 0), to]
}
