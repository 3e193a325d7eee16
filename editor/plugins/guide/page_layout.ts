/// HTML of a guide page around its content: top bar with search, contents, links to the pages before and after. Plain HTML that can be read without a script.

import {cardsName, posterName} from "./cards_page.ts"
import {escapeHtml} from "./code_block.ts"
import {tablesOf} from "./language_tables.ts"
import {slidesName} from "./slides_page.ts"

/// Addresses of the files that every page loads, from a guide page.
export interface SharedFiles {
  readonly styles: readonly string[]
  readonly script: string
  /// By language.
  readonly searchIndex: Readonly<Record<string, string>>
}

export interface LaidOutPage {
  readonly name: string
  readonly language: string
  readonly title: string
  readonly html: string
}

/// A page as others link to it: its address from a page of the same language, and the language in which it is written.
export interface LinkedPage {
  readonly address: string
  readonly title: string
  readonly language: string
}

/// The guide in one language. A page that is not translated is there in English.
export interface Edition {
  readonly language: string
  readonly chapters: readonly {
    readonly title: string
    readonly folded: boolean
    readonly pages: readonly string[]
  }[]
  readonly pages: ReadonlyMap<string, LinkedPage>
  /// The open page in other languages, by tag.
  readonly alternates: ReadonlyMap<string, string>
  /// From a page of this language to the folder of the guide.
  readonly up: string
}

const icon =
  "data:image/svg+xml,%3Csvg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 26 26'%3E%3Ccircle cx='13' cy='13' r='11' fill='none' stroke='%23d6175a' stroke-width='3'/%3E%3Cpath d='M3 9A11 11 0 0 1 23 9' fill='none' stroke='%23d6175a' stroke-width='5'/%3E%3Ccircle cx='13' cy='15' r='3' fill='%23d6175a'/%3E%3C/svg%3E"

export const pageAddress = (name: string): string => `${name}.html`

export function layOut(page: LaidOutPage, edition: Edition, files: SharedFiles): string {
  const words = tablesOf(edition.language).guide
  const all = edition.chapters.flatMap(chapter => chapter.pages)
  const place = all.indexOf(page.name)
  const link = (name: string | undefined, rel: string, word: string) =>
    name === undefined
      ? ""
      : `<a class="${rel}" rel="${rel}" href="${edition.pages.get(name)?.address}"><small>${word}</small> ${escapeHtml(edition.pages.get(name)?.title ?? name)}</a>`
  const alternates = [...edition.alternates].map(
    ([language, address]) => `<link rel="alternate" hreflang="${language}" href="${address}">`,
  )
  return `<!doctype html>
<html lang="${edition.language}">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<meta name="color-scheme" content="light dark">
<title>${escapeHtml(page.title)} · ${words.brand}</title>
<link rel="icon" href="${icon}">
${[...alternates, ...files.styles.map(address => `<link rel="stylesheet" href="${edition.up}${address}">`)].join("\n")}
<script type="module" src="${edition.up}${files.script}"></script>
</head>
<body>
<a class="skip" href="#content">${words.skip}</a>
<header class="top">
<a class="brand" href="index.html">${words.brand}</a>
<search data-index="${edition.up}${files.searchIndex[edition.language]}" hidden>
<input type="search" id="search" placeholder="${words.search}" aria-label="${words.search}" autocomplete="off" spellcheck="false" aria-controls="found">
<div class="found" id="found" hidden></div>
</search>
<a class="to-rosy" href="${edition.up}../">${words.openRosy}</a>
</header>
<p class="language" id="language" hidden></p>
<div class="columns">
<nav class="contents" aria-label="${words.contents}"><details open><summary>${words.contents}</summary>
${contents(edition, page.name)}
</details></nav>
<main id="content">
${arranged(page)}
<nav class="turn" aria-label="${words.turn}">${link(all[place - 1], "prev", words.before)}${link(all[place + 1], "next", words.next)}</nav>
</main>
</div>
</body>
</html>
`
}

/// Slides, and the pages whose parts stand side by side.
function arranged({name, html}: LaidOutPage): string {
  if (name.startsWith(slidesName(""))) return slides(html)
  return name === cardsName || name === posterName ? `<div class="${name}">${html}</div>` : html
}

/// Each part between two lines across the page fills the window, or a sheet of paper.
const slides = (html: string): string =>
  html
    .split("<hr>")
    .map(slide => `<section class="slide">${slide}</section>`)
    .join("\n")

function contents({language, chapters, pages, alternates}: Edition, open: string): string {
  const item = (name: string) => {
    const page = pages.get(name)
    const current = name === open ? ' aria-current="page"' : ""
    const other =
      page === undefined || page.language === language
        ? ""
        : ` <small>(${tablesOf(language).guide.inEnglish})</small>`
    return `<li><a href="${page?.address}"${current}>${escapeHtml(page?.title ?? name)}${other}</a></li>`
  }
  const languages = [...alternates].map(
    ([tag, address]) =>
      `<li><a href="${address}?lang=${tag}" lang="${tag}" hreflang="${tag}">${tablesOf(tag).guide.readHere}</a></li>`,
  )
  return [
    ...chapters.map(({title, folded, pages: names}) => {
      const list = `<ul>${names.map(item).join("")}</ul>`
      if (!folded) return `<p>${escapeHtml(title)}</p>\n${list}`
      return `<details${names.includes(open) ? " open" : ""}><summary>${escapeHtml(title)}</summary>${list}</details>`
    }),
    ...(languages.length === 0 ? [] : [`<ul class="languages">${languages.join("")}</ul>`]),
  ].join("\n")
}
