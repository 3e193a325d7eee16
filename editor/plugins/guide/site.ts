/// Site of the guide: all pages of the contents, converted, with links and pictures resolved.
///
/// In: the root of the repository. Out: the pages, the search index, the pictures, and a list of faults; a guide with a fault is not built.

import {existsSync, readFileSync} from "node:fs"
import {basename, dirname, join, normalize} from "node:path"
import {fragmentOf} from "../../src/browser/share_link.ts"
import type {SearchEntry} from "../../src/guide/search.ts"
import {type Chapter, readContents} from "./contents.ts"
import {type ConvertedPage, convertMarkdown, type Resolver} from "./markdown.ts"
import {type LaidOutPage, layOut, pageAddress, type SharedFiles} from "./page_layout.ts"
import {pngSize} from "./png_size.ts"

export interface Site {
  readonly chapters: readonly Chapter[]
  readonly searchIndex: readonly SearchEntry[]
  /// Paths of the pictures from the root of the repository.
  readonly pictures: readonly string[]
  readonly faults: readonly string[]
  /// The HTML of each page, by its name; `pictureAddress` gives the address of a picture by its path.
  html(files: SharedFiles, pictureAddress: (path: string) => string): ReadonlyMap<string, string>
}

/// Pages of the service beside the guide, written `rosy:ADDRESS` in a link.
const besideGuide = /^rosy:(api-docs\/Rosy\.html|prelude\.html|\?example=\w+|)(?:#(.*))?$/

/// The address of a picture until the build has named its file.
const pictureMark = (path: string) => `picture:${path}`

export async function readSite(root: string): Promise<Site> {
  const chapters = readContents(root)
  const sources = chapters.flatMap(chapter => chapter.pages)
  const nameOf = new Map(sources.map(({file, name}) => [file, name]))
  const texts = new Map(sources.map(({file}) => [file, readFileSync(join(root, file), "utf8")]))
  const addresses = await openAddresses([...texts.values()])
  const pictures = new Set<string>()
  /// Links into pages, which are checked when all pages are converted.
  const anchored: {from: string; to: string; anchor: string}[] = []

  const resolverOf = (file: string): Resolver => ({
    link(target) {
      if (besideGuide.test(target)) return {kind: "page", address: `../${target.slice("rosy:".length)}`}
      const [path = "", anchor = ""] = target.split("#")
      const to = path === "" ? file : normalize(join(dirname(file), path))
      const name = nameOf.get(to)
      if (name === undefined) return existsSync(join(root, to)) ? {kind: "words"} : null
      if (anchor !== "") anchored.push({from: file, to, anchor})
      return {kind: "page", address: pageAddress(name) + (anchor === "" ? "" : `#${anchor}`)}
    },
    picture(target) {
      const path = normalize(join(dirname(file), target))
      if (!existsSync(join(root, path))) return null
      pictures.add(path)
      // Pictures are taken with two pixels per CSS pixel.
      const {width, height} = pngSize(readFileSync(join(root, path)))
      return {address: pictureMark(path), width: Math.round(width / 2), height: Math.round(height / 2)}
    },
    openAddress: (program, room) => `../${addresses.get(projectOf(program, room)) ?? ""}`,
  })

  const pages = new Map<string, ConvertedPage>(
    sources.map(({file}) => [file, convertMarkdown(texts.get(file) ?? "", resolverOf(file))]),
  )
  const titles = new Map(sources.map(({file, name}) => [name, pages.get(file)?.title ?? name]))
  const faults = [...pages].flatMap(([file, page]) => page.faults.map(fault => `${file}: ${fault}`))
  for (const {from, to, anchor} of anchored)
    if (pages.get(to)?.anchors.has(anchor) !== true)
      faults.push(`${from}: links to ${to}#${anchor}, which does not exist`)

  return {
    chapters,
    searchIndex: sources.flatMap(({file, name}) => {
      const {title, sections} = pages.get(file) as ConvertedPage
      return sections.map(({anchor, heading, text}) => ({
        page: pageAddress(name),
        title,
        anchor,
        heading,
        text,
      }))
    }),
    pictures: [...pictures],
    faults,
    html: (files, pictureAddress) =>
      new Map(
        sources.map(({file, name}) => {
          const {title, html} = pages.get(file) as ConvertedPage
          const shown = html.replace(
            /src="picture:([^"]+)"/g,
            (_, path: string) => `src="${pictureAddress(path)}"`,
          )
          const page: LaidOutPage = {name, title, html: shown}
          return [name, layOut(page, chapters, titles, files)]
        }),
      ),
  }
}

/// A project file (protocol §5) without blocks: the page makes them.
function projectOf(program: string, room: string): string {
  const named = /^main\b/m.test(program) ? (/simulate \(?(\w+)/.exec(program)?.[1] ?? "program") : "program"
  return JSON.stringify({
    rosy: 1,
    name: named,
    haskell: program,
    layout: {declarations: [], loose: []},
    world: room,
  })
}

/// The links that open the programs of Markdown texts, by their projects.
async function openAddresses(texts: readonly string[]): Promise<ReadonlyMap<string, string>> {
  const found = new Map<string, string>()
  const collect: Resolver = {
    link: () => ({kind: "words"}),
    picture: () => null,
    openAddress(program, room) {
      found.set(projectOf(program, room), "")
      return ""
    },
  }
  for (const text of texts) convertMarkdown(text, collect)
  for (const project of found.keys()) found.set(project, await fragmentOf(project))
  return found
}

/// The name of a picture's file, for the build.
export const pictureName = (path: string): string => `guide-${basename(path)}`
