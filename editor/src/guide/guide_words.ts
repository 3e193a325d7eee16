/// Tables of the words around the guide's pages. The build and the script of a page read them, so they import nothing else.

import {guide as de} from "../words/de/guide.ts"
import {guide as en, type GuideWords} from "../words/en/guide.ts"
import {guide as es} from "../words/es/guide.ts"
import {guide as fr} from "../words/fr/guide.ts"
import {guide as pt} from "../words/pt/guide.ts"

export type {GuideWords}

const guideLanguages: Readonly<Record<string, GuideWords>> = {en, de, es, fr, pt}

/// English for a language without a table.
export const guideWords = (language: string): GuideWords => guideLanguages[language] ?? en
