/// Map from what curricula ask for to the lessons: of each document the statements that were found, quoted in their own language.
///
/// In: `docs/teaching/curricula.json`. A statement that cannot be cited is not there; the page says of which document some are missing.

import {readFileSync} from "node:fs"
import {join} from "node:path"
import type {TeachingWords} from "./language_tables.ts"
import {inTable} from "./lesson_page.ts"
import {teachingWords} from "./teaching_words.ts"

/// A document of a country or a state.
export interface Curriculum {
  readonly id: keyof TeachingWords["curricula"]["places"]
  /// Language of its statements.
  readonly language: keyof typeof quotationMarks
  /// Who published it, its name and its year.
  readonly source: string
  readonly statements: readonly Statement[]
  /// Some of its statements about programming could not be cited.
  readonly incomplete?: true
}

export interface Statement {
  readonly section: string
  readonly text: string
  /// Names of lessons.
  readonly lessons: readonly string[] | "all"
  /// The lessons do not teach all that it asks for.
  readonly part?: true
}

const quotationMarks = {
  de: ["„", "“"],
  en: ["“", "”"],
  es: ["«", "»"],
  fr: ["«\u202F", "\u202F»"],
  pt: ["«", "»"],
} as const

export const readCurricula = (root: string): readonly Curriculum[] =>
  JSON.parse(readFileSync(join(root, "docs/teaching/curricula.json"), "utf8")) as readonly Curriculum[]

export function quoted(text: string, language: Curriculum["language"]): string {
  const [before, after] = quotationMarks[language]
  return `${before}${text}${after}`
}

/// The documents in the reader's language come first.
export function curriculaPage(curricula: readonly Curriculum[], language: string): string {
  const {curricula: words} = teachingWords(language)
  const row = ({section, text, lessons, part}: Statement, written: Curriculum["language"]) => {
    const links = lessons === "all" ? words.all : lessons.map(name => `[](teach-${name}.md)`).join(", ")
    return `| ${section} | ${inTable(quoted(text, written))} | ${links}${part ? ` *${words.part}*` : ""} |`
  }
  const sections = [
    ...curricula.filter(one => one.language === language),
    ...curricula.filter(one => one.language !== language),
  ].flatMap(({id, language: written, source, statements, incomplete}) => [
    `## ${words.places[id]}`,
    `*${source}*`,
    [
      `| ${words.columns.join(" | ")} |`,
      `|${words.columns.map(() => "---|").join("")}`,
      ...statements.map(one => row(one, written)),
    ].join("\n"),
    ...(incomplete === undefined ? [] : [words.incomplete]),
  ])
  return [`# ${words.title}`, words.lead, ...sections].join("\n\n")
}
