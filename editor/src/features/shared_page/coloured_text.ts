/// Haskell as HTML: each word in the class of its colour, as the Haskell pane has it. Pure.

import {tokens} from "@rosy/codegen"
import type {Program} from "../../program/program.ts"
import {classOf, paletteOf} from "../../views/source/syntax_colouring.ts"

/// Text as the content of an element or of a quoted attribute (HTML, section 13.3).
export function escapeHtml(text: string): string {
  return text
    .replaceAll("&", "&amp;")
    .replaceAll("<", "&lt;")
    .replaceAll(">", "&gt;")
    .replaceAll('"', "&quot;")
    .replaceAll("'", "&#39;")
}

export function colouredText(program: Program): string {
  const {text} = program
  const palette = paletteOf(program)
  let html = ""
  let done = 0
  for (const token of tokens(text)) {
    const word = text.slice(token.start, token.end)
    const name = classOf(token, word, palette.at(token.start, word))
    if (name === null) continue
    html += `${escapeHtml(text.slice(done, token.start))}<span class="${name}">${escapeHtml(word)}</span>`
    done = token.end
  }
  return html + escapeHtml(text.slice(done))
}
