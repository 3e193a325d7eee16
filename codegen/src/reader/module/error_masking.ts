/// Error masking: candidates for the place of a syntax error, so that the rest of a broken definition can be read.
///
/// In: the source of one declaration. Out: ranges that hold whole parts by layout (a step, an alternative, what stands behind `=`, `->` or `<-`), the
/// likeliest first. A range is masked by one name in its place; every other character keeps its offset.

import type {Range} from "../../source/lexer.ts"
import {tokens} from "../../source/lexer.ts"

/// Each candidate costs a run of the parser.
const maximumCandidates = 12

/// A guard, a `where`, a further field or an operator begins no expression, although a name in its place may be read as one: as an argument of what is above it.
const noExpression = /^(?:[,;)\]}:*/&%.?#@]|\p{S}|->|(?:where|of|then|else|in|deriving)\b)/u

export function maskCandidates(source: string): readonly Range[] {
  const regions = regionsOf(source)
  const suspicious = regions.filter(r => !isBalanced(source.slice(r.start, r.end)))
  const ordered = [...suspicious, ...regions.filter(r => !suspicious.includes(r))]
  const found = new Map<string, Range>()
  for (const region of ordered)
    for (const range of [
      withoutWhere(source, behindSign(source, region)),
      behindSign(source, region),
      region,
    ])
      if (range !== undefined && range.end > range.start && !noExpression.test(source.slice(range.start)))
        found.set(`${range.start} ${range.end}`, range)
  return [...found.values()].slice(0, maximumCandidates)
}

/// The source with a name in place of a range. Line ends stay, so that the layout below is as it was.
export function masked(source: string, {start, end}: Range): string {
  return `${source.slice(0, start)}a${source.slice(start + 1, end).replace(/[^\n]/g, " ")}${source.slice(end)}`
}

/// Each line with those below it that are indented further; the shortest first.
function regionsOf(source: string): Range[] {
  const lines: {start: number; end: number; indent: number}[] = []
  let at = 0
  for (const line of source.split("\n")) {
    const indent = line.length - line.trimStart().length
    if (line.trim() !== "") lines.push({start: at + indent, end: at + line.trimEnd().length, indent})
    at += line.length + 1
  }
  const regions = lines.map((line, i) => {
    let last = i
    while ((lines[last + 1]?.indent ?? -1) > line.indent) last++
    return {start: line.start, end: lines[last]?.end ?? line.end}
  })
  return regions.sort((a, b) => a.end - a.start - (b.end - b.start))
}

/// What stands behind the last `=`, `->` or `<-` of a region's first line that is in no brackets.
function behindSign(source: string, region: Range): Range | undefined {
  const newline = source.indexOf("\n", region.start)
  const line = source.slice(region.start, newline === -1 ? region.end : Math.min(newline, region.end))
  let sign: number | undefined
  for (const t of tokens(line)) {
    const word = line.slice(t.start, t.end)
    if (t.kind === "operator" && ["=", "->", "<-"].includes(word)) sign ??= t.end
  }
  if (sign === undefined) return undefined
  const behind = source.slice(region.start + sign, region.end)
  return {start: region.start + sign + behind.length - behind.trimStart().length, end: region.end}
}

function withoutWhere(source: string, range: Range | undefined): Range | undefined {
  const where = range === undefined ? -1 : source.slice(range.start, range.end).search(/\n[ \t]+where\b/)
  return range === undefined || where <= 0 ? undefined : {start: range.start, end: range.start + where}
}

/// Whether brackets close in order and no text is left open.
function isBalanced(text: string): boolean {
  const open: string[] = []
  let at = 0
  const closing: {readonly [open: string]: string} = {"(": ")", "[": "]", "{": "}"}
  const between = (to: number): boolean => {
    for (const c of text.slice(at, to)) {
      const close = closing[c]
      if (close !== undefined) open.push(close)
      else if (")]}".includes(c) && open.pop() !== c) return false
    }
    return true
  }
  for (const t of tokens(text)) {
    if (!between(t.start)) return false
    if (t.kind === "string" && !/^(".*"|'.*')$/s.test(text.slice(t.start, t.end))) return false
    at = t.end
  }
  return between(text.length) && open.length === 0
}
