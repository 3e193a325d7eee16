/// How deep a piece of Haskell is nested, by its tokens alone: strings and comments do not count.

import {tokens} from "./lexer.ts"

/// The most brackets and layout blocks (Haskell 2010 report §10.3) that stand within one another. A block that only a later word ends (`parse-error(t)`
/// in the report) counts until a line begins further left, or its bracket ends.
export function nestingDepth(source: string): number {
  let deepest = 0
  /// The column of each open layout block; `null` for a bracket.
  const open: (number | null)[] = []
  let opensBlock = false
  let before = ""
  let [lineStart, lineEnd, isFirst] = [0, source.indexOf("\n"), true]
  const push = (column: number | null) => {
    open.push(column)
    deepest = Math.max(deepest, open.length)
  }
  /// What begins at an offset: it begins the block that is due, and ends those of earlier lines that stand further right.
  const begin = (at: number) => {
    for (; lineEnd !== -1 && lineEnd < at; lineEnd = source.indexOf("\n", lineStart)) {
      lineStart = lineEnd + 1
      isFirst = true
    }
    const column = at - lineStart
    if (isFirst)
      for (let top = open.at(-1); typeof top === "number" && top > column; top = open.at(-1)) open.pop()
    isFirst = false
    if (opensBlock) push(column)
    opensBlock = false
  }
  const pass = (from: number, to: number) => {
    for (let at = from; at < to; at++) {
      const c = source[at] ?? ""
      if ("([{".includes(c)) {
        if (c === "{") opensBlock = false
        else begin(at)
        push(null)
      } else if (")]}".includes(c)) while (open.length > 0 && open.pop() !== null);
    }
  }
  let at = 0
  for (const {kind, start, end} of tokens(source)) {
    pass(at, start)
    at = end
    if (kind === "comment") continue
    const word = source.slice(start, end)
    begin(start)
    if (word === "in" && typeof open.at(-1) === "number") open.pop()
    // `\case` and `if |` open a block as well.
    opensBlock =
      (kind === "keyword" && /^(?:do|of|let|where)$/.test(word)) ||
      (word === "case" && before.endsWith("\\")) ||
      (word.startsWith("|") && before === "if")
    before = word
  }
  pass(at, source.length)
  return deepest
}
