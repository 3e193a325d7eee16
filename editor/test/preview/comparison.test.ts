/// What the page says about a preview: where the robot would be, how often it would touch something, which goals it would reach.

import {describe, expect, it} from "vitest"
import {table as german} from "../../../languages/de/page/index.ts"
import {table as spanish} from "../../../languages/es/page/index.ts"
import {table as french} from "../../../languages/fr/page/index.ts"
import {table as portuguese} from "../../../languages/pt/page/index.ts"
import {compare} from "../../src/features/preview/comparison.ts"
import {previewSentence} from "../../src/features/preview/sentence.ts"
import type {Frame} from "../../src/state/messages/messages.ts"
import type {Preview} from "../../src/state/messages/preview.ts"
import {record} from "../../src/state/runs/recording.ts"
import {emptyRoom, type RoomState} from "../../src/state/runs/room_state.ts"
import {measures, words} from "../../src/words/index.ts"

const frame = (time: number, x: number): Frame => ({
  run: 1,
  step: time * 50,
  time,
  x,
  y: 1,
  theta: 0,
  channels: {},
  fired: [],
  sensed: [],
  boxes: null,
  ghost: null,
  memory: null,
})

/// A run of 10 s that ends at (3, 1), and a preview of as many seconds.
function room(more: Partial<Preview>, seconds = 10): RoomState {
  const frames = [frame(0, 1), frame(2, 2), frame(seconds, 3)]
  const preview: Preview = {
    id: 1,
    ended: "time",
    time: 10,
    x: 3,
    y: 1,
    theta: 0,
    path: [
      {time: 0, x: 1, y: 1},
      {time: 2, x: 1.5, y: 1},
      {time: 10, x: more.x ?? 3, y: more.y ?? 1},
    ],
    collisions: [],
    pen: [],
    goals: [],
    ...more,
  }
  return {
    ...emptyRoom,
    frame: frames.at(-1) ?? null,
    recording: frames.reduce(record, emptyRoom.recording),
    preview: {ran: "old", asked: {id: 1, text: "new", isLate: false}, answer: {text: "new", preview}},
  }
}

const said = (state: RoomState, {preview} = words, write = measures): string => {
  const comparison = compare({room: state})
  return comparison === null ? "" : previewSentence(comparison, preview, write)
}
const touch = {time: 1, x: 1, y: 1}
const reached = {state: "done", time: 3} as const
const missed = {state: "open", time: null} as const

describe("a preview is told", () => {
  it.each<[string, Partial<Preview>]>([
    ["end in the same place", {x: 3.04}],
    ["end 40 cm further left", {x: 2.6}],
    ["end 1.2 m further right", {x: 4.2}],
    ["end 30 cm further down", {y: 0.7}],
    ["end 50 cm further up and to the left", {x: 2.6, y: 1.3}],
    ["end in the same place and bump once", {collisions: [touch]}],
    ["end in the same place and bump 3 times", {collisions: [touch, touch, touch]}],
    [
      "end 40 cm further left and bump twice and reach 1 of 2 goals",
      {x: 2.6, collisions: [touch, touch], goals: [reached, missed]},
    ],
    ["end in the same place and reach the goal", {goals: [reached]}],
    ["end in the same place and miss the goal", {goals: [missed]}],
    ["stop with a mistake after 10.0 s", {ended: "error"}],
  ])("%s", (what, preview) => expect(said(room(preview))).toBe(`With this change the robot would ${what}.`))

  it("at the end of the shorter one", () => {
    expect(said(room({}, 4))).toBe("With this change the robot would be 1.5 m further left after 4.0 s.")
    expect(said(room({time: 2}, 10))).toBe(
      "With this change the robot would be 50 cm further left after 2.0 s. Only the first 2.0 s are shown: more takes too long to compute.",
    )
    // A program that ends by itself has no more to show.
    expect(said(room({time: 2, ended: "done"}, 10))).toBe(
      "With this change the robot would be 50 cm further left after 2.0 s.",
    )
  })

  it.each([
    ["German", german, "Nur die ersten 2,0 s sind zu sehen: Mehr auszurechnen dauert zu lange."],
    ["Spanish", spanish, "Solo se muestran los primeros 2,0 s: calcular más lleva demasiado tiempo."],
    ["French", french, "Seules les premières 2,0 s sont montrées\u00a0: calculer plus prend trop de temps."],
    ["Portuguese", portuguese, "Só os primeiros 2,0 s são mostrados: calcular mais demora demais."],
  ])("that was cut, in %s", (_, {page, measures: write}, sentence) => {
    expect(said(room({time: 2}, 10), page as typeof words, write)).toContain(` ${sentence}`)
  })

  it("in German", () => {
    const {page, measures: write} = german
    expect(said(room({x: 2.6, collisions: [touch]}), page as typeof words, write)).toBe(
      "Mit dieser Änderung würde der Roboter 40 cm weiter links ankommen und einmal anstoßen.",
    )
    expect(said(room({}, 4), page as typeof words, write)).toBe(
      "Mit dieser Änderung würde der Roboter nach 4,0 s 1,5 m weiter links sein.",
    )
  })

  it("in Portuguese", () => {
    const {page, measures: write} = portuguese
    expect(said(room({x: 2.6, collisions: [touch]}), page as typeof words, write)).toBe(
      "Com esta mudança o robô iria terminar 40 cm mais à esquerda e bater uma vez.",
    )
    expect(said(room({}, 4), page as typeof words, write)).toBe(
      "Com esta mudança o robô iria ficar 1,5 m mais à esquerda depois de 4,0 s.",
    )
  })

  it("in Spanish", () => {
    const {page, measures: write} = spanish
    expect(said(room({x: 2.6, collisions: [touch]}), page as typeof words, write)).toBe(
      "Con este cambio, el robot terminaría 40 cm más a la izquierda y chocaría una vez.",
    )
    expect(said(room({}, 4), page as typeof words, write)).toBe(
      "Con este cambio, el robot estaría 1,5 m más a la izquierda a los 4,0 s.",
    )
  })

  it("in French", () => {
    const {page, measures: write} = french
    expect(said(room({x: 2.6, collisions: [touch]}), page as typeof words, write)).toBe(
      "Avec ce changement, le robot arriverait 40 cm plus à gauche et se cognerait une fois.",
    )
    expect(said(room({}, 4), page as typeof words, write)).toBe(
      "Avec ce changement, le robot serait 1,5 m plus à gauche après 4,0 s.",
    )
  })

  it("not, while there is none", () => {
    expect(said(emptyRoom)).toBe("")
    const state = room({})
    expect(said({...state, preview: {...state.preview, answer: {text: "new", preview: null}}})).toBe("")
  })
})
