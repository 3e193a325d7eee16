/// Lessons of `examples/lessons` as the pages for teachers need them: texts, programs, solutions, and near misses with what the check has seen.
///
/// In: the folders of the lessons and `docs/teaching/near-misses.json`, which `sim-service/tests/system/test_lessons.py` writes and compares
/// with the runs. Out: one value per lesson, in their order. Node reads it while the guide is built.

import {existsSync, readdirSync, readFileSync} from "node:fs"
import {basename, join} from "node:path"
import type {Seen} from "../../src/wire/verdict.generated.ts"

export interface LessonTexts {
  readonly title: string
  readonly idea: string
  readonly learned: string
  readonly steps: Readonly<Record<string, StepTexts>>
  readonly checks: Readonly<Record<string, string>>
}

export interface StepTexts {
  readonly say: string
  readonly answers?: Readonly<Record<string, string>>
  readonly after?: string
}

/// A wrong attempt: the check that it fails, and what the check has seen.
export interface NearMiss {
  readonly program: string
  readonly check: string
  readonly seen: Seen
}

export interface LessonStep {
  readonly id: string
  readonly kind: "predict" | "run" | "investigate" | "modify" | "make"
  /// The id of the right answer.
  readonly right: string | null
  readonly checks: readonly string[]
  /// The reference solution comes first, then from short to long.
  readonly solutions: readonly string[]
  readonly nearMisses: readonly NearMiss[]
}

export interface LessonSource {
  readonly name: string
  readonly course: string
  readonly number: number
  readonly start: string
  readonly steps: readonly LessonStep[]
  /// English when the language has no texts.
  texts(language: string): LessonTexts
}

interface LessonJson {
  readonly course: string
  readonly number: number
  readonly steps: readonly {
    readonly id: string
    readonly kind: LessonStep["kind"]
    readonly right?: string
    readonly checks?: readonly {readonly id: string}[]
  }[]
}

type SeenByAttempt = Readonly<Record<string, Partial<Seen> & Pick<Seen, "what">>>

export function readLessons(root: string): readonly LessonSource[] {
  const folder = join(root, "examples/lessons")
  const seen = json<SeenByAttempt>(join(root, "docs/teaching/near-misses.json"))
  return readdirSync(folder, {withFileTypes: true})
    .filter(one => one.isDirectory())
    .map(({name}) => readLesson(join(folder, name), seen))
    .sort((one, other) => one.number - other.number)
}

function readLesson(folder: string, seen: SeenByAttempt): LessonSource {
  const name = basename(folder)
  const {course, number, steps} = json<LessonJson>(join(folder, "lesson.json"))
  return {
    name,
    course,
    number,
    start: program(join(folder, "start.hs")),
    steps: steps.map(({id, kind, right = null, checks = []}) => ({
      id,
      kind,
      right,
      checks: checks.map(check => check.id),
      solutions: programsIn(join(folder, "solutions", id))
        .map(program)
        .sort(byLength(folder, id)),
      nearMisses: programsIn(join(folder, "wrong", id)).map(path => {
        const attempt = basename(path, ".hs")
        const found = seen[`${name}/${id}/${attempt}`]
        if (found === undefined) throw new Error(`near-misses.json has no ${name}/${id}/${attempt}`)
        return {
          program: program(path),
          check: attempt.split(".")[0] ?? "",
          seen: {time: null, number: null, name: null, ...found},
        }
      }),
    })),
    texts(language) {
      const path = join(folder, "texts", `${language}.json`)
      return json(existsSync(path) ? path : join(folder, "texts/en.json"))
    },
  }
}

/// The reference first.
function byLength(folder: string, step: string): (one: string, other: string) => number {
  const path = join(folder, "solutions", step, "reference.hs")
  const reference = existsSync(path) ? program(path) : null
  const place = (text: string) => (text === reference ? -1 : text.length)
  return (one, other) => place(one) - place(other)
}

const programsIn = (folder: string): readonly string[] =>
  existsSync(folder)
    ? readdirSync(folder)
        .filter(name => name.endsWith(".hs"))
        .sort()
        .map(name => join(folder, name))
    : []

const program = (path: string): string => readFileSync(path, "utf8").trim()

const json = <Value>(path: string): Value => JSON.parse(readFileSync(path, "utf8")) as Value
