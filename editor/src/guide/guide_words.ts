/// Tables of the words around the guide's pages. The script of a page reads them, so they import nothing else.

import {guide as en, type GuideWords} from "../../../languages/en/page/guide.ts"

const tables = import.meta.glob<GuideWords>("../../../languages/*/page/guide.ts", {
  import: "guide",
  eager: true,
})

/// English for a language without a table.
export const guideWords = (language: string): GuideWords =>
  tables[`../../../languages/${language}/page/guide.ts`] ?? en
