/// Tab expansion: tab stops every eight columns (Haskell 2010 report §10.3).

/// A line with spaces in place of its tabs.
export function expandTabs(line: string): string {
  return line.includes("\t") ? untabbed(line).text : line
}

/// A text with spaces in place of its tabs, and where in the given text each of its characters comes from.
export function untabbed(given: string): {readonly text: string; readonly from: readonly number[]} {
  let text = ""
  let column = 0
  let at = 0
  const from: number[] = []
  for (const c of given) {
    const width = c === "\t" ? 8 - (column % 8) : 1
    column = c === "\n" ? 0 : column + width
    const put = c === "\t" ? " ".repeat(width) : c
    for (let i = 0; i < put.length; i++) from.push(at + (c === "\t" ? 0 : i))
    text += put
    at += c.length
  }
  from.push(at)
  return {text, from}
}
