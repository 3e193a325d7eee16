/// Contents of the guide: its chapters and their pages in reading order, read from `docs/contents.json`.

import {readFileSync} from "node:fs"
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
  readonly pages: readonly SourcePage[]
}

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
