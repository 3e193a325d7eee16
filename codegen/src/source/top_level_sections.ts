/// Top-level sections of a file, by layout alone: header, definitions with the comments above them, and the rest.
///
/// The parts' ends, one after the other, cover the file. `reader/module/module_reader.ts` parses what a section says.

import type {Cause} from "../model/raw_reasons.ts"
import type {Range} from "./lexer.ts"
import type {Comment, Item, Lexed} from "./top_level_items.ts"
import {wordsOf} from "./top_level_items.ts"

export interface Part {
  readonly kind: "header" | "declaration" | "end"
  readonly core: Range
  readonly remark: Range | undefined
  readonly end: number
  readonly name: string
  readonly source: string
  /// The words of the comment above.
  readonly comment: string
  /// Comments inside the core.
  readonly inner: readonly Comment[]
  /// The comment behind the core, if it ends the line of a core of several lines: it may belong to the last step.
  readonly tail: Comment | undefined
  readonly dashed: readonly Range[]
  readonly column: number
  readonly trouble: Cause | undefined
}

export function partsOf(text: string, {items, comments, dashed}: Lexed): Part[] {
  const parts: Part[] = []
  let nextComment = 0
  let end = 0
  for (const group of groupsOf(items)) {
    const first = group[0]
    const last = group[group.length - 1]
    if (first === undefined || last === undefined) continue
    const core = {start: first.start, end: last.end}
    const before: Comment[] = []
    const inner: Comment[] = []
    for (; nextComment < comments.length; nextComment++) {
      const c = comments[nextComment]
      if (c === undefined || c.start >= core.end) break
      if (c.start >= core.start) inner.push(c)
      else if (c.start >= end) before.push(c)
    }
    const isDeclaration = first.kind === "declaration" || parts.some(p => p.kind === "declaration")
    const remarks = isDeclaration ? remarksAbove(text, before, core.start, end) : []
    const [top] = remarks
    const lineStart = Math.max(text.lastIndexOf("\n", core.start - 1) + 1, text.startsWith("\uFEFF") ? 1 : 0)
    end = endOfLine(text, core.end, comments)
    parts.push({
      kind: isDeclaration ? "declaration" : "header",
      core,
      remark:
        top === undefined ? undefined : {start: top.start, end: remarks[remarks.length - 1]?.end ?? top.end},
      end,
      name: first.name,
      source: text.slice(core.start, core.end),
      comment: remarks.flatMap(c => wordsOf(text.slice(c.start, c.end), c.kind)).join("\n"),
      inner,
      tail: text.slice(core.start, core.end).includes("\n")
        ? tailBehind(text, core.end, comments)
        : undefined,
      dashed: dashed.filter(d => d.start >= core.start && d.end <= core.end),
      column: /^ *$/.test(text.slice(lineStart, core.start)) ? core.start - lineStart : 0,
      trouble:
        group.find(item => item.trouble !== undefined)?.trouble ??
        (first.kind === "declaration" ? undefined : "directive"),
    })
  }
  if (end < text.length || parts.length === 0) {
    const empty = {start: text.length, end: text.length}
    parts.push({
      kind: "end",
      core: empty,
      remark: undefined,
      end: text.length,
      name: "",
      source: "",
      comment: "",
      inner: [],
      tail: undefined,
      dashed: [],
      column: 0,
      trouble: undefined,
    })
  }
  return parts
}

/// A signature and the equations of one name belong together.
function groupsOf(items: readonly Item[]): Item[][] {
  const groups: Item[][] = []
  for (const item of items) {
    const last = groups[groups.length - 1]
    const [head] = last ?? []
    const joins =
      head !== undefined &&
      item.kind === "declaration" &&
      head.kind === "declaration" &&
      item.name !== "" &&
      item.name === head.name &&
      !item.type
    if (joins && !item.signature) last?.push(item)
    else groups.push([item])
  }
  return groups
}

/// The comments that stand directly above, without an empty line between them and what they are about.
function remarksAbove(text: string, before: readonly Comment[], core: number, end: number): Comment[] {
  const remarks: Comment[] = []
  let below = core
  for (let i = before.length - 1; i >= 0; i--) {
    const c = before[i]
    if (c === undefined) break
    const between = text.slice(c.end, below)
    const lineStart = Math.max(end, text.lastIndexOf("\n", c.start - 1) + 1)
    const alone =
      text.slice(lineStart, c.start).trim() === "" && (lineStart > end || end === 0 || text[end - 1] === "\n")
    if (!/^[ \t]*\r?\n[ \t]*$/.test(between) || !alone) break
    remarks.unshift(c)
    below = c.start
  }
  return remarks
}

/// The end of the line on which something ends, with a comment that stands behind it, if only that does.
function endOfLine(text: string, from: number, comments: readonly Comment[]): number {
  let at = from
  for (;;) {
    const newline = text.indexOf("\n", at)
    const line = newline === -1 ? text.length : newline + 1
    if (text.slice(at, line).trim() === "") return line
    const spaces = /^[ \t]*/.exec(text.slice(at, line))?.[0].length ?? 0
    const comment = commentAt(comments, at + spaces)
    if (comment === undefined) return at
    at = comment.end
  }
}

/// The comment that follows on the same line, if only blanks follow it.
function tailBehind(text: string, from: number, comments: readonly Comment[]): Comment | undefined {
  const blanks = /[ \t]*/y
  blanks.lastIndex = from
  blanks.test(text)
  const comment = commentAt(comments, Math.max(blanks.lastIndex, from))
  if (comment === undefined) return undefined
  const lineEnd = /[ \t]*(?:\r?\n|$)/y
  lineEnd.lastIndex = comment.end
  return lineEnd.test(text) ? comment : undefined
}

function commentAt(comments: readonly Comment[], start: number): Comment | undefined {
  let low = 0
  let high = comments.length
  while (low < high) {
    const middle = (low + high) >> 1
    if ((comments[middle]?.start ?? 0) < start) low = middle + 1
    else high = middle
  }
  return comments[low]?.start === start ? comments[low] : undefined
}
