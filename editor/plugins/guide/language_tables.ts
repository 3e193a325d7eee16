/// Tables of the registered languages that the build of the guide reads: around its pages, on pages for teachers, on paper and on blocks.
///
/// They are imported by path: the build bundles what is imported by path, and leaves packages to Node, which cannot load TypeScript.
/// Its bundler takes every folder that a path with a variable can name.

import type {Words as WordsOnBlocks} from "../../../codegen/src/words/index.ts"
import {en as blocks} from "../../../languages/en/blocks/index.ts"
import {type GuideWords, guide} from "../../../languages/en/page/guide.ts"
import {lessons} from "../../../languages/en/page/lessons.ts"
import {type TeachingWords, teaching} from "../../../languages/en/page/teaching.ts"
import {type WorksheetWords, worksheets} from "../../../languages/en/page/worksheets.ts"
import registered from "../../../languages/languages.json"

/// The words of the lesson panel that the pages repeat.
export interface PanelWords {
  readonly courses: Readonly<Record<string, string>>
  readonly kinds: Readonly<Record<string, string>>
  readonly seen: Readonly<Record<string, (n: number | null, time: number | null, name: string) => string>>
}

export interface LanguageTables {
  readonly guide: GuideWords
  readonly teaching: TeachingWords
  readonly worksheets: WorksheetWords
  readonly lessons: PanelWords
  readonly blocks: WordsOnBlocks
}

const english: LanguageTables = {guide, teaching, worksheets, lessons, blocks}

async function read(tag: string): Promise<LanguageTables> {
  if (tag === "en") return english
  const [{guide}, {teaching}, {worksheets}, {lessons}, {table}] = await Promise.all([
    import(`../../../languages/${tag}/page/guide.ts`),
    import(`../../../languages/${tag}/page/teaching.ts`),
    import(`../../../languages/${tag}/page/worksheets.ts`),
    import(`../../../languages/${tag}/page/lessons.ts`),
    import(`../../../languages/${tag}/blocks/index.ts`),
  ])
  return {guide, teaching, worksheets, lessons, blocks: table}
}

export const tags: readonly string[] = Object.keys(registered)

const tables = new Map(await Promise.all(tags.map(async tag => [tag, await read(tag)] as const)))

/// English for a language without tables.
export const tablesOf = (language: string): LanguageTables => tables.get(language) ?? english

export type {GuideWords, TeachingWords, WorksheetWords}
