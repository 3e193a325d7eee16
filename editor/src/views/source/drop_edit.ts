/// Drop edit: the change of the text when a block is dropped on it. A definition goes between definitions, steps on lines of their own, any other code to the word under the
/// pointer, in parentheses where necessary. Pure.

import {type Token, tokens} from "@rosy/codegen"

export interface Code {
  readonly text: string
  readonly as: "definition" | "steps" | "part"
}

/// A change of the text, and what to select in the text after it.
export interface DropEdit {
  readonly from: number
  readonly to: number
  readonly insert: string
  readonly select: {readonly start: number; readonly end: number}
}

export function dropEdit(text: string, pointed: number, code: Code): DropEdit {
  const all = tokens(text)
  const comment = all.find(t => t.kind === "comment" && t.start < pointed && pointed < behind(text, t))
  const made =
    code.as === "part"
      ? part(text, all, comment === undefined ? pointed : besideComment(text, all, comment), code.text)
      : code.as === "steps"
        ? steps(text, comment?.end ?? pointed, code.text)
        : definition(text, all, comment?.end ?? pointed, code.text)
  return {...made, select: firstHole(made)}
}

/// Where a comment ends; a line comment takes what is typed behind it.
function behind(text: string, {start, end}: Token): number {
  return text.startsWith("--", start) ? end + 1 : end
}

/// Where a part goes that is let fall on a comment, for nothing in there is read: to what the comment stands behind, or else to the line below it, to what is
/// open there.
function besideComment(text: string, all: readonly Token[], comment: Token): number {
  const line = text.lastIndexOf("\n", comment.start - 1) + 1
  const before = text.slice(line, comment.start).trimEnd()
  if (before.trim() !== "") return line + before.length
  const after = all.filter(t => t.start >= comment.end && t.kind !== "comment")
  const [next] = after
  if (next === undefined) return text.length
  const newline = text.indexOf("\n", next.start)
  const below = after.filter(t => newline === -1 || t.end <= newline)
  const hole = below.find(t => text.slice(t.start, t.end) === "_")
  return hole?.start ?? below.at(-1)?.end ?? next.end
}

type Change = Omit<DropEdit, "select">

/// The first place that is still open, or behind all of it.
function firstHole({from, insert}: Change): DropEdit["select"] {
  const hole = tokens(insert).find(t => insert.slice(t.start, t.end) === "_")
  const end = from + insert.trimEnd().length
  return hole === undefined ? {start: end, end} : {start: from + hole.start, end: from + hole.end}
}

interface Line {
  readonly start: number
  readonly text: string
}

function linesOf(text: string): readonly Line[] {
  let start = 0
  return text.split("\n").map(line => {
    const one = {start, text: line}
    start += line.length + 1
    return one
  })
}

const lineAt = (lines: readonly Line[], at: number) =>
  Math.max(
    0,
    lines.findLastIndex(line => line.start <= at),
  )
const isBlank = (line: Line | undefined) => line === undefined || line.text.trim() === ""
const indentOf = (line: Line | undefined) => line?.text.search(/\S|$/) ?? 0

/// Behind the definition that the place is in.
function definition(text: string, all: readonly Token[], at: number, code: string): Change {
  const lines = linesOf(text)
  let line = lineAt(lines, at)
  const comments = all.filter(t => t.kind === "comment")
  const endsBefore = (n: number) => {
    const {start = 0} = lines[n] ?? {}
    if (!isBlank(lines[n]) || comments.some(t => t.start < start && start < t.end)) return false
    const next = lines.slice(n).find(other => !isBlank(other))
    return next === undefined || indentOf(next) === 0
  }
  while (line < lines.length && !endsBefore(line)) line += 1
  let last = line - 1
  while (last >= 0 && isBlank(lines[last])) last -= 1
  const above = lines[last]
  if (above === undefined) {
    const rest = text.trimStart()
    return {from: 0, to: text.length - rest.length, insert: rest === "" ? `${code}\n` : `${code}\n\n`}
  }
  const end = above.start + above.text.length
  return {from: end, to: end, insert: `\n\n${code}${end === text.length ? "\n" : ""}`}
}

/// Below the line that the place is in, as far in as the steps there are.
function steps(text: string, at: number, code: string): Change {
  const lines = linesOf(text)
  let n = lineAt(lines, at)
  while (n > 0 && isBlank(lines[n])) n -= 1
  const line = lines[n] ?? {start: 0, text: ""}
  const next = lines.slice(n + 1).find(other => !isBlank(other))
  const opens = /(?:^|\s)do$/.test(line.text.trimEnd())
  const after = /^(.*\sdo\s+)\S/.exec(line.text)?.[1]?.length
  const indent = !opens
    ? (after ?? indentOf(line))
    : indentOf(next) > indentOf(line)
      ? indentOf(next)
      : indentOf(line) + 2
  const end = line.start + line.text.length
  const space = " ".repeat(indent)
  return {
    from: end,
    to: end,
    insert: code
      .split("\n")
      .map(one => `\n${space}${one}`)
      .join(""),
  }
}

/// In place of the open place under the pointer, or beside the word there.
function part(text: string, all: readonly Token[], at: number, code: string): Change {
  const inside = all.find(t => t.start <= at && at <= t.end && t.kind !== "comment" && t.kind !== "operator")
  const hole = inside !== undefined && text.slice(inside.start, inside.end) === "_" ? inside : undefined
  const [from, to] =
    hole !== undefined
      ? [hole.start, hole.end]
      : inside !== undefined && at > inside.start && at < inside.end
        ? [nearer(inside, at), nearer(inside, at)]
        : [at, at]
  const before = text.slice(0, from)
  const after = text.slice(to)
  const column = from - (before.lastIndexOf("\n") + 1)
  const bracketed = /\s/.test(code) && !alone(before, after)
  const gapBefore = /(?:^|[\s([{,])$/.test(before) ? "" : " "
  const gapAfter = /^(?:$|[\s)\]},])/.test(after) ? "" : " "
  // What stands on further lines stays below where it begins.
  const space = " ".repeat(column + gapBefore.length + (bracketed ? 1 : 0))
  const lines = code.split("\n").join(`\n${space}`)
  return {from, to, insert: `${gapBefore}${bracketed ? `(${lines})` : lines}${gapAfter}`}
}

const nearer = (token: Token, at: number) => (at - token.start < token.end - at ? token.start : token.end)

/// Whether an expression stands by itself there: what is before it and behind it on its line does not take it apart.
function alone(before: string, after: string): boolean {
  return (
    /(?:^|\n|[([{,=]|->|<-|\$|\b(?:then|else|of|do|in|if|case))[ \t]*$/.test(before) &&
    /^[ \t]*(?:$|\n|[)\]},|]|\b(?:then|else|of|where)\b)/.test(after)
  )
}
