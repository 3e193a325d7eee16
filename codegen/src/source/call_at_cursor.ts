/// Function call at the cursor: the function whose arguments are being written, and which argument. Pure: works on tokens and brackets instead of a syntax tree, so that
/// it works on unfinished lines.

import {type Token, tokens} from "./lexer.ts"

export interface Call {
  readonly name: string
  /// Counted from 0.
  readonly argument: number
}

interface Frame {
  head: string | null
  args: number
  /// The column of the line on which its head stands.
  column: number
}

/// The innermost call around the end of `before`; `null` when there is none. `before` begins at the margin.
export function callAt(before: string): Call | null {
  const stack: Frame[] = [{head: null, args: 0, column: 0}]
  let lineStart = 0
  let at = 0
  for (const piece of piecesOf(before)) {
    const gap = before.slice(at, piece.start)
    const newline = gap.lastIndexOf("\n")
    if (newline >= 0) {
      lineStart = at + newline + 1
      // A line that does not stand further in begins something else.
      const column = piece.start - lineStart
      const top = stack[stack.length - 1]
      if (top !== undefined && column <= top.column) stack.splice(1)
      replaceTop(stack, column <= (top?.column ?? 0) ? {head: null, args: 0, column} : null)
    }
    at = piece.end
    const word = before.slice(piece.start, piece.end)
    if (piece.kind === "open") {
      stack.push({head: null, args: 0, column: indentOf(before, lineStart)})
      continue
    }
    if (piece.kind === "close") {
      if (stack.length > 1) stack.pop()
      countAtom(stack, null, indentOf(before, lineStart))
      continue
    }
    if (piece.kind === "operator" || piece.kind === "keyword" || word === ",") {
      replaceTop(stack, {head: null, args: 0, column: indentOf(before, lineStart)})
      continue
    }
    if (piece.kind === "comment" || piece.kind === "pragma") continue
    countAtom(
      stack,
      piece.kind === "name" || piece.kind === "type" ? word : null,
      indentOf(before, lineStart),
    )
  }
  const top = stack[stack.length - 1]
  if (top === undefined || top.head === null || top.head === "") return null
  const writing = /[^\s]$/.test(before) && !/[([,]$/.test(before)
  if (writing && top.args === 0) return null
  return {name: top.head, argument: writing ? top.args - 1 : top.args}
}

type Piece = {
  readonly start: number
  readonly end: number
  readonly kind: Token["kind"] | "open" | "close" | "comma"
}

/// Words, and the brackets and commas between them.
function* piecesOf(text: string): Generator<Piece> {
  let at = 0
  const between = function* (to: number): Generator<Piece> {
    for (let i = at; i < to; i += 1) {
      const c = text[i] ?? " "
      if ("([{".includes(c)) yield {start: i, end: i + 1, kind: "open"}
      else if (")]}".includes(c)) yield {start: i, end: i + 1, kind: "close"}
      else if (c === ",") yield {start: i, end: i + 1, kind: "comma"}
    }
  }
  for (const token of tokens(text)) {
    yield* between(token.start)
    yield token
    at = token.end
  }
  yield* between(text.length)
}

function countAtom(stack: Frame[], word: string | null, column: number): void {
  const top = stack[stack.length - 1]
  if (top === undefined) return
  // What begins with brackets or a number is no name that we know.
  if (top.head === null) {
    top.head = word ?? ""
    top.column = column
  } else top.args += 1
}

function replaceTop(stack: Frame[], frame: Frame | null): void {
  if (frame !== null) stack[stack.length - 1] = frame
}

function indentOf(text: string, lineStart: number): number {
  return /^ */.exec(text.slice(lineStart))?.[0].length ?? 0
}

/// A type as its inputs and its answer: `A -> (B -> C) -> D` is `["A", "(B -> C)", "D"]`; what stands before `=>` is left out.
export function inputsOf(type: string): readonly string[] {
  const parts: string[] = []
  let depth = 0
  let from = type.includes("=>") ? type.indexOf("=>") + 2 : 0
  for (let i = from; i < type.length; i += 1) {
    const c = type[i] ?? ""
    if ("([".includes(c)) depth += 1
    else if (")]".includes(c)) depth -= 1
    else if (depth === 0 && type.startsWith("->", i)) {
      parts.push(type.slice(from, i).trim())
      from = i + 2
      i += 1
    }
  }
  return [...parts, type.slice(from).trim()]
}
