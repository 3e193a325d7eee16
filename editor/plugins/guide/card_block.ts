/// Cards of blocks in a page of the guide: a fenced block `card FAMILY CAPTION` with a block in words, a line `---`, and its Haskell.
///
/// Words between `⟦FAMILY ` and `⟧` are a block, which holds others; those between `⟨` and `⟩` are a field or an empty place.

import {coloured, escapeHtml} from "./code_block.ts"

export interface Card {
  readonly family: string
  readonly caption: string
  readonly drawn: string
  readonly haskell: string
}

export const cardMarkdown = ({family, caption, drawn, haskell}: Card): string =>
  `\`\`\`card ${family} ${caption}\n${drawn}\n---\n${haskell}\n\`\`\``

/// `null` for another fenced block.
export function cardOf(info: string, text: string): Card | null {
  const [, family, caption] = /^card (\w+) (.*)$/.exec(info) ?? []
  const [drawn, haskell] = text.split("\n---\n")
  if (family === undefined || caption === undefined || drawn === undefined || haskell === undefined)
    return null
  return {family, caption, drawn, haskell}
}

export const cardHtml = ({family, caption, drawn, haskell}: Card): string =>
  `<figure class="card family-${family}"><figcaption>${escapeHtml(caption)}</figcaption>${drawn === "" ? "" : `<p>${drawnHtml(drawn)}</p>`}<pre><code>${coloured(haskell)}</code></pre></figure>\n`

/// For the search.
export const cardText = ({drawn, haskell}: Card): string => `${drawn.replace(/⟦\w+ |[⟧⟨⟩]/g, " ")} ${haskell}`

const drawnHtml = (drawn: string): string =>
  escapeHtml(drawn)
    .replace(/⟦(\w+) /g, '<span class="block family-$1">')
    .replaceAll("⟨", '<span class="field">')
    .replace(/[⟧⟩]/g, "</span>")
    .replaceAll("\n", "<br>")
