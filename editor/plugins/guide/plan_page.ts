/// Plan of a term: a table of weeks with the lessons, what they are about (the lessons' own words), and what to prepare.

import type {LessonSource} from "./lesson_source.ts"
import {teachingWords, worksheetWords} from "./teaching_words.ts"
import {minutesOf, type Term} from "./term.ts"

export function planPage(lessons: readonly LessonSource[], term: Term, language: string): string {
  const {plan} = teachingWords(language)
  const {labels} = worksheetWords(language)
  const rows = term.weeks.map(({lessons: names, page, test}, i) => {
    const inWeek = lessons.filter(lesson => names.includes(lesson.name))
    const links = inWeek.map(lesson => `[](teach-${lesson.name}.md) (${minutesOf(lesson, term)} min)`)
    const ideas = inWeek.map(lesson => lesson.texts(language).idea)
    const sheets = inWeek.filter(({name}) => name in worksheetWords(language).sheets)
    const together = [
      ...(page === undefined ? [] : [`[${plan.handbook}](../${page})`]),
      ...sheets.map(lesson => `[${labels.sheet(lesson.texts(language).title)}](sheet-${lesson.name}.md)`),
      ...(test === undefined ? [] : [`[${labels.test(test)}](test-${test}.md)`]),
    ]
    return `| ${i + 1} | ${links.join(", ")} | ${ideas.join(" ")} | ${plan.weeks[i] ?? ""} | ${together.join(", ")} |`
  })
  return [
    `# ${plan.title}`,
    plan.lead,
    [`| ${plan.columns.join(" | ")} |`, `|${plan.columns.map(() => "---|").join("")}`, ...rows].join("\n"),
    ...term.strands.map(({course, from, page}) => {
      const links = lessons
        .filter(lesson => lesson.course === course)
        .map(lesson => `[](teach-${lesson.name}.md) (${minutesOf(lesson, term)} min)`)
      return `${plan.strand(`../${page}`, from)} ${links.join(", ")}.`
    }),
    plan.after(`../${term.projects}`),
  ].join("\n\n")
}
