/// Outcomes of previews: what they tell of a path, the sentences about them, and which fixes are offered in which order.

import {describe, expect, it} from "vitest"
import {table as german} from "../../../languages/de/page/index.ts"
import {table as spanish} from "../../../languages/es/page/index.ts"
import {table as french} from "../../../languages/fr/page/index.ts"
import {table as portuguese} from "../../../languages/pt/page/index.ts"
import {decideOrder, type KnownOutcome, orderedFixes} from "../../src/features/preview/fix_order.ts"
import {isBetter, type Outcome, outcomeOf} from "../../src/features/preview/outcome.ts"
import {outcomeSentence} from "../../src/features/preview/outcome_sentence.ts"
import type {PathPoint, Preview} from "../../src/state/messages/preview.ts"
import {measures, words} from "../../src/words/index.ts"

type Points = readonly (readonly [time: number, x: number, y: number])[]

const points = (all: Points): readonly PathPoint[] => all.map(([time, x, y]) => ({time, x, y}))

/// A preview of 10 s that ends at the last point of its path.
function preview(path: Points, bumps: Points = [], more: Partial<Preview> = {}): Preview {
  const [, x = 0, y = 0] = path.at(-1) ?? []
  return {id: 1, ended: "time", time: 10, x, y, theta: 0, path: points(path), collisions: points(bumps), goals: [], pen: [], ...more}
} // biome-ignore format: a table

const done = {state: "done", time: 3} as const
const open = {state: "open", time: null} as const
const bumpsAt = (times: readonly number[], x = 2): Points => times.map(time => [time, x, 0])

const stands: Points = [[0, 1, 0]]
const drives: Points = [[0, 1, 0], [10, 4, 0]] // biome-ignore format: a table
const toWall: Points = [[0, 1, 0], [4, 2, 0]] // biome-ignore format: a table

describe("the outcome of a path, and its sentence", () => {
  const cases: readonly (readonly [string, Preview, Partial<Outcome>, string])[] = [
    ["standing", preview(stands), {stands: true, distance: 0, bumps: 0}, "stands still"],
    ["trembling of the numbers", preview([[0, 1, 0], [10, 1.01, 0]]), {stands: true}, "stands still"],
    ["turning", preview(stands, [], {theta: 1.5}), {stands: false, distance: 0}, "turns on the spot"],
    ["a whole turn and a bit", preview(stands, [], {theta: 2 * Math.PI + 0.1}), {stands: false}, "turns on the spot"],
    ["driving", preview(drives), {distance: 3, bumps: 0, stands: false}, "drives 3 m without a bump"],
    ["a way around a corner", preview([[0, 0, 0], [1, 3, 0], [2, 3, 4]]), {distance: 7}, "drives 7 m without a bump"],
    ["the wall", preview(toWall, bumpsAt([4])), {bumps: 1, onward: null, sticks: true, trembles: false}, "bumps once, stays there"],
    ["a bump in the last moment", preview(toWall, bumpsAt([9.9])), {sticks: false}, "bumps once"],
    ["there and back", preview([...toWall, [5, 1, 0], [9.8, 2, 0]], bumpsAt([4])), {sticks: false}, "bumps once"],
    ["back", preview([...toWall, [8, 1, 0]], bumpsAt([4])), {bumps: 1, onward: "left"}, "bumps once, drives on to the left"],
    ["on", preview([...toWall, [8, 2.1, 1]], bumpsAt([4])), {onward: "up"}, "bumps once, drives on upwards"],
    ["two walls", preview([...toWall, [8, 2, -1]], [[2, 0, 0], [4, 2, 0]]), {bumps: 2, onward: "down"}, "bumps twice, drives on downwards"],
    ["trembling", preview(toWall, bumpsAt([4, 4.4, 4.8, 5.2])), {bumps: 4, trembles: true}, "trembles at the wall: 4 bumps"],
    ["patience", preview(toWall, bumpsAt([2, 4, 6, 8])), {bumps: 4, trembles: false}, "bumps 4 times, stays there"],
    ["bumps along a wall", preview(toWall, [[1, 0, 0], [1.5, 0.5, 0], [2, 1, 0], [2.5, 2, 0]]), {trembles: false}, "bumps 4 times, stays there"],
    ["a goal", preview(drives, [], {goals: [done, open]}), {goals: 1}, "drives 3 m without a bump, reaches a goal"],
    ["a mistake", preview(drives, [], {ended: "error", time: 3}), {fails: 3}, "drives 3 m without a bump, stops with a mistake after 3.0 s"],
    ["its end", preview(drives, [], {ended: "done", time: 3}), {fails: null}, "drives 3 m without a bump"],
  ] // biome-ignore format: a table
  it.each(cases)("%s", (_, of, facts, sentence) => {
    const outcome = outcomeOf(of, 0)
    expect(outcome).toMatchObject(facts)
    expect(outcomeSentence(outcome, words.preview, measures)).toBe(sentence)
  })
  it("measures a turn from the start", () => {
    expect(outcomeOf(preview(stands, [], {theta: 1.5}), 1.5).stands).toBe(true)
  })
  it.each([
    [german, "stößt einmal an, fährt nach links weiter"],
    [french, "se cogne une fois, repart vers la gauche"],
    [spanish, "choca una vez, sigue hacia la izquierda"],
    [portuguese, "bate uma vez, segue para a esquerda"],
  ])("in other languages", (language, sentence) => {
    const outcome = outcomeOf(preview([...toWall, [8, 1, 0]], bumpsAt([4])), 0)
    expect(outcomeSentence(outcome, language.page.preview, measures)).toBe(sentence)
  })
})

const still = outcomeOf(preview(stands), 0)
const free = outcomeOf(preview(drives), 0)
const once = outcomeOf(preview([...toWall, [8, 1, 0]], bumpsAt([4])), 0)
const thrice = outcomeOf(preview(toWall, bumpsAt([2, 5, 9.5])), 0)
const sticking = outcomeOf(preview(toWall, bumpsAt([4])), 0)
const trembling = outcomeOf(preview(toWall, bumpsAt([8.4, 8.8, 9.2, 9.6])), 0)
const failing = outcomeOf(preview(drives, [], {ended: "error", time: 3}), 0)
const reaching = outcomeOf(preview(toWall, bumpsAt([2, 5, 9.5]), {goals: [done]}), 0)

describe("a way out is better than the program", () => {
  it.each([
    ["fewer bumps", once, thrice, true],
    ["the same bumps", thrice, thrice, false],
    ["more bumps", thrice, once, false],
    ["it does not stay at the wall", thrice, sticking, true],
    ["it stays at the wall", sticking, thrice, false],
    ["it trembles instead of staying at the wall", trembling, sticking, false],
    ["no trembling", thrice, trembling, true],
    ["the same trembling", trembling, trembling, false],
    ["trembling", trembling, free, false],
    ["nothing moves", still, trembling, false],
    ["nothing moves any more than before", still, still, false],
    ["it moves at last", once, still, true],
    ["no bumps before and after: the run does not tell", free, free, true],
    ["a bump where there was none", once, free, false],
    ["a mistake no more", free, failing, true],
    ["a mistake", failing, free, false],
    ["a goal", reaching, once, true],
  ])("%s", (_, way, program, better) => expect(isBetter(way, program)).toBe(better))
})

describe("the order of fixes", () => {
  const of = (program: KnownOutcome, ...fixes: readonly KnownOutcome[]) => orderedFixes(program, fixes, true)
  it("is by outcome, without those that are no better", () => {
    expect(of(trembling, trembling, thrice, still, once, free)).toEqual([4, 3, 1])
    expect(of(thrice, free, reaching)).toEqual([1, 0])
    expect(of(thrice, thrice)).toEqual([])
  })
  it("leaves all in where only the order is wanted", () => {
    expect(orderedFixes(thrice, [thrice, failing, free], false)).toEqual([2, 0, 1])
  })
  it("has those last of which nothing is known", () => {
    expect(of(thrice, null, once)).toEqual([1, 0])
  })
  it("is the given one without a run of the program", () => {
    expect(of(null, thrice, once)).toEqual([0, 1])
  })
  it("waits for all", () => {
    expect(of(undefined, once)).toBeNull()
    expect(of(thrice, once, undefined)).toBeNull()
  })
})

describe("the order is decided", () => {
  it("once: what comes later moves nothing", () => {
    const first = decideOrder(null, "a", 2, [1, 0], false)
    expect(first).toEqual({key: "a", order: [1, 0]})
    expect(decideOrder(first, "a", 2, [0], false)).toBe(first)
  })
  it("as given when somebody points at it before the outcomes are there", () => {
    const pointed = decideOrder(null, "a", 2, null, true)
    expect(pointed).toEqual({key: "a", order: [0, 1]})
    expect(decideOrder(pointed, "a", 2, [1], false)).toBe(pointed)
    expect(decideOrder(null, "a", 2, [1], true)?.order).toEqual([0, 1])
  })
  it("not while outcomes are missing", () => expect(decideOrder(null, "a", 2, null, false)).toBeNull())
  it("anew for another list", () => {
    expect(decideOrder({key: "a", order: [0]}, "b", 2, [1, 0], false)?.order).toEqual([1, 0])
  })
})
