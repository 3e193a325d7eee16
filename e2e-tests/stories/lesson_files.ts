/// Lessons of `examples/lessons` as their folders say them: texts in English, programs, solutions and wrong attempts.

import {existsSync, readdirSync, readFileSync} from "node:fs"

const folder = new URL("../../examples/lessons/", import.meta.url)

/// What a person does to the robot while a step is run: lines of `./rosy run --input`.
export interface HandMovement {
  readonly t: number
  readonly press?: string
  readonly release?: string
  readonly lift?: string
  readonly lower?: string
}

export interface LessonStep {
  readonly id: string
  readonly kind: "predict" | "run" | "investigate" | "modify" | "make"
  readonly answers: readonly string[]
  readonly right: string | null
  /// How long its run is watched, s; 0 for a question.
  readonly seconds: number
  readonly checks: readonly string[]
  readonly hands: readonly HandMovement[]
  /// The program that the step begins with; `null`: the program as it is.
  readonly program: string | null
  /// The reference solution; `null` for a question or a run.
  readonly solution: string | null
  readonly wrong: readonly WrongAttempt[]
}

export interface WrongAttempt {
  readonly program: string
  /// The check that it fails.
  readonly check: string
}

export interface LessonTexts {
  readonly title: string
  readonly learned: string
  readonly steps: {readonly [step: string]: StepTexts}
  readonly checks: {readonly [check: string]: string}
  readonly hints: {readonly [check: string]: readonly string[]}
}

interface StepTexts {
  readonly say: string
  readonly after?: string
  readonly answers?: {readonly [answer: string]: string}
  readonly replies?: {readonly [answer: string]: string}
}

export interface LessonFolder {
  readonly name: string
  readonly number: number
  readonly start: string
  readonly steps: readonly LessonStep[]
  readonly texts: LessonTexts
}

/// All lessons in their order.
export function lessonFolders(): readonly LessonFolder[] {
  return readdirSync(folder, {withFileTypes: true})
    .filter(entry => entry.isDirectory())
    .map(entry => lessonFolder(entry.name))
    .sort((a, b) => a.number - b.number)
}

/// A text as the page shows it: code stands in its own type in place of the backticks.
export const asShown = (text: string): string => text.replaceAll("`", "")

const read = (path: string): string => readFileSync(new URL(path, folder), "utf8")

function lessonFolder(name: string): LessonFolder {
  const file = JSON.parse(read(`${name}/lesson.json`))
  const steps = (file.steps as readonly Record<string, never>[]).map((step): LessonStep => {
    const {
      id,
      kind,
      answers = [],
      right = null,
      seconds = 0,
      checks = [],
      hands = [],
      program,
    } = step as never as {
      id: string
      kind: LessonStep["kind"]
      answers?: readonly string[]
      right?: string
      seconds?: number
      checks?: readonly {readonly id: string}[]
      hands?: readonly HandMovement[]
      program?: string
    }
    const solution = `${name}/solutions/${id}/reference.hs`
    const isAsked = kind === "modify" || kind === "make"
    return {
      id,
      kind,
      answers,
      right,
      seconds,
      checks: checks.map(check => check.id),
      hands,
      program: program === undefined ? null : read(`${name}/${program}`),
      solution: isAsked ? read(solution) : null,
      wrong: wrongAttempts(`${name}/wrong/${id}/`),
    }
  })
  return {
    name,
    number: file.number,
    start: read(`${name}/start.hs`),
    steps,
    texts: JSON.parse(read(`${name}/texts/en.json`)),
  }
}

function wrongAttempts(path: string): readonly WrongAttempt[] {
  if (!existsSync(new URL(path, folder))) return []
  return readdirSync(new URL(path, folder))
    .sort()
    .map(file => ({program: read(`${path}${file}`), check: file.split(".")[0] ?? ""}))
}
