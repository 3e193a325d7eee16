/// Indentation by Haskell's layout rule (Haskell 2010 report §2.7): the column of a new line, and of a line that starts with a keyword that belongs to a line above
/// (`where`, `|`, `else`). Pure, except for the CodeMirror extension at the end.

import {indentOnInput, indentService, indentUnit} from "@codemirror/language"
import {EditorState, type Extension} from "@codemirror/state"
import {tokens} from "@rosy/codegen"

/// Columns that something inside something stands further in.
const step = 2

interface Line {
  readonly indent: number
  /// Without comments and space at its ends.
  readonly code: string
}

/// The column for the line below `above`, which is `start` as far as it is there.
export function indentBelow(above: readonly string[], start: string): number {
  const lines = codeOf(above)
  const last = lines[lines.length - 1]
  if (last === undefined) return 0
  const word = /^\s*(\|(?!\|)|where\b|then\b|else\b|in\b|deriving\b|[)\]}])/.exec(start)?.[1]
  if (word !== undefined) return indentOf(word, lines) ?? start.search(/\S/)
  // After an empty line something new begins, at the margin.
  if (above.length > 0 && (above[above.length - 1] ?? "").trim() === "") return 0
  return below(last, lines)
}

/// The lines that hold code; comments keep a line's place but count as nothing in it.
function codeOf(above: readonly string[]): Line[] {
  const text = above.join("\n")
  let plain = text
  for (const t of tokens(text))
    if (t.kind === "comment" || t.kind === "pragma" || t.kind === "string")
      plain =
        plain.slice(0, t.start) +
        text.slice(t.start, t.end).replace(/[^\n]/g, t.kind === "string" ? "s" : " ") +
        plain.slice(t.end)
  return plain.split("\n").flatMap((line, i): Line[] => {
    const code = line.trim()
    const indent = (above[i] ?? "").search(/\S|$/)
    return code === "" ? ((above[i] ?? "").trim() === "" ? [] : [{indent, code: ""}]) : [{indent, code}]
  })
}

const opensAtEnd =
  /(?:^|[\s([{,])(?:do|of|where|let|then|else|in|if|case)$|[=({[,]$|[!#$%&*+./<>?^|~:-]$|\\case$/

function below(last: Line, lines: readonly Line[]): number {
  const {indent, code} = last
  if (code === "") return indent
  const signature = signatureStart(lines)
  if (signature !== undefined) {
    // The parts of a long type stand below each other; its definition stands below its name.
    if (/(?:->|=>|::)$/.test(code)) return signature === last ? indent + step : indent
    return signature.indent
  }
  if (opensAtEnd.test(code)) return indent + step
  // What follows `do`, `of` or `where` on its line has set the column of its block.
  const block = /^(?:.*\s)?(do|of|where)\s+(?=\S)(?!.*\b(?:do|of|where)\b)/.exec(code)
  if (block !== null && !/[([{][^)\]}]*$/.test(code)) return indent + block[0].length
  const depth = openBrackets(code)
  if (depth > 0) return indent + step
  if (depth < 0) return indentWhereOpened(lines)
  return isHead(last) ? indent + step : indent
}

/// The line on which the signature began that the last line belongs to.
function signatureStart(lines: readonly Line[]): Line | undefined {
  for (let i = lines.length - 1; i >= 0; i -= 1) {
    const line = lines[i]
    if (line === undefined) return undefined
    if (/^(?:[\p{Ll}_][\p{L}\p{N}_']*|\([^\s()]+\))(?:\s*,\s*[\p{L}\p{N}_']+)*\s*::/u.test(line.code))
      return line
    // Above the last line only lines that go on below belong to it.
    if (!/^(?:->|=>|::)/.test(lines[i]?.code ?? "") && !/(?:->|=>|::)$/.test(lines[i - 1]?.code ?? ""))
      return undefined
  }
  return undefined
}

/// The left side of an equation whose right side is still to come: conditions, or `=` on a line of its own.
function isHead({indent, code}: Line): boolean {
  return (
    indent === 0 &&
    /^[\p{Ll}_(]/u.test(code) &&
    !/(?:^|[^!#$%&*+./<=>?@\\^|~:-])(?:=|::|<-|->)(?![!#$%&*+./<=>?@\\^|~:-])/.test(code) &&
    !/^(?:import|module|data|newtype|type|class|instance|infix[lr]?|deriving|default|foreign)\b/.test(code)
  )
}

function openBrackets(code: string): number {
  let depth = 0
  for (const c of code) depth += "([{".includes(c) ? 1 : ")]}".includes(c) ? -1 : 0
  return depth
}

/// The column of the line on which the bracket was opened that the last line closes.
function indentWhereOpened(lines: readonly Line[]): number {
  let depth = 0
  for (let i = lines.length - 1; i >= 0; i -= 1) {
    depth += openBrackets(lines[i]?.code ?? "")
    if (depth >= 0) return lines[i]?.indent ?? 0
  }
  return 0
}

/// The column for a line that begins with a word that belongs to something above; undefined when there is no such thing.
function indentOf(word: string, lines: readonly Line[]): number | undefined {
  switch (word) {
    case "|": {
      const same = enclosing(lines, line => /^[|=](?![|=])/.test(line.code))
      return same?.indent ?? (enclosing(lines, isAnything)?.indent ?? 0) + step
    }
    case "where":
    case "deriving": {
      // Beside the conditions of the same definition, else inside it.
      const condition = enclosing(lines, line => line.code.startsWith("|"))
      return condition?.indent ?? (margin(lines)?.indent ?? 0) + step
    }
    case "then":
    case "else": {
      const partner = enclosing(lines, line => (word === "else" ? /^then\b/ : /^if\b/).test(line.code))
      if (word === "else" && partner !== undefined) return partner.indent
      const opener = nearest(lines, /\bif\b/)
      return opener === undefined ? undefined : opener.indent + step
    }
    case "in": {
      const opener = nearest(lines, /\blet\b/)
      return opener === undefined ? undefined : opener.indent + opener.code.search(/\blet\b/)
    }
    default:
      // A closing bracket stands below the line that opened it.
      return indentWhereOpened([...lines, {indent: 0, code: word}])
  }
}

const isAnything = () => true

/// The nearest line above that satisfies a claim and encloses, or stands beside, all lines below it.
function enclosing(lines: readonly Line[], claim: (line: Line) => boolean): Line | undefined {
  let least = Number.POSITIVE_INFINITY
  for (let i = lines.length - 1; i >= 0; i -= 1) {
    const line = lines[i]
    if (line === undefined || line.indent > least) continue
    least = line.indent
    if (claim(line)) return line
    if (line.indent === 0) return undefined
  }
  return undefined
}

/// The nearest line above, in the same definition, that says a word.
function nearest(lines: readonly Line[], word: RegExp): Line | undefined {
  for (let i = lines.length - 1; i >= 0; i -= 1) {
    const line = lines[i]
    if (line === undefined || word.test(line.code) || line.indent === 0)
      return line !== undefined && word.test(line.code) ? line : undefined
  }
  return undefined
}

function margin(lines: readonly Line[]): Line | undefined {
  return enclosing(lines, line => line.indent === 0)
}

/// Lines further up than this are not looked at.
const most = 200

export const indentation: Extension = [
  indentUnit.of(" ".repeat(step)),
  indentService.of((context, pos) => {
    const {doc} = context.state
    const at = doc.lineAt(pos)
    // While Enter is pressed the line is broken at `pos`, and what stands before it is above.
    const broken = context.simulatedBreak === pos
    const first = Math.max(1, at.number - most)
    const above: string[] = []
    for (let n = first; n < at.number; n += 1) above.push(doc.line(n).text)
    if (broken) above.push(at.text.slice(0, pos - at.from))
    return indentBelow(above, broken ? at.text.slice(pos - at.from) : at.text)
  }),
  // A line finds its place as soon as its first word is there.
  EditorState.languageData.of(() => [{indentOnInput: /^\s*(?:\||where|deriving|(?:then|else|in) )$/}]),
  indentOnInput(),
]
