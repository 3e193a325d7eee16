/// Full-text search in the guide: the sections that contain all words of a query, best first. Pure; the index is made by the build.

/// A section of a page: what is below one heading.
export interface SearchEntry {
  /// Address of the page, from another page of the guide.
  readonly page: string
  readonly title: string
  readonly anchor: string
  readonly heading: string
  readonly text: string
}

export interface SearchResult {
  readonly entry: SearchEntry
  /// A part of the text around the first word that was found.
  readonly excerpt: string
}

/// Results that are shown: more are not read.
const mostResults = 12

/// Characters of an excerpt before and after the word that was found.
const before = 40
const after = 110

/// The words of a text as they are compared: lower case, without accents.
export function wordsOf(text: string): readonly string[] {
  return folded(text).match(/[\p{L}\p{N}]+/gu) ?? []
}

const folded = (text: string): string => text.normalize("NFD").replace(/\p{M}/gu, "").toLowerCase()

/// The sections in which each word of the query is the beginning of a word.
export function search(index: readonly SearchEntry[], query: string): readonly SearchResult[] {
  const wanted = wordsOf(query)
  if (wanted.length === 0) return []
  return index
    .map(entry => ({entry, score: scoreOf(entry, wanted)}))
    .filter(({score}) => score > 0)
    .sort((a, b) => b.score - a.score)
    .slice(0, mostResults)
    .map(({entry}) => ({entry, excerpt: excerptOf(entry.text, wanted)}))
}

/// 0 unless every word is found. A word in a heading counts more than in the text, a whole word more than a beginning.
function scoreOf(entry: SearchEntry, wanted: readonly string[]): number {
  const places: readonly (readonly [readonly string[], number])[] = [
    [wordsOf(entry.heading), 10],
    [wordsOf(entry.title), 4],
    [wordsOf(entry.text), 1],
  ]
  let score = 0
  for (const word of wanted) {
    let best = 0
    for (const [words, weight] of places) {
      if (words.includes(word)) best += 2 * weight
      else if (words.some(one => one.startsWith(word))) best += weight
    }
    if (best === 0) return 0
    score += best
  }
  return score
}

function excerptOf(text: string, wanted: readonly string[]): string {
  const lower = text.toLowerCase()
  const found = wanted.map(word => lower.indexOf(word)).filter(at => at >= 0)
  const at = found.length === 0 ? 0 : Math.min(...found)
  // Whole words only.
  const from = at <= before ? 0 : text.indexOf(" ", at - before) + 1
  const to = at + after >= text.length ? text.length : text.lastIndexOf(" ", at + after)
  return `${from > 0 ? "… " : ""}${text.slice(from, Math.max(to, from))}${to < text.length ? " …" : ""}`
}
