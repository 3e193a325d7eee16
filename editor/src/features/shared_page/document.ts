/// The file that shows a program and its last run without Rosy: HTML with its styles, its script and its data inside. Pure.
///
/// Its policy allows the one script of Rosy by its hash, and nothing to be loaded or sent. All that a program brings (name, text, what the robot said, the room) is
/// escaped. Blocks come as SVG from `block_drawing.ts`, which copies them as elements and not as text.

import type {Reach} from "../../state/page_state.ts"
import {escapeHtml} from "./coloured_text.ts"
import type {Film} from "./film.ts"

export interface SharedPage {
  readonly language: string
  readonly direction: "ltr" | "rtl"
  readonly version: string
  readonly name: string
  /// An `<svg>` element; `null` when there are no blocks.
  readonly blocks: string | null
  /// Haskell as HTML (`coloured_text.ts`).
  readonly haskell: string
  readonly film: Film | null
  /// The film is that of an earlier text of the program.
  readonly isFilmOlder: boolean
  readonly link: string
  readonly reach: Reach
  readonly styles: string
  /// The script that plays the film, and the base64 of its SHA-256 (CSP3, section 2.3.1).
  readonly player: {readonly script: string; readonly hash: string}
  readonly words: SharedPageWords
}

export interface SharedPageWords {
  readonly blocks: string
  readonly haskell: string
  readonly film: string
  readonly noFilm: string
  readonly olderFilm: string
  readonly play: string
  readonly pause: string
  readonly time: string
  readonly room: string
  readonly open: string
  readonly reach: {readonly [reach in Exclude<Reach, "page">]: string}
  readonly made: string
}

export function sharedPage(page: SharedPage): string {
  const {words} = page
  const policy = `default-src 'none'; script-src 'sha256-${page.player.hash}'; style-src 'unsafe-inline'; base-uri 'none'; form-action 'none'`
  const name = escapeHtml(page.name)
  return `<!doctype html>
<html lang="${escapeHtml(page.language)}" dir="${page.direction}">
<head>
<meta charset="utf-8">
<meta http-equiv="Content-Security-Policy" content="${policy}">
<meta name="viewport" content="width=device-width, initial-scale=1">
<meta name="referrer" content="no-referrer">
<meta name="generator" content="Rosy ${escapeHtml(page.version)}">
<title>${name}</title>
<style>${page.styles}</style>
</head>
<body>
<header>
<h1 dir="auto">${name}</h1>
<p><a href="${escapeHtml(page.link)}" rel="noopener noreferrer">${escapeHtml(words.open)}</a></p>
${page.reach === "page" ? "" : `<p class="quiet">${escapeHtml(words.reach[page.reach])}</p>`}
</header>
<main>
${filmSection(page)}
${section("blocks", words.blocks, page.blocks === null ? "" : `<div class="scrolled" tabindex="0" role="group" aria-label="${escapeHtml(words.blocks)}">${page.blocks}</div>`)}
${section("haskell", words.haskell, `<pre dir="ltr" tabindex="0"><code>${page.haskell}</code></pre>`)}
</main>
<footer class="quiet">${escapeHtml(words.made)}</footer>
${page.film === null ? "" : `<script type="application/json" id="film">${jsonInScript(page.film)}</script>\n<script>${page.player.script}</script>`}
</body>
</html>
`
}

function section(name: string, title: string, content: string): string {
  if (content === "") return ""
  return `<section class="${name}" aria-labelledby="${name}-title"><h2 id="${name}-title">${escapeHtml(title)}</h2>${content}</section>`
}

function filmSection({film, isFilmOlder, words}: SharedPage): string {
  if (film === null) return section("run", words.film, `<p class="quiet">${escapeHtml(words.noFilm)}</p>`)
  const note = isFilmOlder ? `<p class="quiet">${escapeHtml(words.olderFilm)}</p>` : ""
  return section(
    "run",
    words.film,
    `<canvas id="room" role="img" aria-label="${escapeHtml(words.room)}"></canvas>
<div class="controls"><button type="button" id="play" data-play="${escapeHtml(words.play)}" data-pause="${escapeHtml(words.pause)}">${escapeHtml(words.play)}</button><input type="range" id="time" aria-label="${escapeHtml(words.time)}" step="0.02"><output id="clock" for="time"></output></div>${note}`,
  )
}

/// JSON as the content of a script element: without a letter that could end it or start a comment (HTML, section 4.12.1.3).
function jsonInScript(value: unknown): string {
  return JSON.stringify(value).replaceAll("<", "\\u003c")
}
