/// Conversion of a Markdown page of the guide to HTML.
///
/// In: the text and a resolver of its links and pictures. Out: HTML, the title, the anchors, the sections for the search, and the faults:
/// what a page must not contain. It reads no file.

import {Marked, type Token, type Tokens} from "marked"
import {cardHtml, cardOf, cardText} from "./card_block.ts"
import {escapeHtml, programHtml, programOf} from "./code_block.ts"
import {tablesOf} from "./language_tables.ts"

/// A part of a page below a heading, as text, for the search.
export interface Section {
  readonly anchor: string
  readonly heading: string
  readonly text: string
}

export interface Picture {
  readonly address: string
  readonly width: number
  readonly height: number
  /// Address of the picture that stands in place of an animation.
  readonly still: string | null
}

/// Where a link or a picture leads. A link to a file that the guide does not contain keeps its words only.
export interface Resolver {
  link(target: string): {readonly kind: "page"; readonly address: string} | {readonly kind: "words"} | null
  picture(target: string): Picture | null
  /// What follows the address of Rosy's page to open a program.
  openAddress(program: string, room: string): string
}

export interface ConvertedPage {
  readonly title: string
  readonly html: string
  readonly anchors: ReadonlySet<string>
  readonly sections: readonly Section[]
  readonly faults: readonly string[]
}

const anchorTag = /^<a id="([\w-]+)"><\/a>$/

export function convertMarkdown(
  text: string,
  resolver: Resolver,
  table = tablesOf("en").guide,
): ConvertedPage {
  const faults: string[] = []
  const anchors = new Set<string>()
  const sections: {anchor: string; heading: string; text: string}[] = []
  const marked = new Marked({gfm: true})
  const tokens = marked.lexer(text)
  const title = tokens.find((token): token is Tokens.Heading => token.type === "heading" && token.depth === 1)
  if (title === undefined) faults.push("has no title")

  for (const token of tokens) {
    if (token.type === "heading") {
      const heading = plainText(token.tokens ?? [])
      sections.push({anchor: anchorOf(token as Tokens.Heading, anchors), heading, text: ""})
    } else {
      const last = sections.at(-1)
      if (last !== undefined) last.text = `${last.text} ${plainText([token])}`.replace(/\s+/g, " ").trim()
    }
  }

  let headings = 0
  marked.use({
    renderer: {
      heading({tokens: inside, depth}) {
        const anchor = sections[headings++]?.anchor ?? ""
        const words = this.parser.parseInline(inside)
        const link =
          depth === 1 ? "" : ` <a class="here" href="#${anchor}" aria-label="${escapeHtml(table.here)}">#</a>`
        return `<h${depth} id="${anchor}">${words}${link}</h${depth}>\n`
      },
      html({text: html}) {
        // An anchor of a heading has become the heading's own.
        if (!/^(<a id="[\w-]+">|<\/a>)$/.test(html.trim())) faults.push(`contains HTML: ${html.trim()}`)
        return ""
      },
      code({text: code, lang}) {
        const card = cardOf(lang ?? "", code)
        if (card !== null) return cardHtml(card)
        const program = programOf(lang ?? "", code)
        if (program === null)
          return `<pre class="${lang === "says" ? "says" : "terminal"}" tabindex="0"><code>${escapeHtml(code)}</code></pre>\n`
        return programHtml(program, resolver.openAddress(program.text, program.room), table.openProgram)
      },
      link({href, tokens: inside}) {
        const words = this.parser.parseInline(inside)
        const found = resolver.link(href)
        if (found === null) faults.push(`links to ${href}, which does not exist`)
        return found?.kind === "page" ? `<a href="${escapeHtml(found.address)}">${words}</a>` : words
      },
      image({href, text: alt}) {
        const found = resolver.picture(href)
        if (found === null) faults.push(`shows ${href}, which does not exist`)
        if (alt === "") faults.push(`shows ${href} without words for those who do not see it`)
        if (found === null) return ""
        const {address, still, width, height} = found
        const img = `<img src="${escapeHtml(address)}" alt="${escapeHtml(alt)}" width="${width}" height="${height}" loading="lazy">`
        if (still === null) return img
        return `<picture class="animation"><source media="print, (prefers-reduced-motion: reduce)" srcset="${escapeHtml(still)}">${img}</picture>`
      },
      table(token) {
        const row = (cells: readonly Tokens.TableCell[], tag: string) =>
          `<tr>${cells.map(cell => `<${tag}>${this.parser.parseInline(cell.tokens)}</${tag}>`).join("")}</tr>`
        const body = token.rows.map(cells => row(cells, "td")).join("\n")
        return `<div class="table" tabindex="0"><table><thead>${row(token.header, "th")}</thead><tbody>${body}</tbody></table></div>\n`
      },
    },
  })
  const html = marked.parser(tokens)
  return {title: plainText(title?.tokens ?? []), html, anchors, sections, faults}
}

/// The heading's own `<a id="…"></a>`, else its words; a number makes it unique.
function anchorOf(heading: Tokens.Heading, taken: Set<string>): string {
  const given = anchorTag.exec(
    heading.tokens
      .filter(token => token.type === "html")
      .map(token => token.raw)
      .join(""),
  )?.[1]
  const words = plainText(heading.tokens)
    .toLowerCase()
    .replace(/[^\p{L}\p{N}]+/gu, "-")
    .replace(/^-|-$/g, "")
  let anchor = given ?? words
  for (let i = 2; taken.has(anchor); i += 1) anchor = `${given ?? words}-${i}`
  taken.add(anchor)
  return anchor
}

/// The words of tokens, without markup.
function plainText(tokens: readonly Token[]): string {
  return tokens
    .map((token): string => {
      if (token.type === "html") return ""
      if (token.type === "image") return ` ${token.text} `
      if (token.type === "table") {
        const table = token as Tokens.Table
        return [table.header, ...table.rows]
          .flat()
          .map(cell => plainText(cell.tokens))
          .join(" ")
      }
      const card = token.type === "code" ? cardOf(token.lang ?? "", token.text) : null
      if (card !== null) return ` ${cardText(card)} `
      if (token.type === "list")
        return (token as Tokens.List).items.map(item => plainText(item.tokens)).join(" ")
      if ("tokens" in token && token.tokens !== undefined)
        return `${plainText(token.tokens)}${blocks.has(token.type) ? " " : ""}`
      return "text" in token ? unescapeHtml(token.text) : token.raw
    })
    .join("")
}

const blocks = new Set(["paragraph", "blockquote", "heading", "text"])

const unescapeHtml = (text: string): string =>
  text.replace(
    /&(lt|gt|amp|quot|#39);/g,
    (_, name: string) => ({lt: "<", gt: ">", amp: "&", quot: '"', "#39": "'"})[name] ?? "",
  )
