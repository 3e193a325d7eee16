/// Contents of the guide: its chapters and their pages in reading order, read from `docs/contents.json`. A line `{"made": "lessons"}` stands
/// for a set of pages that are made from the lessons' data.

import {existsSync, readdirSync, readFileSync} from "node:fs"
import {join} from "node:path"
import {isMadeIn, type MadePages, madeFile, madePages, madeText} from "./made_pages.ts"

/// A page that is written in a Markdown file of the repository.
export interface SourcePage {
  /// Path of the Markdown file from the root of the repository.
  readonly file: string
  /// Name of the page's address, without `.html`.
  readonly name: string
}

export interface Chapter {
  readonly title: string
  /// Its title in other languages, by tag.
  readonly translated?: Readonly<Record<string, string>>
  /// Its pages are shown in the contents when one of them is open, else when the reader asks.
  readonly folded?: boolean
  readonly pages: readonly SourcePage[]
}

/// Where a page of `docs` is in another language: `docs/why.md` in `docs/de/why.md`.
export const translatedFile = (file: string, language: string): string =>
  file.replace(/^docs\//, `docs/${language}/`)

/// The languages besides English in which at least one page is written: the folders of `docs` that are named like one.
export function translations(root: string): readonly string[] {
  return readdirSync(join(root, "docs"), {withFileTypes: true})
    .filter(one => one.isDirectory() && /^[a-z]{2}$/.test(one.name))
    .map(one => one.name)
}

export const isTranslated = (root: string, file: string, language: string): boolean =>
  isMadeIn(file, language) ||
  (file.startsWith("docs/") && existsSync(join(root, translatedFile(file, language))))

/// Path from the root of the repository.
export const contentsFile = "docs/contents.json"

export interface Contents {
  readonly chapters: readonly Chapter[]
  /// The Markdown of a page.
  textOf(file: string): string
}

interface WrittenChapter extends Omit<Chapter, "pages"> {
  readonly pages: readonly (SourcePage | {readonly made: string})[]
}

export function readContents(root: string): Contents {
  const read: unknown = JSON.parse(readFileSync(join(root, contentsFile), "utf8"))
  const made = madePages(root)
  const chapters = (read as {readonly chapters: readonly WrittenChapter[]}).chapters.map(chapter => ({
    ...chapter,
    pages: chapter.pages.flatMap(page => ("made" in page ? setOf(made, page.made) : [page])),
  }))
  const names = chapters.flatMap(chapter => chapter.pages.map(page => page.name))
  const twice = names.find((name, i) => names.indexOf(name) !== i || !/^[a-z][a-z0-9-]*$/.test(name))
  if (twice !== undefined) throw new Error(`${contentsFile}: "${twice}" is no name, or stands there twice`)
  return {chapters, textOf: file => madeText(made, file) ?? readFileSync(join(root, file), "utf8")}
}

function setOf(made: MadePages, name: string): readonly SourcePage[] {
  const pages = made[name]
  if (pages === undefined) throw new Error(`${contentsFile}: there is no set of made pages called "${name}"`)
  return pages.map(page => ({file: madeFile(page.name), name: page.name}))
}
