/// Lessons as the page reads and plays them: the files of the repository, steps, guesses, verdicts, progress, the toolbox.

import {readdirSync, readFileSync} from "node:fs"
import {toolbox} from "@rosy/codegen"
import {describe, expect, test} from "vitest"
import {type Lesson, lessonDecoder} from "../../src/lesson_files/lesson.ts"
import {isFinished, readProgress, writeProgress} from "../../src/lesson_files/progress.ts"
import {earnedStars, nextStar} from "../../src/lesson_files/stars.ts"
import {toolboxOf, wordsOf} from "../../src/lesson_files/toolbox_words.ts"
import {
  firstOpenStep,
  isDone,
  judgedSeed,
  type LessonEvent,
  type LessonsState,
  noLessons,
  programAt,
  reduceLesson,
  watchedNow,
} from "../../src/state/lesson_state.ts"
import type {LessonChecks} from "../../src/state/messages/messages.ts"
import {decode} from "../../src/wire/decode.ts"

const step = (id: string, kind: string, more: object = {}) => ({id, kind, ...more})
const file = {
  name: "small",
  course: "drive",
  number: 1,
  room: {size: [4, 3], start: {x: 1, y: 1}},
  toolbox: ["Velocity"],
  start: "main = simulate (Velocity 0.2 0)\n",
  steps: [
    step("guess", "predict", {answers: ["a", "b"], right: "a"}),
    step("look", "investigate", {answers: ["a", "b"], right: "a"}),
    step("go", "make", {
      seconds: 5,
      checks: [{kind: "moves", id: "far", metres: 1}],
      program: "main = simulate ()\n",
    }),
  ],
  texts: {
    en: {
      title: "Small",
      idea: "I",
      learned: "L",
      steps: {
        guess: {say: "Guess", answers: {a: "Left", b: "Right"}},
        look: {say: "Look", answers: {a: "A", b: "B"}, replies: {b: "No"}},
        go: {say: "Go"},
      },
      checks: {far: "It drives far"},
      hints: {far: ["Why?", "There"]},
    },
  },
  next: null,
}

function lesson(): Lesson {
  const read = decode(lessonDecoder("de"), file)
  if (read.kind !== "ok") throw new Error(read.message)
  return read.value
}

const after = (...events: readonly LessonEvent[]): LessonsState =>
  events.reduce((state, event) => reduceLesson(state, event).state, noLessons)
const opened: LessonEvent = {kind: "opened", lesson: lesson(), at: 0, runs: 3}
const at = (to: number): LessonEvent => ({kind: "stepped", to, runs: 3})
const answered = (answer: string): LessonEvent => ({kind: "answered", answer})
const judged = (run: number | null, passed: boolean): LessonEvent => {
  const checks: LessonChecks = {run, passed, over: true, checks: []}
  return {kind: "judged", checks}
}
const done = (state: LessonsState) => state.progress["small"] ?? []

const starred = {
  ...file,
  name: "sprint",
  steps: [
    step("go", "make", {
      seconds: 60,
      stars: true,
      checks: ["there", "quick", "quickest"].map(id => ({kind: "goals", id})),
    }),
  ],
}

describe("a challenge", () => {
  const read = decode(lessonDecoder("de"), starred)
  if (read.kind !== "ok") throw new Error(read.message)
  const challenge = read.value
  const [only] = challenge.steps
  if (only === undefined) throw new Error("a challenge has a step")
  const open: LessonEvent = {kind: "opened", lesson: challenge, at: 0, runs: 0}
  const run = (number: number, over: boolean, ...done: readonly string[]): LessonChecks => ({
    run: number,
    passed: false,
    over,
    checks: only.checks.map(({id}) => ({id, state: done.includes(id) ? "done" : "missed", seen: null})),
  })
  const judgedBy = (checks: LessonChecks): LessonEvent => ({kind: "judged", checks})
  const progress = (...runs: readonly LessonChecks[]) =>
    after(open, ...runs.map(judgedBy)).progress["sprint"] ?? []

  test("tells the service that its checks are stars", () => {
    expect(watchedNow(after(open))?.stars).toBe(true)
  })

  test("has no star without its goal, and one for each check with it", () => {
    expect(earnedStars(only, run(1, true, "quick", "quickest"))).toBe(0)
    expect(earnedStars(only, run(1, true, "there", "quickest"))).toBe(2)
    expect(nextStar(only, run(1, true, "there", "quickest"))?.id).toBe("quick")
    expect(nextStar(only, run(1, true, "there", "quick", "quickest"))).toBeNull()
  })

  test("has no star before the run is judged", () => {
    expect(earnedStars(only, run(1, false, "there", "quick", "quickest"))).toBe(0)
    expect(progress(run(1, false, "there"))).toEqual([])
  })

  test("keeps the stars of the best run, and is passed with the first", () => {
    expect(progress(run(1, true, "there", "quick"), run(2, true, "there"))).toEqual(["star-1", "star-2"])
    // Two runs with two stars each are not one with three.
    expect(progress(run(1, true, "there", "quick"), run(2, true, "there", "quickest"))).toHaveLength(2)
    expect(isDone(after(open), only)).toBe(false)
    expect(isDone(after(open, judgedBy(run(1, true, "there"))), only)).toBe(true)
  })
})

describe("a lesson", () => {
  test("has a room that is called like it, in the same language, unless the room has a title", () => {
    const german = {...file.texts.en, title: "Klein"}
    const titleOf = (room: object) => {
      const read = decode(lessonDecoder("de"), {...file, room, texts: {...file.texts, de: german}})
      return read.kind === "ok" ? read.value.room["title"] : read
    }
    expect(titleOf(file.room)).toBe("Klein")
    expect(titleOf({...file.room, title: "A hall"})).toBe("A hall")
  })

  test("is read in English where the language is missing", () => {
    expect(lesson().title).toBe("Small")
    expect(lesson().steps[2]?.checks).toEqual([{id: "far", text: "It drives far", hints: ["Why?", "There"]}])
  })

  test("with a damaged field is refused with its place", () => {
    const read = decode(lessonDecoder("en"), {...file, steps: [{id: "guess", kind: "nap"}]})
    expect(read).toEqual({
      kind: "mismatch",
      message: "at steps[0].kind: expected one of predict, run, investigate, modify, make",
    })
  })

  test("begins a step with the program that was named last", () => {
    expect(programAt(lesson(), 1)).toBe(file.start)
    expect(programAt(lesson(), 2)).toBe("main = simulate ()\n")
  })
})

describe("a step", () => {
  test("to guess is done with any answer", () => {
    expect(done(after(opened, answered("b")))).toEqual(["guess"])
  })

  test("with a question is done with the right answer only", () => {
    expect(done(after(opened, at(1), answered("b")))).toEqual([])
    expect(done(after(opened, at(1), answered("b"), answered("a")))).toEqual(["look"])
  })

  test("with a run is watched by the service while it is shown", () => {
    const checks = [{kind: "moves", id: "far", metres: 1}]
    expect(watchedNow(after(opened))).toBe(null)
    expect(watchedNow(after(opened, at(2)))).toEqual({seconds: 5, checks, stars: false})
    expect(reduceLesson(after(opened, at(2)), {kind: "closed"}).watched).toBe(null)
  })

  test("with checks is run with the same seed each time", () => {
    expect(judgedSeed(noLessons)).toBe(null)
    expect(judgedSeed(after(opened))).toBe(null)
    expect(judgedSeed(after(opened, at(2)))).toBe(1)
  })

  test("is passed by a run that began after it was shown", () => {
    expect(done(after(opened, at(2), judged(3, true)))).toEqual([])
    expect(done(after(opened, at(2), judged(4, false)))).toEqual([])
    const passed = after(opened, at(2), judged(4, true), judged(4, true))
    expect(done(passed)).toEqual(["go"])
    const last = lesson().steps[2]
    expect(last !== undefined && isDone(passed, last)).toBe(true)
  })

  test("shows hints from the beginning when it is shown again, and when they are about another check", () => {
    const wanted = (check: string): LessonEvent => ({kind: "hint-wanted", check})
    const hinted = after(opened, at(2), wanted("far"), wanted("far"))
    expect(hinted.open?.hints).toEqual({check: "far", count: 2})
    expect(reduceLesson(hinted, wanted("near")).state.open?.hints).toEqual({check: "near", count: 1})
    expect(reduceLesson(hinted, at(1)).state.open?.hints).toBe(null)
  })
})

describe("progress", () => {
  test("leads to the first step that is not done", () => {
    expect(firstOpenStep(lesson(), {})).toBe(0)
    expect(firstOpenStep(lesson(), {small: ["guess", "look"]})).toBe(2)
    expect(firstOpenStep(lesson(), {small: ["guess", "look", "go"]})).toBe(0)
  })

  test("is written and read, and a damaged text is no progress", () => {
    const progress = {small: ["guess"]}
    expect(readProgress(writeProgress(progress))).toEqual(progress)
    expect(readProgress("{")).toEqual({})
    expect(readProgress('{"small": 3}')).toEqual({})
    expect(isFinished(progress, {name: "small", steps: ["guess"]})).toBe(true)
    expect(isFinished(progress, {name: "small", steps: ["guess", "go"]})).toBe(false)
  })
})

describe("the toolbox of a lesson", () => {
  const labels = (words: readonly string[]) =>
    toolboxOf(toolbox("haskell"), words).flatMap(category => category.items.map(item => item.label))

  test("shows only blocks that say what the lessons have brought", () => {
    const first = labels(["Velocity", "simulate"])
    expect(first.length).toBeGreaterThan(2)
    expect(first.length).toBeLessThan(10)
  })

  test("knows every word that a lesson brings", () => {
    const all = new Set(toolbox("haskell").flatMap(c => c.items.flatMap(item => wordsOf(item.block))))
    for (const level of ["tasks", "reactions"] as const)
      for (const item of toolbox(level).flatMap(c => c.items))
        for (const word of wordsOf(item.block)) all.add(word)
    const folder = new URL("../../../examples/lessons/", import.meta.url)
    const unknown = readdirSync(folder, {withFileTypes: true})
      .filter(entry => entry.isDirectory())
      .flatMap(({name}) => {
        const text = readFileSync(new URL(`${name}/lesson.json`, folder), "utf8")
        const {blocks} = JSON.parse(text) as {blocks: readonly string[]}
        return blocks.filter(word => !all.has(word)).map(word => `${name}: ${word}`)
      })
    expect(unknown).toEqual([])
  })
})
