/// Line endings of opened files. The page uses `\n`, as CodeMirror does. A saved file keeps the original ending of each line that was not changed.

import {withoutMark} from "@rosy/codegen/text-file"
import {changesBetween, unchangedPosition} from "../../program/text_changes.ts"

const ends = /\r\n?|\n/g
const mark = "\uFEFF"

/// The text as the page holds it: without a byte order mark, each line ended by one character.
export function normalizeLineEndings(text: string): string {
  return withoutMark(text).replace(ends, "\n")
}

/// `text`, an edit of `file`, with the byte order mark and the line endings of that file. A line whose ending is new or next to a change ends
/// as most lines of the file do.
export function withLineEndingsOf(file: string, text: string): string {
  const kinds = file.match(ends) ?? []
  const bom = file.startsWith(mark) ? mark : ""
  if (kinds.every(kind => kind === "\n")) return bom + text
  const before = normalizeLineEndings(file)
  const oldPosition = unchangedPosition(changesBetween(before, text))
  const kindAt = new Map([...before.matchAll(/\n/g)].map(({index}, i) => [index, kinds[i]]))
  const usual = commonest(kinds)
  let last = {at: -1, end: ""}
  const ended = text.replace(/\n/g, (_end, at: number) => {
    const old = oldPosition(at, at + 1)
    const end = (old === null ? undefined : kindAt.get(old)) ?? usual
    // `\r` and `\n` in succession would be one line ending.
    last = {at, end: end === "\n" && last.end === "\r" && last.at === at - 1 ? "\r" : end}
    return last.end
  })
  return bom + ended
}

function commonest(kinds: readonly string[]): string {
  const count = new Map<string, number>()
  for (const kind of kinds) count.set(kind, (count.get(kind) ?? 0) + 1)
  return [...count].reduce((best, kind) => (kind[1] > best[1] ? kind : best), ["\n", 0] as const)[0]
}
