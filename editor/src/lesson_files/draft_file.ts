/// Conversion between a draft and a lesson file (`protocol/lesson-document.schema.json`). Pure.

import {withoutMark} from "@rosy/codegen/text-file"
import {
  type Decoder,
  list,
  Mismatch,
  number,
  object,
  oneOf,
  optional,
  parseJson,
  string,
  unknownRecord,
} from "../wire/decode.ts"
import type {WorldFile} from "../worlds/world.ts"
import {specsOf} from "./check_arguments.ts"
import {
  type Argument,
  cleaned,
  type DraftCheck,
  type DraftStep,
  isQuestion,
  type LessonDraft,
  type Translations,
} from "./draft.ts"
import {argument} from "./draft_storage.ts"
import {lessonTexts, record} from "./lesson.ts"
import {type CheckKind, checkKinds, type RefusedLesson, readLessonFile, version} from "./lesson_file.ts"

export type ReadDraft = {readonly kind: "draft"; readonly draft: LessonDraft} | RefusedLesson

/// The languages that something is written in.
export function languagesOf(draft: LessonDraft): readonly string[] {
  const steps = draft.steps.flatMap(textsOfStep)
  const all = [draft.title, draft.idea, draft.learned, ...steps]
  return [...new Set(all.flatMap(texts => Object.keys(texts)))].sort()
}

function textsOfStep({say, after, kind, answers, checks}: DraftStep): readonly Translations[] {
  const inside = isQuestion(kind)
    ? answers.flatMap(({text, reply}) => [text, reply])
    : checks.flatMap(({text, hints}) => [text, ...hints])
  return [say, after, ...inside]
}

export type LessonReader = "teacher" | "pupil"

/// The text of the lesson file. A link for pupils leaves the solution and the wrong attempts out.
export function lessonText(draft: LessonDraft, reader: LessonReader): string {
  const {name, room, toolbox, start, solution, steps} = draft
  const value = {
    lesson: version,
    name,
    room,
    ...(toolbox === null ? {} : {toolbox}),
    start,
    ...(solution === null || reader === "pupil" ? {} : {solution}),
    steps: steps.map(step => stepValue(step, reader)),
    texts: Object.fromEntries(languagesOf(draft).map(language => [language, textsIn(draft, language)])),
  }
  return `${JSON.stringify(value, null, 1)}\n`
}

function stepValue(step: DraftStep, reader: LessonReader): object {
  const {id, kind, checks, answers, right, program, hands} = step
  const own = program === null ? {} : {program}
  if (isQuestion(kind)) return {id, kind, answers: answers.map(answer => answer.id), right, ...own}
  const wrong = checks.flatMap(check => check.wrong.map(one => ({check: check.id, program: one})))
  return {
    id,
    kind,
    ...watchedStep(step),
    ...own,
    ...(hands.length === 0 || reader === "pupil" ? {} : {hands}),
    ...(wrong.length === 0 || reader === "pupil" ? {} : {wrong}),
  }
}

/// What the service judges a run by.
export function watchedStep({seconds, checks}: DraftStep): object {
  const written = checks.map(check => ({
    kind: check.kind,
    id: check.id,
    ...Object.fromEntries(Object.entries(check.arguments).map(([name, value]) => [name, cleaned(value)])),
  }))
  return {seconds, checks: written}
}

function textsIn({title, idea, learned, steps}: LessonDraft, language: string): object {
  const said = (texts: Translations) => texts[language] ?? ""
  const checks = steps.flatMap(step => (isQuestion(step.kind) ? [] : step.checks))
  const hinted = checks.filter(check => hintsIn(check, language).length > 0)
  return {
    title: said(title),
    idea: said(idea),
    learned: said(learned),
    steps: Object.fromEntries(
      steps.map(({id, kind, say, after, answers}) => {
        const replied = answers.filter(answer => said(answer.reply) !== "")
        const question = {
          answers: Object.fromEntries(answers.map(answer => [answer.id, said(answer.text)])),
          ...(replied.length === 0
            ? {}
            : {replies: Object.fromEntries(replied.map(answer => [answer.id, said(answer.reply)]))}),
        }
        return [
          id,
          {
            say: said(say),
            ...(said(after) === "" ? {} : {after: said(after)}),
            ...(isQuestion(kind) ? question : {}),
          },
        ]
      }),
    ),
    checks: Object.fromEntries(checks.map(check => [check.id, said(check.text)])),
    hints: Object.fromEntries(hinted.map(check => [check.id, hintsIn(check, language)])),
  }
}

/// A hint stands at its place: those before it stay, if empty.
function hintsIn(check: DraftCheck, language: string): readonly string[] {
  const hints = check.hints.map(hint => hint[language] ?? "")
  return hints.slice(0, hints.findLastIndex(hint => hint !== "") + 1)
}

/// The draft of a lesson file; its texts are edited in `language`, or else in English or the first that there is.
export function readDraft(text: string, language: string): ReadDraft {
  const read = readLessonFile(text, language)
  if (read.kind !== "lesson") return read
  try {
    return {kind: "draft", draft: draftDecoder(language)(parseJson(withoutMark(text)), "")}
  } catch (fault) {
    if (fault instanceof Mismatch) return {kind: "damaged", at: fault.path}
    throw fault
  }
}

/// The arguments that the kind of check has.
function argumentsOf(kind: CheckKind, value: unknown, path: string): {readonly [name: string]: Argument} {
  const given = unknownRecord(value, path)
  return Object.fromEntries(
    specsOf(kind).flatMap(([name, {initial}]) => {
      const found = optional(argument, initial)(given[name], `${path}.${name}`)
      return found === undefined ? [] : [[name, found]]
    }),
  )
}

interface WrongAttempt {
  readonly check: string
  readonly program: string
}

const wrongAttempt = object<WrongAttempt>(get => ({
  check: get("check", string),
  program: get("program", string),
}))

/// Of a wrong attempt that names a check which its step does not have.
const idOfCheck: Decoder<never> = (_, path) => {
  throw new Mismatch(path, "the id of a check of this step")
}

function draftDecoder(language: string): Decoder<LessonDraft> {
  return object<LessonDraft>(get => {
    const said = get("texts", record(lessonTexts))
    const languages = Object.keys(said)
    /// A text in the languages that have it.
    const texts = (of: (language: string) => string | undefined): Translations =>
      Object.fromEntries(languages.flatMap(tag => (of(tag) ? [[tag, of(tag) ?? ""]] : [])))
    const checkOf =
      (wrong: readonly WrongAttempt[]): Decoder<DraftCheck> =>
      (value, path) => {
        const {id, kind} = object(of => ({id: of("id", string), kind: of("kind", oneOf(...checkKinds))}))(
          value,
          path,
        )
        const most = Math.max(0, ...languages.map(tag => said[tag]?.hints[id]?.length ?? 0))
        return {
          id,
          kind,
          arguments: argumentsOf(kind, value, path),
          text: texts(tag => said[tag]?.checks[id]),
          hints: Array.from({length: most}, (_, i) => texts(tag => said[tag]?.hints[id]?.[i])),
          wrong: wrong.filter(one => one.check === id).map(one => one.program),
        }
      }
    const step = object<DraftStep>(of => {
      const id = of("id", string)
      const wrong = of("wrong", optional(list(wrongAttempt), []))
      const checks = of("checks", optional(list(checkOf(wrong)), []))
      const stray = wrong.findIndex(one => !checks.some(check => check.id === one.check))
      if (stray >= 0) of(`wrong[${stray}].check`, idOfCheck)
      return {
        id,
        kind: of("kind", oneOf("predict", "run", "investigate", "modify", "make")),
        say: texts(tag => said[tag]?.steps[id]?.say),
        after: texts(tag => said[tag]?.steps[id]?.after),
        seconds: of("seconds", optional(number, 10)),
        checks,
        answers: of("answers", optional(list(string), [])).map(answer => ({
          id: answer,
          text: texts(tag => said[tag]?.steps[id]?.answers[answer]),
          reply: texts(tag => said[tag]?.steps[id]?.replies[answer]),
        })),
        right: of("right", optional(string, null)),
        program: of("program", optional(string, null)),
        hands: of(
          "hands",
          optional(
            list<unknown>(hand => hand),
            [] as readonly unknown[],
          ),
        ),
      }
    })
    return {
      name: get("name", string),
      language: [language, "en"].find(tag => languages.includes(tag)) ?? languages[0] ?? language,
      title: texts(tag => said[tag]?.title),
      idea: texts(tag => said[tag]?.idea),
      learned: texts(tag => said[tag]?.learned),
      room: get("room", unknownRecord) as WorldFile,
      start: get("start", string),
      solution: get("solution", optional(string, null)),
      toolbox: get("toolbox", optional(list(string), null)),
      steps: get("steps", list(step)),
    }
  })
}
