/// Lessons from files and links: what is read, and where the mistake is in what cannot be.

import {readdirSync, readFileSync} from "node:fs"
import {describe, expect, test} from "vitest"
import {fragmentOf, programIn} from "../../src/browser/share_link.ts"
import {refuseLesson} from "../../src/controller/lessons/lessons.ts"
import {readDraft} from "../../src/lesson_files/draft_file.ts"
import {isLessonFile, readLessonFile} from "../../src/lesson_files/lesson_file.ts"
import type {PageEvent} from "../../src/state/page_events.ts"
import {noticeText} from "../../src/ui/descriptions.ts"

const question = {id: "look", kind: "investigate", answers: ["a", "b"], right: "a"}
const made = {id: "go", kind: "make", seconds: 5, checks: [{kind: "moves", id: "far", metres: 1}]}
const texts = {
  title: "Mine",
  idea: "I",
  learned: "L",
  steps: {look: {say: "Look", answers: {a: "A", b: "B"}}, go: {say: "Go"}},
  checks: {far: "It drives far"},
}
const file = {
  lesson: 1,
  name: "mine",
  room: {size: [4, 3], start: {x: 1, y: 1}},
  start: "main = simulate (Velocity 0.2 0)\n",
  steps: [question, made],
  texts: {en: texts},
}
const read = (value: object) => readLessonFile(JSON.stringify(value), "de")

describe("a lesson from a file", () => {
  test("needs neither course nor place nor toolbox, and its name is kept apart from those of the service", () => {
    const found = read(file)
    expect(found).toMatchObject({
      kind: "lesson",
      lesson: {
        name: "own mine",
        number: null,
        toolbox: null,
        next: null,
        title: "Mine",
        room: {size: [4, 3], title: "Mine", name: "lesson own mine"},
        file: JSON.stringify(file),
      },
    })
  })

  test("is told from programs and rooms", () => {
    expect(isLessonFile(JSON.stringify(file))).toBe(true)
    expect(isLessonFile(`\uFEFF${JSON.stringify(file)}`)).toBe(true)
    for (const other of [
      '{"rosy": 1}',
      '{"size": [4, 3]}',
      "main = simulate ()",
      "3",
      "null",
      '{"lesson": 1',
    ]) {
      expect(isLessonFile(other), other).toBe(false)
    }
  })

  const wrong: readonly (readonly [string, object])[] = [
    ["lesson", {...file, lesson: "1"}],
    ["name", {...file, name: undefined}],
    ["start", {...file, start: 3}],
    ["room.size", {...file, room: {size: 4}}],
    ["texts", {...file, texts: {}}],
    ["texts.en.title", {...file, texts: {en: {...texts, title: 3}}}],
    ["texts.steps.go", {...file, texts: {en: {...texts, steps: {look: texts.steps.look}}}}],
    ["steps", {...file, steps: []}],
    ["steps[0].kind", {...file, steps: [{...question, kind: "ponder"}, made]}],
    ["steps[0].answers", {...file, steps: [{...question, answers: ["a"]}, made]}],
    ["steps[0].right", {...file, steps: [{...question, right: "c"}, made]}],
    ["steps[1].id", {...file, steps: [question, {...made, id: "look"}]}],
    ["steps[1].seconds", {...file, steps: [question, {...made, seconds: undefined}]}],
    ["steps[1].checks", {...file, steps: [question, {...made, checks: []}]}],
    [
      "steps[1].checks[0].kind",
      {...file, steps: [question, {...made, checks: [{kind: "flies", id: "far"}]}]},
    ],
  ]
  test("of a newer Rosy is said to be that, with both versions, whatever else has changed in it", () => {
    const found = read({...file, lesson: 2, texts: {}, steps: [{kind: "ponder"}]})
    expect(found).toEqual({kind: "newer", version: 2})
    expect(readDraft(JSON.stringify({...file, lesson: 2}), "de")).toEqual({kind: "newer", version: 2})
    const told: PageEvent[] = []
    refuseLesson({dispatch: event => told.push(event)}, "mine.json", {kind: "newer", version: 2})
    const [event] = told
    if (event?.kind !== "notice" || event.notice === null) throw new Error("expected a notice")
    const {message, hint} = noticeText(event.notice)
    expect(`${message} ${hint}`).toBe(
      "mine.json cannot be opened: it is a lesson of a newer Rosy. Its version is 2, and this Rosy reads up to 1; update Rosy to open it.",
    )
  })

  test.each(wrong)("a mistake at %s is found there", (at, value) => {
    const found = read(value)
    expect(found.kind === "damaged" && found.at).toBe(at)
  })

  test("knows every kind of check that a lesson of the repository has", () => {
    const folder = new URL("../../../examples/lessons/", import.meta.url)
    const kinds = readdirSync(folder, {withFileTypes: true})
      .filter(entry => entry.isDirectory())
      .map(entry => JSON.parse(readFileSync(new URL(`${entry.name}/lesson.json`, folder), "utf8")))
      .flatMap(({steps}: {steps: {checks?: {kind: string}[]}[]}) => steps.flatMap(step => step.checks ?? []))
      .map(check => check.kind)
    for (const kind of new Set(kinds)) {
      const found = read({...file, steps: [question, {...made, checks: [{kind, id: "far"}]}]})
      expect(found.kind, kind).toBe("lesson")
    }
  })
})

test("a link to a lesson contains the lesson, and a changed letter is recognised", async () => {
  const text = JSON.stringify(file)
  const fragment = await fragmentOf(text, "lesson")
  expect(fragment).toMatch(/^#lesson=/)
  expect(await programIn(fragment)).toEqual({kind: "lesson", text})
  expect(await programIn(fragment.slice(0, -6))).toEqual({kind: "damaged"})
})
