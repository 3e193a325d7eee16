/// Drafts of lessons: edits, what is still missing, the file that they become and are read from, and how they are stored.

import {readFileSync} from "node:fs"
import {toolbox} from "@rosy/codegen"
import {Ajv2020} from "ajv/dist/2020.js"
import {describe, expect, test} from "vitest"
import {offeredItems, withItem} from "../../src/features/lesson_editor/block_choice.ts"
import {patternOf, readPattern, writePattern} from "../../src/features/lesson_editor/channel_pattern.ts"
import {initialArguments, specsOf} from "../../src/lesson_files/check_arguments.ts"
import {
  type DraftEdit,
  type DraftStep,
  editDraft,
  type LessonDraft,
  newDraft,
  withCheck,
  withHint,
} from "../../src/lesson_files/draft.ts"
import {lessonText, readDraft} from "../../src/lesson_files/draft_file.ts"
import {mistakesOf} from "../../src/lesson_files/draft_mistakes.ts"
import {mergeDrafts, readDrafts, writeDrafts} from "../../src/lesson_files/draft_storage.ts"
import {checkKinds, readLessonFile} from "../../src/lesson_files/lesson_file.ts"
import {editedDraft, noLessons, reduceLesson} from "../../src/state/lesson_state.ts"

const schema = new URL("../../../protocol/lesson-document.schema.json", import.meta.url)
const isValid = new Ajv2020({strict: false}).compile(JSON.parse(readFileSync(schema, "utf8")))

const room = {
  name: "room",
  size: [6, 4],
  start: {x: 1, y: 2},
  goals: [{kind: "reach", x: 3, y: 2, r: 0.4, title: "ring"}],
}
const empty = newDraft("lesson-1", "de", room, "main = simulate (Velocity 0.1 0)\n")
const edited = (draft: LessonDraft, ...edits: readonly DraftEdit[]) => edits.reduce(editDraft, draft)
const changed = (draft: LessonDraft, at: number, change: (step: DraftStep) => DraftStep): LessonDraft => {
  const step = draft.steps[at]
  if (step === undefined) throw new Error(`expected a step ${at}`)
  return editDraft(draft, {kind: "step-changed", at, step: change(step)})
}

/// A lesson with a guess, and a step with a check of every kind.
function whole(): LessonDraft {
  const begun = edited(
    empty,
    {kind: "said", field: "title", text: "Zum Ring"},
    {kind: "said", field: "idea", text: "Schneller kommt weiter."},
    {kind: "solution", program: "main = simulate (Velocity 0.4 0)\n"},
    {kind: "toolbox", words: ["Velocity"]},
    {kind: "step-added", step: "predict"},
    {kind: "step-added", step: "make"},
  )
  const asked = changed(begun, 0, step => ({
    ...step,
    say: {de: "Wohin?"},
    answers: step.answers.map((answer, i) => ({
      ...answer,
      text: {de: `Antwort ${i}`},
      reply: i === 0 ? {de: "Ja"} : {},
    })),
    right: step.answers[1]?.id ?? null,
  }))
  const checked = checkKinds.reduce(
    (draft, kind) => changed(draft, 1, step => withCheck(draft, step, kind, initialArguments(kind))),
    asked,
  )
  return changed(checked, 1, step => ({
    ...step,
    say: {de: "Fahr in den Ring."},
    after: {de: "Geschafft."},
    checks: step.checks.map(check => {
      const said = {...check, text: {de: `Prüfung ${check.kind}`}}
      if (check.kind === "moves") return {...said, wrong: ["main = simulate (Velocity 0 1)\n"]}
      if (check.kind === "says") return {...said, arguments: {texts: ["hallo", " "]}}
      if (check.kind === "function") return {...said, arguments: {takes: ["Bumper", " Memory"], gives: []}}
      return check.kind === "at" ? withHint(said, 1, "de", "Schau auf die Zahl.") : said
    }),
  }))
}

describe("a draft", () => {
  test("gives steps and checks ids of their own, also after others were removed", () => {
    const draft = edited(
      empty,
      {kind: "step-added", step: "run"},
      {kind: "step-added", step: "make"},
      {kind: "step-removed", at: 0},
      {kind: "step-added", step: "modify"},
    )
    expect(draft.steps.map(step => step.id)).toEqual(["step-2", "step-1"])
  })

  test("moves steps, within the list", () => {
    const draft = edited(empty, {kind: "step-added", step: "run"}, {kind: "step-added", step: "make"})
    const kinds = (of: LessonDraft) => of.steps.map(step => step.kind)
    expect(kinds(editDraft(draft, {kind: "step-moved", at: 1, by: -1}))).toEqual(["make", "run"])
    expect(kinds(editDraft(draft, {kind: "step-moved", at: 1, by: 1}))).toEqual(["run", "make"])
    expect(kinds(editDraft(draft, {kind: "step-moved", at: 0, by: -1}))).toEqual(["run", "make"])
  })

  test("keeps its texts in each language apart", () => {
    const draft = edited(
      whole(),
      {kind: "language", language: "en"},
      {kind: "said", field: "title", text: "To the ring"},
    )
    expect(draft.title).toEqual({de: "Zum Ring", en: "To the ring"})
    expect(editDraft(draft, {kind: "said", field: "title", text: " "}).title).toEqual({de: "Zum Ring"})
  })
})

describe("what is missing", () => {
  test("is everything at the beginning", () => {
    expect(mistakesOf(empty)).toEqual([{kind: "no-title", language: "de"}, {kind: "no-steps"}])
  })

  test("is nothing when all is there", () => {
    expect(mistakesOf(whole())).toEqual([])
  })

  test("is the rest of a language that was begun", () => {
    const draft = edited(
      whole(),
      {kind: "language", language: "en"},
      {kind: "said", field: "title", text: "T"},
    )
    const missing = mistakesOf(draft)
    expect(missing).toContainEqual({kind: "no-step-text", step: 1, language: "en"})
    expect(missing).toContainEqual({kind: "no-answer-text", step: 1, answer: 2, language: "en"})
    expect(missing).toContainEqual({kind: "no-check-text", step: 2, check: 14, language: "en"})
  })

  test("is the right answer, a check, the place of a check, what is to be said", () => {
    const noPlace = editDraft(whole(), {kind: "room", room: {...room, goals: []}})
    expect(mistakesOf(noPlace).map(({kind}) => kind)).toEqual(["no-place", "no-place"])
    const noAnswer = changed(whole(), 0, step => ({...step, right: null, answers: step.answers.slice(0, 1)}))
    expect(mistakesOf(noAnswer)).toEqual([
      {kind: "few-answers", step: 1},
      {kind: "no-right", step: 1},
    ])
    expect(mistakesOf(changed(whole(), 1, step => ({...step, checks: []})))).toEqual([
      {kind: "no-checks", step: 2},
    ])
    const silent = changed(whole(), 1, step => ({
      ...step,
      checks: step.checks.map(check =>
        check.kind === "says" ? {...check, arguments: {texts: [" "]}} : check,
      ),
    }))
    expect(mistakesOf(silent).map(({kind}) => kind)).toEqual(["empty-check"])
  })
})

describe("the file of a draft", () => {
  test("satisfies the schema, and the page reads it as a lesson", () => {
    const text = lessonText(whole(), "teacher")
    expect(isValid(JSON.parse(text)), JSON.stringify(isValid.errors)).toBe(true)
    const read = readLessonFile(text, "de")
    expect(read).toMatchObject({kind: "lesson", lesson: {title: "Zum Ring", toolbox: ["Velocity"]}})
    const checks = read.kind === "lesson" ? (read.lesson.steps[1]?.checks ?? []) : []
    expect(checks.find(check => check.hints.length > 0)?.hints).toEqual(["", "Schau auf die Zahl."])
  })

  test("has the solution, the wrong attempts and the movements of hands for teachers only", () => {
    const draft = changed(whole(), 1, step => ({...step, hands: [{t: 1, press: "Button0"}]}))
    const {solution, steps} = JSON.parse(lessonText(draft, "teacher"))
    expect(solution).toContain("0.4")
    const check = steps[1].checks.find((one: {kind: string}) => one.kind === "moves")
    expect(steps[1].wrong).toEqual([{check: check.id, program: "main = simulate (Velocity 0 1)\n"}])
    expect(steps[1].hands).toEqual([{t: 1, press: "Button0"}])
    expect(isValid(JSON.parse(lessonText(draft, "teacher"))), JSON.stringify(isValid.errors)).toBe(true)
    const pupil = lessonText(draft, "pupil")
    expect(pupil).not.toContain("Velocity 0.4")
    expect(pupil).not.toContain("wrong")
    expect(pupil).not.toContain("hands")
  })

  test("is refused when a wrong attempt is about a check that the step does not have", () => {
    const value = JSON.parse(lessonText(whole(), "teacher"))
    value.steps[1].wrong = [{check: "nowhere", program: ""}]
    expect(readDraft(JSON.stringify(value), "de")).toEqual({kind: "damaged", at: "steps[1].wrong[0].check"})
  })

  test("is read as the same draft", () => {
    const read = readDraft(lessonText(whole(), "teacher"), "fr")
    expect(read.kind).toBe("draft")
    if (read.kind !== "draft") return
    expect(read.draft.language).toBe("de")
    expect(lessonText(read.draft, "teacher")).toBe(lessonText(whole(), "teacher"))
    expect(mistakesOf(read.draft)).toEqual([])
  })

  test("has no solution when it is for pupils", () => {
    expect(JSON.parse(lessonText(whole(), "teacher")).solution).toContain("0.4")
    expect(lessonText(whole(), "pupil")).not.toContain("solution")
  })

  test("with a mistake is refused with its place", () => {
    const text = lessonText(whole(), "teacher").replace('"kind": "make"', '"kind": "nap"')
    expect(readDraft(text, "de")).toEqual({kind: "damaged", at: "steps[1].kind"})
  })
})

describe("drafts in the browser", () => {
  test("are read as they were stored, and a damaged one is left out", () => {
    expect(readDrafts(writeDrafts([whole(), empty]))).toEqual([whole(), empty])
    expect(readDrafts(`[{"name": 3}, ${JSON.stringify(empty)}]`)).toEqual([empty])
    expect(readDrafts("{")).toEqual([])
  })

  test("of two tabs are kept both", () => {
    const other = {...empty, name: "lesson-2"}
    const mine = {...empty, solution: "main = simulate ()\n"}
    expect(mergeDrafts([empty, other], [empty], [mine])).toEqual([mine, other])
    expect(mergeDrafts([empty, other], [empty], [])).toEqual([other])
  })

  test("are edited, tried from the first step on, and edited again", () => {
    const opened = reduceLesson(noLessons, {kind: "draft-opened", draft: whole()}).state
    const read = readLessonFile(lessonText(whole(), "teacher"), "de")
    if (read.kind !== "lesson") throw new Error("expected a lesson")
    const {lesson} = read
    const before = {...opened, progress: {[lesson.name]: ["step-1"]}}
    const tried = reduceLesson(before, {kind: "draft-tried", lesson, runs: 2}).state
    expect(tried.open).toMatchObject({at: 0, since: 2})
    expect(tried.progress).toEqual({})
    const back = reduceLesson(tried, {kind: "closed"}).state
    expect(back.open).toBe(null)
    expect(back.writing).toEqual({name: "lesson-1", mode: "editing"})
    expect(editedDraft(back)).toEqual(whole())
    expect(reduceLesson(back, {kind: "draft-closed"}).state).toMatchObject({writing: null, drafts: [whole()]})
    expect(reduceLesson(back, {kind: "draft-removed", name: "lesson-1"}).state).toMatchObject({
      writing: null,
      drafts: [],
    })
  })
})

describe("the forms of checks", () => {
  test("show every argument and pattern that a check of the repository has", () => {
    const folder = new URL("../../../examples/lessons/", import.meta.url)
    for (const name of ["bump", "lift-me", "faster", "chance", "hello-robot", "count-the-bumps"]) {
      const {steps} = JSON.parse(readFileSync(new URL(`${name}/lesson.json`, folder), "utf8"))
      for (const check of steps.flatMap((step: {checks?: unknown[]}) => step.checks ?? [])) {
        const {kind, id, ...given} = check
        const known = Object.fromEntries(specsOf(kind))
        expect(Object.keys(known), `${name}: ${id}`).toEqual(expect.arrayContaining(Object.keys(given)))
        for (const of of ["event", "command"] as const)
          if (of in given) expect(readPattern(given[of], of), `${name}: ${given[of]}`).not.toBe(null)
      }
    }
  })

  test.each([
    ["Bumper _ Pressed", "event"],
    ["Velocity >0.25 <0", "command"],
    ["Velocity 0 _", "command"],
    ["Say _", "command"],
  ] as const)("read %s and write it again", (text, of) => {
    const pattern = readPattern(text, of)
    expect(pattern === null ? null : writePattern(pattern)).toBe(text)
  })

  test("add the values that a pattern leaves out, and refuse what the robot does not have", () => {
    const pattern = readPattern("Bumper", "event")
    expect(pattern).toEqual(patternOf("event", "Bumper"))
    for (const wrong of ["Nose _", "Bumper Pressed", "Bumper _ _ _", "Led1 >0"])
      expect(readPattern(wrong, "event") ?? readPattern(wrong, "command"), wrong).toBe(null)
  })
})

describe("the choice of blocks", () => {
  const categories = toolbox("haskell")
  const items = categories.flatMap(category => category.items)
  const velocity = items.find(
    ({block, label}) => !/^(main|pattern_)/.test(block.type) && label.includes("Velocity"),
  )

  test("offers a block and takes it back", () => {
    if (velocity === undefined) throw new Error("expected a block with Velocity")
    const words = withItem(categories, [], velocity, true)
    const offered = (chosen: readonly string[]) =>
      offeredItems(categories, chosen)
        .flatMap(category => category.items)
        .find(one => one.item === velocity)?.isOffered
    expect(offered(words)).toBe(true)
    expect(words.length).toBeGreaterThan(0)
  })

  test("keeps the words that other blocks need", () => {
    const all = [...new Set(items.flatMap(item => withItem(categories, [], item, true)))]
    const free = offeredItems(categories, all)
      .flatMap(category => category.items)
      .filter(one => one.isOffered && one.fixed === null)
    expect(free.length).toBeGreaterThan(0)
    const [first] = free
    if (first === undefined) return
    const fewer = offeredItems(categories, withItem(categories, all, first.item, false))
    const gone = fewer.flatMap(category => category.items).filter(one => !one.isOffered && one.fixed === null)
    expect(gone.map(one => one.item)).toContain(first.item)
  })
})
