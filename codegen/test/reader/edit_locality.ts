/// Locality of an edit: outside of the edited nodes and the separators beside them every character stays, comments included, and the texts of
/// nodes that are moved or wrapped stay, too.
///
/// In: the text before and after, and the places of the edited nodes in the text before. Out: what changed elsewhere. Lines below an edit may
/// move sideways together, with the line that they are aligned to.

export interface Place {
  readonly start: number
  readonly end: number
}

/// Brackets, commas, semicolons, `$`, and white space: what an edit may add or take beside its nodes.
const separatorsBefore = /(?:[\s(),;$[\]{}|]|\b(?:do|of|then|else|let|in|where)\b)*$/
const separatorsBehind = /^[\s(),;$[\]{}|]*/

/// What changed outside of `places`; undefined when nothing did.
export function changedElsewhere(
  before: string,
  after: string,
  places: readonly Place[],
): string | undefined {
  const start = Math.min(...places.map(p => p.start))
  const end = Math.max(...places.map(p => p.end))
  const head = before.slice(0, start).replace(separatorsBefore, "")
  const tail = before.slice(end).replace(separatorsBehind, "")
  if (!after.startsWith(head)) return `the text before the edited nodes: ${firstDifference(head, after)}`
  if (!movedTogether(tail, after))
    return `the text behind the edited nodes: ${JSON.stringify(tail.slice(0, 200))}`
  return undefined
}

/// A place with the comments that belong to it: on the lines above it, and behind it on its last line.
export function withComments(text: string, {start, end}: Place): Place {
  const above = /(?:^[^\S\n]*--[^\n]*\n)*[^\S\n]*$/m.exec(text.slice(0, start))
  const behind = /^[^\S\n]*(?:--[^\n]*|\{-[^\n]*?-\})/.exec(text.slice(end))
  return {start: above?.index ?? start, end: end + (behind?.[0].length ?? 0)}
}

function firstDifference(text: string, after: string): string {
  let at = 0
  while (text[at] === after[at]) at++
  return `${JSON.stringify(text.slice(at, at + 80))} became ${JSON.stringify(after.slice(at, at + 80))}`
}

/// Whether `after` ends with the lines of `rest`; lines below the first may have moved sideways, all as far.
function movedTogether(rest: string, after: string): boolean {
  const was = rest.split("\n")
  const is = after.split("\n").slice(-was.length)
  const [first = "", ...below] = was
  if (is.length !== was.length || !is[0]?.endsWith(first)) return false
  const moves = below.flatMap((line, i) => {
    const now = is[i + 1] ?? ""
    return line === now ? [] : [line.trimStart() === now.trimStart() ? now.length - line.length : Number.NaN]
  })
  return new Set(moves).size <= 1 && !moves.some(Number.isNaN)
}

/// Texts of kept nodes that are no longer in the program, line breaks and indentation aside.
export function lostTexts(before: string, after: string, kept: readonly Place[]): readonly string[] {
  const flat = (text: string) => text.replace(/\s+/g, " ")
  const now = flat(after)
  return kept.map(p => flat(before.slice(p.start, p.end))).filter(text => !now.includes(text))
}
