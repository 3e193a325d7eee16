/// Animations of the guide: each is drawn from the recording of its run and compared with the file in `docs/pictures`, letter by letter. `UPDATE_GOLDENS=1`
/// writes them anew; `./rosy guide-pictures` makes the recordings first.

import {readFileSync, writeFileSync} from "node:fs"
import {fileURLToPath} from "node:url"
import {expect, test} from "vitest"
import {paletteOf} from "../../src/views/room/palette.ts"
import {animatedRoom} from "./animation/animated_room.ts"
import {readRecording} from "./animation/recording.ts"

const root = fileURLToPath(new URL("../../..", import.meta.url))
const read = (path: string) => readFileSync(`${root}${path}`, "utf8")

const animations = JSON.parse(read("docs/animations.json")) as readonly {
  readonly name: string
  readonly page: string
}[]

/// The light colours: the pictures of the guide have them.
const tokens = /:root \{([^}]*)\}/.exec(read("editor/src/styles/tokens.css"))?.[1] ?? ""
const palette = paletteOf(name => new RegExp(`${name}:\\s*([^;]*);`).exec(tokens)?.[1] ?? "")

test.each(animations)("the animation $name is drawn from its recording, and its end as well", ({name}) => {
  const recording = readRecording(read(`docs/recordings/${name}.json`))
  for (const moves of [true, false]) {
    const drawn = animatedRoom(recording, palette, moves)
    const path = `docs/pictures/${name}${moves ? "" : "-still"}.svg`
    if (process.env["UPDATE_GOLDENS"] === "1") writeFileSync(`${root}${path}`, drawn)
    expect(drawn).toBe(read(path))
  }
})

test.each(animations)("the animation $name is shown on the page whose program it shows", ({name, page}) => {
  expect(read(page)).toContain(`pictures/${name}.svg)`)
})
