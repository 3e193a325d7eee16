/// Site of the guide: all pages of the contents, converted, with links and pictures resolved.
///
/// In: the root of the repository. Out: the pages, the search index, the pictures, and a list of faults; a guide with a fault is not built.

import {existsSync, readFileSync} from "node:fs"
import {basename, dirname, join, normalize} from "node:path"
import {fragmentOf} from "../../src/browser/share_link.ts"
import type {SearchEntry} from "../../src/guide/search.ts"
import {type Chapter, isTranslated, readContents, translatedFile, translations} from "./contents.ts"
import {tablesOf} from "./language_tables.ts"
import {type ConvertedPage, convertMarkdown, type Resolver} from "./markdown.ts"
import {type Edition, layOut, pageAddress, type SharedFiles} from "./page_layout.ts"
import {pictureSize} from "./picture_size.ts"

export interface Site {
  readonly chapters: readonly Chapter[]
  /// The Markdown of a page.
  textOf(file: string): string
  /// By language. A page that is not translated is found in English.
  readonly searchIndex: ReadonlyMap<string, readonly SearchEntry[]>
  /// Paths of the pictures from the root of the repository.
  readonly pictures: readonly string[]
  readonly faults: readonly string[]
  /// The HTML of each page, by its name, behind its language if that is not English: `why`, `de/why`. `pictureAddress` gives the address of a picture by its path.
  html(files: SharedFiles, pictureAddress: (path: string) => string): ReadonlyMap<string, string>
}

/// A Markdown file of the guide and the page that it becomes.
interface Source {
  readonly file: string
  readonly name: string
  readonly language: string
}

/// Pages of the service beside the guide, written `rosy:ADDRESS` in a link.
const besideGuide = /^rosy:(api-docs\/Rosy\.html|prelude\.html|\?example=\w+|)(?:#(.*))?$/

/// The address of a picture until the build has named its file.
const pictureMark = (path: string) => `picture:${path}`

/// The Markdown files of the guide.
interface Sources {
  readonly english: readonly Source[]
  /// Those that the guide is translated into.
  readonly languages: readonly string[]
  /// In all languages.
  readonly all: readonly Source[]
}

/// The guide with its pages converted, by their Markdown files.
interface ConvertedGuide extends Sources {
  readonly chapters: readonly Chapter[]
  readonly pages: ReadonlyMap<string, ConvertedPage>
}

export async function readSite(root: string): Promise<Site> {
  const {chapters, textOf} = readContents(root)
  const sources = sourcesOf(root, chapters)
  const texts = new Map(sources.all.map(({file}) => [file, textOf(file)]))
  const references = openReferences(root, sources.all, await openAddresses([...texts.values()]))
  const pages = new Map<string, ConvertedPage>(
    sources.all.map(source => [
      source.file,
      convertMarkdown(
        texts.get(source.file) ?? "",
        references.resolverOf(source),
        tablesOf(source.language).guide,
      ),
    ]),
  )
  const guide: ConvertedGuide = {...sources, chapters, pages}
  return {
    chapters,
    textOf,
    searchIndex: searchIndexOf(guide),
    pictures: [...references.pictures],
    faults: [
      ...[...pages].flatMap(([file, page]) => page.faults.map(fault => `${file}: ${fault}`)),
      ...references.faults(pages),
    ],
    html: (files, pictureAddress) => htmlOf(guide, files, pictureAddress),
  }
}

function sourcesOf(root: string, chapters: readonly Chapter[]): Sources {
  const english: readonly Source[] = chapters.flatMap(chapter =>
    chapter.pages.map(page => ({...page, language: "en"})),
  )
  const languages = translations(root)
  const translated = languages.flatMap(language =>
    english
      .filter(({file}) => isTranslated(root, file, language))
      .map(({file, name}) => ({file: translatedFile(file, language), name, language})),
  )
  return {english, languages, all: [...english, ...translated]}
}

/// What the pages refer to: other pages, pictures and programs, by their `addresses`. Pictures and links into pages are collected while pages are converted.
function openReferences(root: string, sources: readonly Source[], addresses: ReadonlyMap<string, string>) {
  const byFile = new Map(sources.map(source => [source.file, source]))
  const pictures = new Set<string>()
  /// Links into pages, which are checked when all pages are converted.
  const anchored: {from: string; to: string; anchor: string}[] = []

  const resolverOf = ({file, language}: Source): Resolver => {
    const up = upFrom(language)
    /// What is not there in this language is there in English.
    const orEnglish = (path: string, exists: (one: string) => boolean) =>
      exists(path) ? path : path.replace(`docs/${language}/`, "docs/")
    return {
      link(target) {
        if (besideGuide.test(target))
          return {kind: "page", address: `${up}../${target.slice("rosy:".length)}`}
        const [path = "", anchor = ""] = target.split("#")
        const wanted = path === "" ? file : normalize(join(dirname(file), path))
        const to = orEnglish(wanted, one => byFile.has(one))
        const found = byFile.get(to)
        if (found === undefined)
          return existsSync(
            join(
              root,
              orEnglish(wanted, one => existsSync(join(root, one))),
            ),
          )
            ? {kind: "words"}
            : null
        if (anchor !== "") anchored.push({from: file, to, anchor})
        return {kind: "page", address: addressFrom(language, found) + (anchor === "" ? "" : `#${anchor}`)}
      },
      picture(target) {
        const path = orEnglish(normalize(join(dirname(file), target)), one => existsSync(join(root, one)))
        const still = path.endsWith(".svg") ? path.replace(/\.svg$/, "-still.svg") : null
        const files = [path, ...(still === null ? [] : [still])]
        if (!files.every(file => existsSync(join(root, file)))) return null
        for (const file of files) pictures.add(file)
        const size = pictureSize(path, readFileSync(join(root, path)))
        return {address: pictureMark(path), still: still === null ? null : pictureMark(still), ...size}
      },
      openAddress: (program, room) => `${up}../${addresses.get(projectOf(program, room)) ?? ""}`,
    }
  }
  return {
    resolverOf,
    pictures,
    /// Links to places in pages that are not there.
    faults: (pages: ReadonlyMap<string, ConvertedPage>): readonly string[] =>
      anchored
        .filter(({to, anchor}) => pages.get(to)?.anchors.has(anchor) !== true)
        .map(({from, to, anchor}) => `${from}: links to ${to}#${anchor}, which does not exist`),
  }
}

/// The page of a name in a language, else in English.
function sourceOf({all}: Sources, name: string, language: string): Source {
  const found = all.filter(source => source.name === name)
  return (found.find(source => source.language === language) ?? found[0]) as Source
}

function editionOf(guide: ConvertedGuide, {name, language}: Source): Edition {
  return {
    language,
    up: upFrom(language),
    chapters: guide.chapters.map(({title, translated, folded = false, pages: inside}) => ({
      folded,
      title: translated?.[language] ?? title,
      pages: inside.map(page => page.name),
    })),
    pages: new Map(
      guide.english.map(page => {
        const source = sourceOf(guide, page.name, language)
        const title = guide.pages.get(source.file)?.title ?? page.name
        return [page.name, {title, address: addressFrom(language, source), language: source.language}]
      }),
    ),
    alternates: new Map(
      guide.all
        .filter(source => source.name === name && source.language !== language)
        .map(source => [source.language, addressFrom(language, source)]),
    ),
  }
}

function searchIndexOf(guide: ConvertedGuide): Site["searchIndex"] {
  return new Map(
    ["en", ...guide.languages].map(language => [
      language,
      guide.english.flatMap(({name}) => {
        const source = sourceOf(guide, name, language)
        const {title, sections} = guide.pages.get(source.file) as ConvertedPage
        const page = addressFrom(language, source)
        return sections.map(({anchor, heading, text}) => ({page, title, anchor, heading, text}))
      }),
    ]),
  )
}

function htmlOf(
  guide: ConvertedGuide,
  files: SharedFiles,
  pictureAddress: (path: string) => string,
): ReadonlyMap<string, string> {
  return new Map(
    guide.all.map(source => {
      const {name, language} = source
      const {title, html} = guide.pages.get(source.file) as ConvertedPage
      const shown = html.replace(
        /(src|srcset)="picture:([^"]+)/g,
        (_, attribute: string, path: string) => `${attribute}="${upFrom(language)}${pictureAddress(path)}`,
      )
      return [
        language === "en" ? name : `${language}/${name}`,
        layOut({name, language, title, html: shown}, editionOf(guide, source), files),
      ]
    }),
  )
}

/// From a page of a language to the folder of the guide.
const upFrom = (language: string): string => (language === "en" ? "" : "../")

/// The address of a page from a page of this language.
const addressFrom = (language: string, {name, language: written}: Source): string =>
  language === written
    ? pageAddress(name)
    : `${upFrom(language)}${written === "en" ? "" : `${written}/`}${pageAddress(name)}`

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
