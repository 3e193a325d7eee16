/// Pages for teachers that are made while the guide is built: from the lessons' own data, the toolbox and the
/// curricula, and from one table of words per language.
///
/// A page is Markdown and has a place in `docs/teaching/made/`, where no file is: other pages link to it there.

import {cardsName, cardsPage, posterName, posterPage} from "./cards_page.ts"
import {curriculaPage, readCurricula} from "./curricula_page.ts"
import {tags} from "./language_tables.ts"
import {lessonPage} from "./lesson_page.ts"
import {type LessonSource, readLessons} from "./lesson_source.ts"
import {planPage} from "./plan_page.ts"
import {slidesName, slidesPage} from "./slides_page.ts"
import {worksheetWords} from "./teaching_words.ts"
import {readTerm} from "./term.ts"
import {worksheetPage} from "./worksheet_page.ts"
import {readKey, writtenTestPage} from "./written_test_page.ts"

export interface MadePage {
  /// Name of the page's address, without `.html`.
  readonly name: string
  text(language: string): string
}

const folder = "docs/teaching/made/"

export const madeFile = (name: string): string => `${folder}${name}.md`

/// Sets of pages, by the name that `docs/contents.json` gives them.
export type MadePages = Readonly<Record<string, readonly MadePage[]>>

export function madePages(root: string): MadePages {
  const lessons = readLessons(root)
  const term = readTerm(root)
  const curricula = readCurricula(root)
  const page = (name: string, text: (language: string) => string): MadePage => ({
    name,
    text: language => withTitles(text(language), lessons, language),
  })
  return {
    plan: [page("plan", language => planPage(lessons, term, language))],
    curricula: [page("curricula", language => curriculaPage(curricula, language))],
    cards: [page(cardsName, cardsPage), page(posterName, posterPage)],
    worksheets: lessons
      .filter(({name}) => name in worksheetWords("en").sheets)
      .map(lesson => page(`sheet-${lesson.name}`, language => worksheetPage(lesson, language))),
    tests: Object.entries(readKey(root)).map(([name, key]) =>
      page(`test-${name}`, language => writtenTestPage(name, key, language)),
    ),
    slides: [...new Set(lessons.map(lesson => lesson.course))].map(course =>
      page(slidesName(course), language =>
        slidesPage(
          course,
          lessons.filter(lesson => lesson.course === course),
          language,
        ),
      ),
    ),
    lessons: lessons.map(lesson =>
      page(`teach-${lesson.name}`, language => lessonPage(lesson, term, language)),
    ),
  }
}

/// The text of a made page by its path, in English or below the folder of a language; `null` for another path.
export function madeText(pages: MadePages, file: string): string | null {
  const found = /^docs\/(?:([a-z]{2})\/)?teaching\/made\/([\w-]+)\.md$/.exec(file)
  const page = Object.values(pages)
    .flat()
    .find(one => one.name === found?.[2])
  return page?.text(found?.[1] ?? "en") ?? null
}

export const isMadeIn = (file: string, language: string): boolean =>
  file.startsWith(folder) && tags.includes(language)

/// A link to the page of a lesson that has no words gets the title of the lesson.
function withTitles(text: string, lessons: readonly LessonSource[], language: string): string {
  return text.replace(/\[\]\(([^)]*teach-([\w-]+)\.md)\)/g, (_, target: string, name: string) => {
    const lesson = lessons.find(one => one.name === name)
    return `[${lesson?.texts(language).title ?? name}](${target})`
  })
}
