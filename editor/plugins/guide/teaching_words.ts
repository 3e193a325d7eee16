/// Words of the pages for teachers, and what the checks of lessons say, by language.

import type {Seen} from "../../src/wire/verdict.generated.ts"
import {type PanelWords, type TeachingWords, tablesOf, type WorksheetWords} from "./language_tables.ts"

/// What the words say of one lesson.
export interface TeachingWordsOfLesson {
  readonly often: string
  readonly ask: readonly string[]
}

export const worksheetWords = (language: string): WorksheetWords => tablesOf(language).worksheets

export const teachingWords = (language: string): TeachingWords => tablesOf(language).teaching

export const panelWords = (language: string): PanelWords => tablesOf(language).lessons

/// The sentence of the lesson panel. A goal is named by its check, whose text is in the reader's language.
export function seenSentence({what, time, number, name}: Seen, check: string, language: string): string {
  const say = panelWords(language).seen[what]
  if (say === undefined) throw new Error(`expected a sentence for "${what}", found none in ${language}`)
  return say(number, time, what.startsWith("goal-") ? check : (name ?? ""))
}
