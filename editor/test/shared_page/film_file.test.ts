/// Film files: an animated GIF shows each picture for as long as the run took, and colours of short events are kept.

import {expect, it} from "vitest"
import {AnimatedGif} from "../../src/features/shared_page/animated_gif.ts"
import {type Film, longestFilm, paceOf} from "../../src/features/shared_page/film.ts"
import {gifGap, gifTimes, sampleTimes, sizeOf} from "../../src/features/shared_page/film_file.ts"

const side = 8

function picture(red: number, at: number): Uint8ClampedArray {
  const pixels = new Uint8ClampedArray(4 * side * side).fill(255)
  pixels.set([red, 0, 0, 255], 4 * at)
  return pixels
}

/// The pictures of a GIF (GIF89a, sections 17 to 27): how long each is shown, hundredths of a second.
function delaysOf(gif: Uint8Array): readonly number[] {
  const table = (flags = 0) => ((flags & 0x80) === 0 ? 0 : 3 * 2 ** ((flags & 7) + 1))
  let at = 13 + table(gif[10])
  const delays: number[] = []
  while (gif[at] !== 0x3b) {
    const isImage = gif[at] === 0x2c
    if (gif[at] === 0x21 && gif[at + 1] === 0xf9) delays.push((gif[at + 4] ?? 0) + 256 * (gif[at + 5] ?? 0))
    at += isImage ? 10 + table(gif[at + 9]) + 1 : 2
    while (gif[at] !== 0) at += 1 + (gif[at] ?? 0)
    at += 1
  }
  return delays
}

function filmOf(seconds: number): Film {
  const shots = Array.from({length: 26}, (_, i) => {
    const ms = Math.round((seconds * 1000 * i) / 25)
    return i === 13 ? ([ms, 0, 0, 0, {Bumper: [1, 0, 0]}] as const) : ([ms, 0, 0, 0] as const)
  })
  return {world: {size: [4, 3]}, shots, words: []} as unknown as Film
}

it("pictures that are alike become one that is shown longer, and the file says how long each is shown", () => {
  const [one, other] = [picture(255, 3), picture(128, 4)]
  const gif = new AnimatedGif(side, side, [one, other])
  gif.add(one, 80)
  gif.add(one, 80)
  gif.add(other, 80)
  gif.add(one, 1000)
  const file = gif.finish()
  expect(new TextDecoder().decode(file.subarray(0, 6))).toBe("GIF89a")
  expect(delaysOf(file)).toEqual([16, 8, 100])
})

it("a run of a minute is shown at its pace, a longer one as fast as a minute needs", () => {
  for (const seconds of [0.1, 5, 60]) expect(paceOf(filmOf(seconds))).toBe(1)
  expect(paceOf(filmOf(180))).toBe(3)
  for (const seconds of [5, 60, 180, 1200]) {
    const times = gifTimes(filmOf(seconds))
    const shown = (times.length - 1) * (gifGap / 1000)
    expect(shown).toBeCloseTo(Math.min(seconds, longestFilm), 0)
    expect(times[0]).toBe(0)
    expect(times.at(-1)).toBe(seconds)
  }
})

it("the colours of a press are looked for where it is seen", () => {
  expect(sampleTimes(filmOf(10))).toEqual([0, 5.2, 10])
})

it("the picture has the shape of the room, and even sides", () => {
  expect(sizeOf(filmOf(1), 2)).toEqual({w: 480, h: 360, ratio: 2})
  const narrow = {...filmOf(1), world: {size: [0.7, 3]}} as unknown as Film
  expect(sizeOf(narrow, 1)).toEqual({w: 94, h: 400, ratio: 1})
})
