/// Indentation that knows Haskell's layout: a new line stands under the last one, or two further in after a word
/// that opens something (Haskell 2010 report §2.7).

import {indentService, indentUnit} from "@codemirror/language"
import type {Extension} from "@codemirror/state"

const opens = /(?:[=({[,]|->|<-|\b(?:do|of|where|let|then|else|in))\s*$/

/// The column for a line that follows `before`.
export function indentAfter(before: string): number {
  const code = before.replace(/\s*--.*$/, "")
  const indent = /^ */.exec(before)?.[0].length ?? 0
  // After `do` or `of` the first line below sets the block; two further in is what learners read best.
  return opens.test(code) ? indent + 2 : indent
}

export const layout: Extension = [
  indentUnit.of("  "),
  indentService.of((context, pos) => {
    const line = context.lineAt(pos, -1)
    // The text before the cursor when a line is broken, the line above when one is indented anew.
    const before =
      pos > line.from
        ? line.text.slice(0, pos - line.from)
        : line.from > 0
          ? context.lineAt(line.from - 1).text
          : ""
    return indentAfter(before)
  }),
]
