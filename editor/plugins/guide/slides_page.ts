/// Slides of a course of lessons, for the projector: of each lesson its idea, its program with the question to guess, the question to look
/// closely at, and the goal. A line across the page begins a slide; all words are the lessons' own.

import {code} from "./lesson_page.ts"
import type {LessonSource, LessonStep, LessonTexts} from "./lesson_source.ts"
import {panelWords, worksheetWords} from "./teaching_words.ts"
import {choices} from "./worksheet_page.ts"

/// Lines of a program that fit on a slide.
const linesShown = 18

export const slidesName = (course: string): string => `slides-${course}`

export function slidesPage(course: string, lessons: readonly LessonSource[], language: string): string {
  const {courses} = panelWords(language)
  const titles = lessons.map(lesson => `- ${lesson.number}. ${lesson.texts(language).title}`)
  const first = [`# ${worksheetWords(language).labels.slides(courses[course] ?? course)}`, titles.join("\n")]
  return [first.join("\n\n"), ...lessons.flatMap(lesson => slidesOf(lesson, language))].join("\n\n---\n\n")
}

function slidesOf(lesson: LessonSource, language: string): readonly string[] {
  const {kinds} = panelWords(language)
  const texts = lesson.texts(language)
  const textsOf = (step: LessonStep) => texts.steps[step.id] as LessonTexts["steps"][string]
  const asked = (kind: LessonStep["kind"]) => lesson.steps.find(step => step.kind === kind)
  const slide = (step: LessonStep | undefined, program: string | null): readonly string[] => {
    if (step === undefined) return []
    const {say, answers} = textsOf(step)
    const shown = program !== null && program.split("\n").length <= linesShown ? [code(program)] : []
    const ticked = answers === undefined ? [] : [choices(Object.values(answers))]
    return [[`## ${kinds[step.kind]?.trim()}`, say, ...shown, ...ticked].join("\n\n")]
  }
  return [
    `## ${lesson.number}. ${texts.title}\n\n${texts.idea}`,
    ...slide(asked("predict"), lesson.start),
    ...slide(asked("investigate"), null),
    ...slide(lesson.steps.at(-1), null),
    `## ${lesson.number}. ${texts.title}\n\n${texts.learned}`,
  ]
}
