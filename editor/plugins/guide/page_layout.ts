/// HTML of a guide page around its content: top bar with search, contents, links to the pages before and after. Plain HTML that can be read without a script.

import {escapeHtml} from "./code_block.ts"
import type {Chapter} from "./contents.ts"

/// Addresses of the files that every page loads, from a guide page.
export interface SharedFiles {
  readonly styles: readonly string[]
  readonly script: string
  readonly searchIndex: string
}

export interface LaidOutPage {
  readonly name: string
  readonly title: string
  readonly html: string
}

const icon =
  "data:image/svg+xml,%3Csvg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 26 26'%3E%3Ccircle cx='13' cy='13' r='11' fill='none' stroke='%23d6175a' stroke-width='3'/%3E%3Cpath d='M3 9A11 11 0 0 1 23 9' fill='none' stroke='%23d6175a' stroke-width='5'/%3E%3Ccircle cx='13' cy='15' r='3' fill='%23d6175a'/%3E%3C/svg%3E"

export const pageAddress = (name: string): string => `${name}.html`

export function layOut(
  page: LaidOutPage,
  chapters: readonly Chapter[],
  titles: ReadonlyMap<string, string>,
  files: SharedFiles,
): string {
  const all = chapters.flatMap(chapter => chapter.pages.map(one => one.name))
  const place = all.indexOf(page.name)
  const link = (name: string | undefined, rel: string, word: string) =>
    name === undefined
      ? ""
      : `<a class="${rel}" rel="${rel}" href="${pageAddress(name)}"><small>${word}</small> ${escapeHtml(titles.get(name) ?? name)}</a>`
  return `<!doctype html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<meta name="color-scheme" content="light dark">
<title>${escapeHtml(page.title)} · Rosy guide</title>
<link rel="icon" href="${icon}">
${files.styles.map(address => `<link rel="stylesheet" href="${address}">`).join("\n")}
<script type="module" src="${files.script}"></script>
</head>
<body>
<a class="skip" href="#content">To the text</a>
<header class="top">
<a class="brand" href="index.html">Rosy guide</a>
<search data-index="${files.searchIndex}" hidden>
<input type="search" id="search" placeholder="Search the guide" aria-label="Search the guide" autocomplete="off" spellcheck="false" aria-controls="found">
<div class="found" id="found" hidden></div>
</search>
<a class="to-rosy" href="../">Open Rosy</a>
</header>
<p class="language" id="language" hidden></p>
<div class="columns">
<nav class="contents" aria-label="Contents"><details open><summary>Contents</summary>
${contents(chapters, titles, page.name)}
</details></nav>
<main id="content">
${page.html}
<nav class="turn" aria-label="Next and previous page">${link(all[place - 1], "prev", "Before:")}${link(all[place + 1], "next", "Next:")}</nav>
</main>
</div>
</body>
</html>
`
}

function contents(chapters: readonly Chapter[], titles: ReadonlyMap<string, string>, open: string): string {
  const item = (name: string) =>
    `<li><a href="${pageAddress(name)}"${name === open ? ' aria-current="page"' : ""}>${escapeHtml(titles.get(name) ?? name)}</a></li>`
  return chapters
    .map(
      ({title, pages}) =>
        `<p>${escapeHtml(title)}</p>\n<ul>${pages.map(one => item(one.name)).join("")}</ul>`,
    )
    .join("\n")
}
