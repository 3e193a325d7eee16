/// The toolbox's blocks as pieces of Haskell, for the text.

import {codeOf, type SavedBlock, toolbox} from "@rosy/codegen"

export interface Snippet {
  readonly label: string
  readonly code: string
}

let made: readonly Snippet[] | undefined

/// All of them, each once; printed when somebody first asks.
export function snippets(): readonly Snippet[] {
  if (made === undefined) {
    const byCode = new Map<string, Snippet>()
    for (const item of toolbox("haskell").flatMap(category => category.items)) {
      const code = codeOf(item.block)?.text
      if (code !== undefined && code.includes(" ") && !byCode.has(code))
        byCode.set(code, {label: item.label, code})
    }
    made = [...byCode.values()]
  }
  return made
}

/// A block's text as it goes into `text` at `offset`, and where: a definition stands on lines of its own, before the definition that the place is
/// in; the further lines of anything else are indented as far as the first.
export function placed(
  text: string,
  offset: number,
  block: SavedBlock,
): {readonly start: number; readonly end: number; readonly text: string} | null {
  const code = codeOf(block)
  if (code === undefined) return null
  const lineStart = text.lastIndexOf("\n", offset - 1) + 1
  if (!code.definition) {
    // In the empty end of a line the piece begins where the line does.
    const column = offset - lineStart
    const indented = code.text.replaceAll("\n", `\n${" ".repeat(column)}`)
    const hole = holeAt(text, offset)
    return hole === null
      ? {start: offset, end: offset, text: spaced(text, offset, indented)}
      : {...hole, text: indented}
  }
  let at = lineStart
  // Up to where a definition begins, with the comment above it: to an empty line.
  for (let before = lineAbove(text, at); before !== null; before = lineAbove(text, at)) at = before
  return {start: at, end: at, text: `${code.text}\n\n`}
}

/// Where the line above `lineStart` begins; `null` when there is none with anything in it.
function lineAbove(text: string, lineStart: number): number | null {
  if (lineStart === 0) return null
  const start = text.lastIndexOf("\n", lineStart - 2) + 1
  return text.slice(start, lineStart).trim() === "" ? null : start
}

/// An open place, `_`, is filled by what is dropped on it.
function holeAt(text: string, offset: number): {start: number; end: number} | null {
  for (const start of [offset, offset - 1])
    if (text[start] === "_" && !/[\p{L}\p{N}_']/u.test(`${text[start - 1] ?? ""}${text[start + 1] ?? ""}`))
      return {start, end: start + 1}
  return null
}

function spaced(text: string, offset: number, piece: string): string {
  const before = /[\p{L}\p{N}_')\]"]/u.test(text[offset - 1] ?? "") ? " " : ""
  const behind = /[\p{L}\p{N}_'([\\"]/u.test(text[offset] ?? "") ? " " : ""
  return `${before}${piece}${behind}`
}
