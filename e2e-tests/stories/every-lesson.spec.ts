/// Lessons followed from their first step to "Next lesson" by what their own files say: guesses, runs, questions with wrong answers first, hints,
/// the ticks, and what was learnt. In text a wrong attempt comes first, and lines are replaced until the program is the reference solution; in
/// blocks a solution is built from the blocks of the lesson (`lesson_recipes.ts`). Prints how long each lesson takes.

import {expect, type Page} from "@playwright/test"
import type {Hands} from "./hands.ts"
import {Keys} from "./keys.ts"
import {
  asShown,
  type LessonFolder,
  type LessonStep,
  lessonFolders,
  type WrongAttempt,
} from "./lesson_files.ts"
import {recipes} from "./lesson_recipes.ts"
import {Mouse} from "./mouse.ts"
import {Pupil} from "./pupil.ts"
import {test} from "./story.ts"

const lessons = lessonFolders()

/// A way to follow lessons.
interface Way {
  readonly name: string
  /// The view of the page, as its button is called.
  readonly view: string
  /// Whether a wrong attempt comes before the last step.
  readonly fails: boolean
  /// Changes the program into a solution of a step.
  readonly solves: (pupil: Pupil, lesson: LessonFolder, step: LessonStep, program: string) => Promise<void>
}

const inText: Way = {
  name: "in text, with a wrong attempt",
  // Wide enough for every line: the arrow keys go down by what is seen as a line.
  view: "Haskell",
  fails: true,
  solves: (pupil, _lesson, step, program) => pupil.rewrites(program, step.solution ?? program),
}

function inBlocks(name: string, handsOf: (page: Page) => Promise<Hands>): Way {
  return {
    name: `in blocks ${name}`,
    view: "Blocks",
    fails: false,
    async solves(pupil, lesson, step) {
      const recipe = recipes[`${lesson.name}/${step.id}`]
      if (recipe === undefined) throw new Error(`expected a recipe for ${lesson.name}/${step.id}`)
      await recipe(await handsOf(pupil.page))
    },
  }
}

/// Follows a lesson that is open at its first step.
async function follows(pupil: Pupil, lesson: LessonFolder, way: Way): Promise<void> {
  let program = lesson.start
  const attempted = way.fails ? lesson.steps.findLast(step => step.wrong.length > 0) : undefined
  for (const step of lesson.steps) {
    const texts = lesson.texts.steps[step.id]
    await expect(pupil.panel().locator(".step.now")).toContainText(asShown(texts?.say ?? ""))
    program = step.program ?? program
    if (step.kind === "predict" || step.kind === "investigate") {
      await answersQuestion(pupil, lesson, step)
    } else {
      if (step === attempted) program = await failsFirst(pupil, lesson, step, program)
      if (step.kind !== "run") {
        await seesHints(pupil, lesson)
        await way.solves(pupil, lesson, step, program)
        program = step.solution ?? program
      }
      await passes(pupil, lesson, step)
    }
    if (step !== lesson.steps.at(-1)) await pupil.goesOn()
  }
  await pupil.stands()
  await expect(pupil.panel()).toContainText("Lesson finished!")
  await expect(pupil.panel()).toContainText(asShown(lesson.texts.learned))
}

/// A guess is done with the first answer; a question may be answered again.
async function answersQuestion(pupil: Pupil, {texts}: LessonFolder, step: LessonStep): Promise<void> {
  const {answers = {}, replies = {}} = texts.steps[step.id] ?? {}
  const wrong = step.kind === "investigate" ? step.answers.filter(answer => answer !== step.right) : []
  for (const answer of [...wrong, step.right ?? ""]) {
    await pupil.answers(asShown(answers[answer] ?? ""))
    await expect(pupil.panel().locator(".reply")).toHaveText(asShown(replies[answer] ?? ""))
    if (answer !== step.right) await expect(pupil.panel().locator(".step.now.done")).toHaveCount(0)
  }
}

/// Runs the first of the typical wrong attempts: its check says what was seen, and the step is not done. Returns the program.
async function failsFirst(
  pupil: Pupil,
  lesson: LessonFolder,
  step: LessonStep,
  program: string,
): Promise<string> {
  const attempt = step.wrong[0] as WrongAttempt
  await pupil.rewrites(program, attempt.program)
  await drives(pupil, step)
  const check = pupil.check(asShown(lesson.texts.checks[attempt.check] ?? ""))
  await expect(check).toHaveAttribute("data-check-state", "missed")
  await expect(check.locator(".seen")).toHaveText(/\S.*\./)
  await pupil.stands()
  await expect(pupil.panel().locator(".step.now.done")).toHaveCount(0)
  return attempt.program
}

/// Hints that are computed from the program.
const computed = /is defined, but nothing uses it yet|a value of type \w+ yet/

/// Asks for one hint after the other; they are about one check.
async function seesHints(pupil: Pupil, {texts}: LessonFolder): Promise<void> {
  const shown = pupil.panel().locator(".hints [aria-live] > *")
  const button = pupil.panel().locator("button.hint")
  await expect(button).toBeVisible()
  for (let count = 1; (await button.count()) > 0; count++) {
    await button.click()
    await expect(shown).toHaveCount(count)
  }
  const seen = (await shown.allTextContents()).filter(hint => !computed.test(hint))
  const known = Object.values(texts.hints).map(hints => hints.map(asShown))
  expect(known.some(hints => seen.every(hint => hints.includes(hint)))).toBe(true)
}

async function drives(pupil: Pupil, step: LessonStep): Promise<void> {
  if (step.hands.length > 0) await pupil.triesWithHands(step.hands, step.seconds)
  else await pupil.tries()
}

/// Runs until the step is done.
async function passes(pupil: Pupil, {texts}: LessonFolder, step: LessonStep): Promise<void> {
  await drives(pupil, step)
  await expect(pupil.panel().locator(".step.now.done")).toHaveCount(1)
  const after = texts.steps[step.id]?.after ?? ""
  if (after !== "") await expect(pupil.panel().locator(".after")).toHaveText(asShown(after))
  for (const check of await pupil.panel().locator(".check").all())
    await expect(check).toHaveAttribute("data-check-state", "done")
}

/// Follows lessons one after the other in one page, and says how long each takes.
async function followsAll(page: Page, some: readonly LessonFolder[], way: Way): Promise<void> {
  const pupil = new Pupil(page)
  const times: string[] = []
  await page.goto("/")
  await expect(pupil.haskell()).toContainText("simulate")
  await page.getByRole("button", {name: way.view, exact: true}).click()
  for (const lesson of some) {
    const before = lessons[lesson.number - 2]
    const began = Date.now()
    // The way from one lesson to the next, where the one before was finished here.
    if (before !== undefined && some.includes(before))
      await pupil.panel().getByRole("button", {name: "Next lesson"}).click()
    else await pupil.choosesLesson(lesson.texts.title)
    await expect(
      pupil.panel().getByRole("heading", {name: lesson.texts.title, exact: true, level: 2}),
    ).toBeVisible()
    await expect(page.getByRole("textbox", {name: "Name of the program"})).toHaveValue(lesson.texts.title)
    await pupil.drivesAt("16")
    await test.step(lesson.name, () => follows(pupil, lesson, way))
    times.push(`${lesson.number} ${lesson.name} ${way.view}: ${((Date.now() - began) / 1000).toFixed(1)} s`)
  }
  console.log(times.join("\n"))
}

async function atKeyboard(page: Page): Promise<Hands> {
  const keys = new Keys(page)
  await keys.enters()
  return keys
}

/// Followed in the page: together they have each kind of step, with and without hands, and the two ways to build. What differs from lesson to
/// lesson is data: `sim-service/tests/system/test_lessons.py` plays every solution and wrong attempt of every lesson, `editor/test/lessons` reads
/// all texts, and takes every block of a solution from the toolbox of its lesson.
const followed: readonly {readonly lesson: string; readonly way: Way}[] = [
  {lesson: "remote-control", way: inText},
  {lesson: "stop-before-the-wall", way: inText},
  {lesson: "hello-robot", way: inBlocks("by mouse", async page => new Mouse(page))},
  {lesson: "hello-robot", way: inBlocks("by keyboard alone", atKeyboard)},
]

for (const {lesson, way} of followed)
  test(`to the end ${way.name}: ${lesson}`, async ({page}) => {
    await followsAll(
      page,
      lessons.filter(({name}) => name === lesson),
      way,
    )
  })
