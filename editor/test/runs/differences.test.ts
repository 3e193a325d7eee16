/// A real robot and the simulated one beside it: what differed, and the sentence about it.

import {describe, expect, it} from "vitest"
import {table as german} from "../../../languages/de/page/index.ts"
import {table as french} from "../../../languages/fr/page/index.ts"
import {differences, isSame} from "../../src/features/runs/differences.ts"
import {twinSentence} from "../../src/features/runs/twin_sentence.ts"
import type {Channels} from "../../src/state/runs/channels.ts"
import {emptyRecording, type Recording, record} from "../../src/state/runs/recording.ts"
import {measures, words} from "../../src/words/index.ts"

interface Drive {
  readonly seconds?: number
  readonly speed?: number
  readonly turn?: number
  readonly channels?: (time: number) => Channels
}

const wrapped = (angle: number) => Math.atan2(Math.sin(angle), Math.cos(angle))

/// An arc with 50 frames a second, from the place where both start.
function driven({seconds = 4, speed = 0.2, turn = 0, channels = () => ({})}: Drive): Recording {
  let recording = emptyRecording
  let [x, y] = [1.5, 2]
  for (let step = 0; step <= 50 * seconds; step += 1) {
    const time = step / 50
    const theta = turn * time
    recording = record(recording, {
      run: 1,
      step,
      time,
      x,
      y,
      theta: wrapped(theta),
      channels: channels(time),
      fired: [],
      sensed: [],
      boxes: null,
      ghost: null,
      memory: null,
    })
    x += (speed / 50) * Math.cos(theta)
    y += (speed / 50) * Math.sin(theta)
  }
  return recording
}

const bumped = (at: number) => (time: number) => ({Bumper: time >= at ? [0, 1, 0] : [0, 0, 0]})

describe("differences between a real robot and its twin", () => {
  it("are none for the same drive", () => {
    const found = differences(driven({turn: 1}), driven({turn: 1}))
    expect(found).toEqual({time: 4, turned: null, drove: null, apart: null, felt: []})
    expect(found && isSame(found)).toBe(true)
  })

  it.each([
    [{turn: 0.9}, {turn: 1}, "less", 0.4],
    [{turn: -1.1}, {turn: -1}, "more", 0.4],
    [{turn: 0.1}, {turn: 0}, "left", 0.4],
    [{turn: -0.1}, {turn: 0.1}, "right", 0.8],
    // Several turns of a heading that wraps.
    [{seconds: 20, turn: 1.1}, {seconds: 20, turn: 1}, "more", 2],
  ] as const)("name the turn of %j beside %j: %s", (real, simulated, how, angle) => {
    expect(differences(driven(real), driven(simulated))?.turned).toEqual({
      how,
      angle: expect.closeTo(angle, 5),
    })
  })

  it.each([
    [0.23, "further", 0.12],
    [0.17, "less", 0.12],
    [-0.23, "further", 0.12],
  ] as const)("name the way at %d m/s: %s", (speed, how, way) => {
    expect(differences(driven({speed}), driven({}))?.drove).toEqual({how, way: expect.closeTo(way, 5)})
  })

  it("are measured at the end of the shorter run, or at the moment that is looked at", () => {
    const [real, simulated] = [driven({seconds: 9, speed: 0.1}), driven({})]
    expect(differences(real, simulated)).toMatchObject({time: 4, drove: {way: expect.closeTo(0.4)}})
    expect(differences(real, simulated, 2)).toMatchObject({time: 2, drove: {way: expect.closeTo(0.2)}})
    expect(differences(real, emptyRecording)).toBeNull()
    expect(differences(emptyRecording, simulated)).toBeNull()
  })

  it("do not count what is smaller than an error of placing the robot", () => {
    expect(differences(driven({speed: 0.205}), driven({}))).toMatchObject({drove: null, apart: null})
    expect(differences(driven({turn: 0.01}), driven({}))).toMatchObject({turned: null})
  })

  it("name what only one of them felt, and when", () => {
    const real = driven({channels: bumped(3.2)})
    expect(differences(real, driven({}))?.felt).toEqual([
      {channel: "Bumper", real: expect.closeTo(3.2), simulated: null},
    ])
    expect(differences(real, driven({channels: bumped(3.4)}))?.felt).toEqual([])
    expect(differences(real, driven({channels: bumped(1)}))?.felt).toMatchObject([{simulated: 1}])
    // What came after the end of the shorter run says nothing about it.
    expect(differences(real, driven({seconds: 3}))?.felt).toEqual([])
  })
})

describe("the sentence about a real robot and its twin", () => {
  const found = differences(driven({speed: 0.23, turn: 0.9, channels: bumped(3.2)}), driven({turn: 1}))
  if (found === null) throw new Error("expected both to drive")

  it("names at most three differences", () => {
    expect(twinSentence(found, words.twin, measures)).toBe(
      "After 4.0 s: the real robot turned 23° less, drove 12 cm further, and had its bumper pressed at 3.2 s, the simulated one never.",
    )
  })

  it("says when there are none", () => {
    const none = {...found, turned: null, drove: null, apart: null, felt: []}
    expect(twinSentence(none, words.twin, measures)).toBe(
      "After 4.0 s: the real robot and the simulated one did the same.",
    )
    expect(twinSentence({...none, apart: 1.234}, words.twin, measures)).toBe(
      "After 4.0 s: the real robot was 1.2 m away from the simulated one.",
    )
  })

  it.each([
    [
      german,
      "Nach 4,0 s: Der echte Roboter drehte sich 23° weniger, fuhr 12 cm weiter und stieß nach 3,2 s mit der Stoßstange an, der simulierte nie.",
    ],
    [
      french,
      "Après 4,0 s\u00a0: le vrai robot a tourné de 23° de moins, a roulé 12 cm de plus et a heurté quelque chose\u00a0: à 3,2 s (le simulé\u00a0: jamais).",
    ],
  ])("in another language", (language, sentence) => {
    expect(twinSentence(found, language.page.twin, language.measures)).toBe(sentence)
  })
})
