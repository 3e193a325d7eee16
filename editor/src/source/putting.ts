/// Where a piece of Haskell goes that is let fall on the text: a definition between definitions, steps on lines of their own, anything else at the word under the
/// pointer, in brackets where it needs them. Pure.

import {type Token, tokens} from "./lexer.ts"

export interface Code {
  readonly text: string
  readonly as: "definition" | "steps" | "part"
}

/// A change of the text, and what to select in the text after it.
export interface Putting {
  readonly from: number
  readonly to: number
  readonly insert: string
  readonly select: {readonly start: number; readonly end: number}
}

export function putting(text: string, at: number, code: Code): Putting {
  const made =
    code.as === "definition"
      ? definition(text, at, code.text)
      : code.as === "steps"
        ? steps(text, at, code.text)
        : part(text, at, code.text)
  return {...made, select: firstHole(made)}
}

type Change = Omit<Putting, "select">

/// The first place that is still open, or behind all of it.
function firstHole({from, insert}: Change): Putting["select"] {
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
function definition(text: string, at: number, code: string): Change {
  const lines = linesOf(text)
  let line = lineAt(lines, at)
  const endsBefore = (n: number) => {
    if (!isBlank(lines[n])) return false
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
function part(text: string, at: number, code: string): Change {
  const all = tokens(text)
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
