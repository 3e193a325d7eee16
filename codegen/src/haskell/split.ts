/// Cuts Haskell text into its top-level declarations, without parsing it.
///
/// A declaration starts in the first column; its comments stand above it, and equations of one name belong together with their
/// signature. Concatenating all pieces gives the text back, byte for byte.

export interface Piece {
  /// The text from the end of the piece before to the end of this one, so that nothing is lost between pieces.
  readonly start: number
  readonly end: number
  /// Where the declaration itself (with the comment directly above it) begins and ends; without blank lines around.
  readonly from: number
  readonly to: number
  /// `accelerate`, `Mode`; undefined for what only passes by: imports, pragmas, loose comments.
  readonly name: string | undefined
}

interface Line {
  readonly start: number
  readonly end: number
  readonly text: string
}

export function splitDeclarations(text: string): Piece[] {
  const chunks = chunksOf(linesOf(text))
  const pieces: Piece[] = []
  let start = 0
  for (const chunk of chunks) {
    const last = chunk.lines[chunk.lines.length - 1]
    const first = chunk.lines[0]
    if (first === undefined || last === undefined) continue
    pieces.push({
      start,
      end: last.end,
      from: first.start,
      to: last.start + last.text.replace(/\s+$/, "").length,
      name: chunk.name,
    })
    start = last.end
  }
  const final = pieces[pieces.length - 1]
  if (final === undefined)
    return text === "" ? [] : [{start: 0, end: text.length, from: 0, to: text.length, name: undefined}]
  return [...pieces.slice(0, -1), {...final, end: text.length}]
}

/// A hash of a declaration's text, to see whether it changed since its blocks were saved. (FNV-1a, 2 × 32 bits.)
export function hashOf(text: string): string {
  let a = 0x811c9dc5
  let b = 0x01000193
  for (let i = 0; i < text.length; i++) {
    const c = text.charCodeAt(i)
    a = Math.imul(a ^ c, 0x01000193)
    b = Math.imul(b ^ c, 0x85ebca6b)
  }
  return (a >>> 0).toString(16).padStart(8, "0") + (b >>> 0).toString(16).padStart(8, "0")
}

function linesOf(text: string): Line[] {
  const lines: Line[] = []
  let start = 0
  while (start < text.length) {
    const newline = text.indexOf("\n", start)
    const end = newline < 0 ? text.length : newline + 1
    lines.push({start, end, text: text.slice(start, newline < 0 ? text.length : newline)})
    start = end
  }
  return lines
}

interface Chunk {
  lines: Line[]
  name: string | undefined
}

function chunksOf(lines: readonly Line[]): Chunk[] {
  const chunks: Chunk[] = []
  let comments: Line[] = []
  let blanks: Line[] = []
  let blockComment = 0
  const flush = () => {
    if (comments.length > 0) chunks.push({lines: comments, name: undefined})
    comments = []
  }
  for (const line of lines) {
    const inside = blockComment > 0
    blockComment = Math.max(0, blockComment + nesting(line.text))
    const current = chunks[chunks.length - 1]
    if (inside || /^\{-/.test(line.text)) {
      if (blanks.length > 0 && !inside) flush()
      comments.push(...(inside ? blanks : []), line)
      blanks = []
    } else if (line.text.trim() === "") {
      blanks.push(line)
    } else if (/^--(?![!#$%&*+./<=>?@\\^|~:])|^--+ ?\|/.test(line.text)) {
      if (blanks.length > 0) flush()
      blanks = []
      comments.push(line)
    } else if (/^\s/.test(line.text) && current !== undefined && comments.length === 0) {
      current.lines.push(...blanks, line)
      blanks = []
    } else {
      if (blanks.length > 0) flush()
      const name = nameOfLine(line.text)
      const joins =
        current !== undefined &&
        name !== undefined &&
        current.name === name &&
        !/^(?:data|newtype|type|class|instance)\b/.test(line.text)
      if (joins && current !== undefined && comments.length === 0) current.lines.push(...blanks, line)
      else {
        chunks.push({lines: [...comments, line], name})
        comments = []
      }
      blanks = []
    }
  }
  flush()
  return chunks
}

function nesting(text: string): number {
  const code = text.replace(/"(?:[^"\\]|\\.)*"/g, '""')
  return (code.match(/\{-/g) ?? []).length - (code.match(/-\}/g) ?? []).length
}

function nameOfLine(text: string): string | undefined {
  if (/^(?:module|import|infix[lr]?|deriving|foreign|default|instance|class)\b|^#/.test(text))
    return undefined
  const type = /^(?:data|newtype|type)\s+(?:\w+\s+)*?(\p{Lu}[\p{L}\p{N}_']*)/u.exec(text)
  if (type !== null) return type[1]
  const operator = /^\(([!#$%&*+./<=>?@\\^|~:-]+)\)/.exec(text)
  if (operator !== null) return operator[1]
  const infix = /^[\p{Ll}_][\p{L}\p{N}_']*\s+([!#$%&*+./<>?@\\^|~:-][!#$%&*+./<=>?@\\^|~:-]*)\s/u.exec(text)
  if (infix !== null && !["::", "|", "@", "="].includes(infix[1] ?? "")) return infix[1]
  return /^[\p{Ll}_][\p{L}\p{N}_']*/u.exec(text)?.[0]
}
