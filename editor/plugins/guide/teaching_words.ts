/// Tables of the words of the pages for teachers, and what the checks of lessons say, by language.

import type {Seen} from "../../src/wire/verdict.generated.ts"
import {lessons as lessonsDe} from "../../src/words/de/lessons.ts"
import {teaching as de} from "../../src/words/de/teaching.ts"
import {worksheets as worksheetsDe} from "../../src/words/de/worksheets.ts"
import {lessons as lessonsEn} from "../../src/words/en/lessons.ts"
import {teaching as en, type TeachingWords} from "../../src/words/en/teaching.ts"
import {type WorksheetWords, worksheets as worksheetsEn} from "../../src/words/en/worksheets.ts"
import {lessons as lessonsEs} from "../../src/words/es/lessons.ts"
import {teaching as es} from "../../src/words/es/teaching.ts"
import {worksheets as worksheetsEs} from "../../src/words/es/worksheets.ts"
import {lessons as lessonsFr} from "../../src/words/fr/lessons.ts"
import {teaching as fr} from "../../src/words/fr/teaching.ts"
import {worksheets as worksheetsFr} from "../../src/words/fr/worksheets.ts"
import {lessons as lessonsPt} from "../../src/words/pt/lessons.ts"
import {teaching as pt} from "../../src/words/pt/teaching.ts"
import {worksheets as worksheetsPt} from "../../src/words/pt/worksheets.ts"

/// What the words say of one lesson.
export interface TeachingWordsOfLesson {
  readonly often: string
  readonly ask: readonly string[]
}

/// The words of the lesson panel that the pages repeat.
export interface PanelWords {
  readonly courses: Readonly<Record<string, string>>
  readonly kinds: Readonly<Record<string, string>>
  readonly seen: Readonly<Record<string, (n: number | null, time: number | null, name: string) => string>>
}

const tables: Readonly<Record<string, TeachingWords>> = {en, de, es, fr, pt}
const panels: Readonly<Record<string, PanelWords>> = {
  en: lessonsEn,
  de: lessonsDe,
  es: lessonsEs,
  fr: lessonsFr,
  pt: lessonsPt,
}

const worksheetTables: Readonly<Record<string, WorksheetWords>> = {
  en: worksheetsEn,
  de: worksheetsDe,
  es: worksheetsEs,
  fr: worksheetsFr,
  pt: worksheetsPt,
}

export const worksheetWords = (language: string): WorksheetWords => worksheetTables[language] ?? worksheetsEn

export const teachingLanguages: readonly string[] = Object.keys(tables)

/// English for a language without a table.
export const teachingWords = (language: string): TeachingWords => tables[language] ?? en

export const panelWords = (language: string): PanelWords => panels[language] ?? lessonsEn

/// The sentence of the lesson panel. A goal is named by its check, whose text is in the reader's language.
export function seenSentence({what, time, number, name}: Seen, check: string, language: string): string {
  const say = panelWords(language).seen[what]
  if (say === undefined) throw new Error(`expected a sentence for "${what}", found none in ${language}`)
  return say(number, time, what.startsWith("goal-") ? check : (name ?? ""))
}
