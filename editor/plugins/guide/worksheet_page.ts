/// Worksheet of a lesson for paper: the lesson's program and its two questions, tasks, and on a second sheet the answers and an activity without a computer.

import type {WorksheetWords} from "./language_tables.ts"
import {code} from "./lesson_page.ts"
import type {LessonSource, LessonTexts} from "./lesson_source.ts"
import {worksheetWords} from "./teaching_words.ts"

export function worksheetPage(lesson: LessonSource, language: string): string {
  const {labels, sheets} = worksheetWords(language)
  const texts = lesson.texts(language)
  const {tasks, unplugged} = sheets[lesson.name] as WorksheetWords["sheets"][string]
  const questions = lesson.steps.filter(step => step.right !== null)
  const textsOf = (step: {readonly id: string}) => texts.steps[step.id] as LessonTexts["steps"][string]
  const rightOf = (step: (typeof questions)[number]) => textsOf(step).answers?.[step.right ?? ""] ?? ""
  return [
    `# ${labels.sheet(texts.title)}`,
    `${labels.name} ${line}`,
    code(lesson.start),
    ...questions.flatMap((step, i) => [
      `**${i + 1}.** ${textsOf(step).say}`,
      choices(Object.values(textsOf(step).answers ?? {})),
    ]),
    ...tasks.flatMap(({say}, i) => [`**${questions.length + i + 1}.** ${say}`, `${labels.answer} ${line}`]),
    "---",
    `## ${labels.forTeachers}`,
    [...questions.map(rightOf), ...tasks.map(task => task.answer)]
      .map((answer, i) => `${i + 1}. ${answer}`)
      .join("\n"),
    `## ${labels.unplugged(unplugged.title)}`,
    unplugged.steps.map((step, i) => `${i + 1}. ${step}`).join("\n"),
    `[](teach-${lesson.name}.md)`,
  ].join("\n\n")
}

/// A line to write on.
export const line = "………………………………………………………………"

/// Answers to tick, each on a line of its own.
export const choices = (answers: readonly string[]): string =>
  answers.map((answer, i) => `☐ **${letter(i)}** ${answer}`).join("  \n")

export const letter = (i: number): string => String.fromCharCode("a".charCodeAt(0) + i)
