/// Code blocks of the guide: a Haskell program in the colours of the page, with a link that opens it.
///
/// Words behind ```` ```haskell ```` say how the tests treat it and where it opens: `room=table`, `seconds=20`, `refused`, `fragment`, `package`.

export interface Program {
  readonly text: string
  readonly room: string
  /// A whole program for the page; others have no link.
  readonly canBeOpened: boolean
}

/// `null` for what is not Haskell.
export function programOf(info: string, text: string): Program | null {
  const [language, ...words] = info.split(/\s+/)
  if (language !== "haskell") return null
  const room = words.find(word => word.startsWith("room="))?.slice("room=".length)
  return {
    text: `${text}\n`,
    room: room ?? "room",
    canBeOpened: !words.includes("fragment") && !words.includes("package"),
  }
}

export function programHtml({text, canBeOpened}: Program, openAddress: string, openWords: string): string {
  const code = `<pre tabindex="0"><code>${coloured(text.trimEnd())}</code></pre>`
  if (!canBeOpened) return `<div class="program">${code}</div>\n`
  return `<div class="program">${code}<a class="open" href="${escapeHtml(openAddress)}">${escapeHtml(openWords)}</a></div>\n`
}

/// Tokens that have a colour (Haskell 2010 report §2): fewer kinds than the lexer of codegen tells apart.
const token =
  /(?<comment>--.*)|(?<string>"(?:[^"\\\n]|\\.)*")|(?<keyword>\b(?:case|class|data|deriving|do|else|if|import|in|instance|let|module|newtype|of|then|type|where)\b)|(?<type>\b[A-Z]\w*)|\b(?<number>\d+(?:\.\d+)?)\b/g

export function coloured(text: string): string {
  let at = 0
  let html = ""
  for (const match of text.matchAll(token)) {
    const [colour = "", word = ""] =
      Object.entries(match.groups ?? {}).find(([, found]) => found !== undefined) ?? []
    html += `${escapeHtml(text.slice(at, match.index))}<span class="${colour}">${escapeHtml(word)}</span>`
    at = match.index + word.length
  }
  return html + escapeHtml(text.slice(at))
}

export function escapeHtml(text: string): string {
  return text.replace(
    /[&<>"]/g,
    sign => ({"&": "&amp;", "<": "&lt;", ">": "&gt;", '"': "&quot;"})[sign] ?? sign,
  )
}
