/// Contents of the guide: its chapters and their pages in reading order, read from `docs/contents.json`.

import {existsSync, readdirSync, readFileSync} from "node:fs"
import {join} from "node:path"

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
  file.startsWith("docs/") && existsSync(join(root, translatedFile(file, language)))

/// Path from the root of the repository.
export const contentsFile = "docs/contents.json"

export function readContents(root: string): readonly Chapter[] {
  const read: unknown = JSON.parse(readFileSync(join(root, contentsFile), "utf8"))
  const {chapters} = read as {readonly chapters: readonly Chapter[]}
  const names = chapters.flatMap(chapter => chapter.pages.map(page => page.name))
  const twice = names.find((name, i) => names.indexOf(name) !== i || !/^[a-z][a-z0-9-]*$/.test(name))
  if (twice !== undefined) throw new Error(`${contentsFile}: "${twice}" is no name, or stands there twice`)
  return chapters
}
