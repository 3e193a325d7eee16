/// The shared page: nothing of a program becomes markup or script, the policy allows Rosy's script alone, and the film shows the run that was recorded.

import {describe, expect, it} from "vitest"
import {colouredText} from "../../src/features/shared_page/coloured_text.ts"
import {type SharedPage, sharedPage} from "../../src/features/shared_page/document.ts"
import {durationOf, type Film, filmOf, momentAt} from "../../src/features/shared_page/film.ts"
import {emptyProgram} from "../../src/program/program.ts"
import type {Frame} from "../../src/state/messages/messages.ts"
import {emptyRecording, framesBetween, record} from "../../src/state/runs/recording.ts"
import {emptyRoom, type RoomState} from "../../src/state/runs/room_state.ts"
import type {World} from "../../src/worlds/world.ts"

const world: World = {
  name: "hall",
  title: "Hall",
  size: [4, 3],
  start: {x: 1, y: 1, theta: 0},
  tile: 0.5,
  tiles: [],
  walls: [],
  boxes: [],
  rounds: [],
  lines: [],
  goals: [],
  realism: null,
  dock: null,
  battery: 1,
  scanner: false,
  robot: "kobuki",
}

/// A run of `seconds`, 50 frames a second, in which the robot drives an arc and is pressed once for a single frame.
function driven(seconds: number, pressedAt = 1.5): RoomState {
  const frames = Array.from({length: Math.round(seconds * 50) + 1}, (_, i): Frame => {
    const time = Math.round(i * 20) / 1000
    const pressed = Math.abs(time - pressedAt) < 0.001 ? 1 : 0
    return {
      run: 1,
      time,
      x: 1 + Math.sin(time / 3),
      y: 2 - Math.cos(time / 3),
      // Passes from π to -π on its way.
      theta: Math.atan2(Math.sin(time / 3), Math.cos(time / 3)),
      channels: {Bumper: [0, pressed, 0], Velocity: [0.3, 0.3]},
      fired: [],
      boxes: null,
      memory: null,
      ghost: null,
    } as unknown as Frame
  })
  return {
    ...emptyRoom,
    world,
    run: 1,
    recording: frames.reduce(record, emptyRecording),
    words: [{text: "hello", time: 1}],
  }
}

describe("the film", () => {
  it.each([2, 30, 150, 600])("of %i s shows the robot where it was, and stays small", seconds => {
    const room = driven(seconds)
    const film = filmOf(room) as Film
    expect(durationOf(film)).toEqual({from: 0, to: seconds})
    const gap = Math.max(0.06, seconds / 1000)
    for (let time = 0; time <= seconds; time += seconds / 97) {
      const {x, y, theta} = momentAt(film, time)
      // The sagitta of the arc between two shots, and the rounding of a frame and of a shot.
      const error = (gap / 3) ** 2 / 8 + 0.02 * 0.34 + 0.002
      expect(Math.hypot(x - 1 - Math.sin(time / 3), y - 2 + Math.cos(time / 3))).toBeLessThan(error)
      expect(Math.abs(Math.sin(theta - time / 3))).toBeLessThan(0.02)
    }
    expect(JSON.stringify(film).length).toBeLessThan(70_000)
  })

  it.each([2, 600])("of %i s keeps a press that lasted for one frame", seconds => {
    const film = filmOf(driven(seconds)) as Film
    expect(momentAt(film, 1.5).channels["Bumper"]).toEqual([0, 1, 0])
    expect(momentAt(film, 1.53).channels["Bumper"]).toEqual([0, 0, 0])
  })

  it("shows what the pen has drawn until then", () => {
    const {recording, ...room} = driven(4)
    const frames = [...framesBetween(recording, Number.NEGATIVE_INFINITY, Number.POSITIVE_INFINITY)].map(
      frame => ({
        ...frame,
        channels: {Pen: [frame.time >= 1 && frame.time < 2 ? 1 : 0], PenColor: [1], PenWidth: [0.05]},
      }),
    )
    const film = filmOf({...room, recording: frames.reduce(record, emptyRecording)}) as Film
    expect(momentAt(film, 0.9).ink).toEqual([])
    const [stroke, ...others] = momentAt(film, 3).ink
    expect(others).toEqual([])
    expect(stroke).toMatchObject({color: 1, width: 0.05})
    expect(stroke?.points.at(-1)?.time).toBeCloseTo(1.96, 1)
  })

  it("has the words of the robot for as long as the bubble stands", () => {
    const film = filmOf(driven(10)) as Film
    expect([0.9, 1, 3.9, 4.2].map(time => momentAt(film, time).said)).toEqual([null, "hello", "hello", null])
  })

  it("begins and ends with the recording, and is none before the first run", () => {
    const film = filmOf(driven(2)) as Film
    expect(momentAt(film, -1)).toMatchObject({x: 1, y: 1})
    expect(momentAt(film, 99).x).toBeCloseTo(1 + Math.sin(2 / 3), 2)
    expect(filmOf({...emptyRoom, world})).toBeNull()
    expect(filmOf({...driven(2), run: null})).toBeNull()
  })

  it("does not glide between two places to which hands have moved the robot", () => {
    const film: Film = {
      world,
      shots: [
        [0, 0, 0, 0],
        [40, 3000, 0, 0],
      ],
      words: [],
    }
    expect(momentAt(film, 0.02).x).toBe(0)
  })
})

const hostile = [
  `</script><script>alert(1)</script>`,
  `<!--<script>`,
  `" onload="alert(1)`,
  `' onfocus='alert(1)`,
  `</title><img src=x onerror=alert(1)>`,
  `&lt;b&gt;</style></pre></code>`,
  `javascript:alert(1)`,
  `$& $1 $\``,
]

function pageOf(bad: string): string {
  const text = `-- ${bad}\nmain = simulate [${bad}, "${bad}"]\n`
  const film: Film = {world: {...world, title: bad}, shots: [[0, 1, 1, 0]], words: [[0, bad]]}
  const words = {blocks: bad, haskell: bad, film: bad, noFilm: bad, olderFilm: bad, play: bad, pause: bad}
  const page: SharedPage = {
    language: bad,
    direction: "ltr",
    version: bad,
    name: bad,
    blocks: "<svg></svg>",
    haskell: colouredText({...emptyProgram, text}),
    film,
    isFilmOlder: true,
    link: `http://rosy.example/#program=${bad}`,
    reach: "computer",
    styles: "body{color:red}",
    player: {script: "play()", hash: "aGFzaA=="},
    words: {...words, time: bad, room: bad, open: bad, reach: {network: bad, computer: bad}, made: bad},
  }
  return sharedPage(page)
}

/// Elements with the names of their attributes, apart from the words of the Haskell, of which a longer program has more. The grammar is strict: a tag that is cut short
/// by a quote or a bracket of the program is none, or has other attributes.
const tagsOf = (html: string) =>
  [...html.matchAll(/<(?!\/?span)(\/?[a-z][a-z0-9]*)((?:\s+[a-z-]+(?:="[^"<>]*")?)*)\s*>/gi)]
    .map(([, tag, attributes = ""]) => `${tag}${attributes.replaceAll(/="[^"]*"/g, "")}`)
    .join("\n")

describe("the document", () => {
  it.each(hostile)("has the same elements for every program: %s", bad => {
    expect(tagsOf(pageOf(bad))).toBe(tagsOf(pageOf("x")))
    // Every bracket begins one of these, a word of the Haskell, or the document type.
    const count = (pattern: RegExp) => [...pageOf(bad).matchAll(pattern)].length
    expect(count(/</g)).toBe(tagsOf(pageOf(bad)).split("\n").length + count(/<\/?span/g) + 1)
  })

  it.each(hostile)("gives the data back as they were: %s", bad => {
    const json = /<script type="application\/json" id="film">(.*?)<\/script>/s.exec(pageOf(bad))?.[1] ?? ""
    expect(JSON.parse(json)).toMatchObject({world: {title: bad}, words: [[0, bad]]})
  })

  it("runs the script of Rosy alone, and loads and sends nothing", () => {
    const html = pageOf("x")
    const policy = /Content-Security-Policy" content="([^"]*)"/.exec(html)?.[1]
    expect(policy).toBe(
      "default-src 'none'; script-src 'sha256-aGFzaA=='; style-src 'unsafe-inline'; base-uri 'none'; form-action 'none'",
    )
    // The link is what a person may follow.
    expect([...html.matchAll(/(?:src|href|action)="([^"]*)"/g)].map(([, address]) => address)).toEqual([
      "http://rosy.example/#program=x",
    ])
  })
})

it("colours words as the Haskell pane does, and loses none of the text", () => {
  const text = 'main = simulate (play, 0.5) -- "a" & <b>\n'
  const html = colouredText({...emptyProgram, text})
  expect(html).toContain('<span class="hs-number">0.5</span>')
  expect(html).toContain('<span class="hs-comment">-- &quot;a&quot; &amp; &lt;b&gt;</span>')
  const plain = html.replace(/<[^>]*>/g, "")
  expect(
    plain.replaceAll("&lt;", "<").replaceAll("&gt;", ">").replaceAll("&quot;", '"').replaceAll("&amp;", "&"),
  ).toBe(text)
})
