/// Splits Haskell text into top-level items by layout alone, and finds its comments.
///
/// An item starts at every line whose first token stands at the file's own margin (Haskell 2010 report §10.3), so an error inside one
/// item never reaches the next. Any text at all is accepted: each character belongs to an item or to a gap between two.

/// Offsets are in UTF-16 units; `end` is exclusive.
export interface Range {
  readonly start: number
  readonly end: number
}

export interface Comment extends Range {
  readonly kind: "line" | "block"
}

export type ItemKind = "module" | "import" | "pragma" | "directive" | "declaration"

/// One top-level item, from its first token to the end of its last, comments around it not included.
export interface Item extends Range {
  readonly kind: ItemKind
  /// The name it seems to define, judged by its first words; empty when it does not start with a name.
  readonly name: string
  /// It gives a type: `f :: …`.
  readonly signature: boolean
  /// It defines a type: `data`, `newtype`, `type`.
  readonly type: boolean
  /// Why it was not taken apart, if so.
  readonly trouble?: "braces" | undefined
}

export interface Lexed {
  readonly items: readonly Item[]
  readonly comments: readonly Comment[]
  /// Operators that start with two dashes, as `-->`: the grammar takes them for comments.
  readonly dashed: readonly Range[]
}

interface Token extends Range {
  readonly kind: "word" | "string" | "pragma" | "directive" | "symbol"
  readonly firstOnLine: boolean
  /// Counted from 0, tabs to the next multiple of 8 (report §10.3).
  readonly column: number
}

const word = /[\p{L}_][\p{L}\p{N}\p{M}_']*/uy
const digits = /\d[\w.']*/uy
const character = /'(?:\\(?:[^'\n]|'(?='))[^'\n]*|[^\\'\n]{1,2})'/uy
const symbols = /[!#$%&*+./<=>?@\\^|~:\-\p{S}\p{P}]/u
const notSymbols = new Set(["(", ")", "[", "]", "{", "}", ",", ";", "`", "'", '"', "_"])

function isSymbol(c: string | undefined): boolean {
  return c !== undefined && symbols.test(c) && !notSymbols.has(c)
}

/// All tokens and comments in order. Words, strings and pragmas are whole; of other symbols each character is a token.
function scan(text: string): {tokens: Token[]; comments: Comment[]; dashed: Range[]} {
  const dashed: Range[] = []
  const tokens: Token[] = []
  const comments: Comment[] = []
  // A byte order mark takes no column.
  let at = text.startsWith("\uFEFF") ? 1 : 0
  let lineStart = at
  let first = true
  let columns = {from: lineStart, to: lineStart, column: 0}

  const column = (): number => {
    if (columns.from !== lineStart || columns.to > at) columns = {from: lineStart, to: lineStart, column: 0}
    let {to, column: n} = columns
    for (; to < at; to++) n = text[to] === "\t" ? n + 8 - (n % 8) : n + 1
    columns = {from: lineStart, to, column: n}
    return n
  }
  const token = (kind: Token["kind"], end: number): void => {
    tokens.push({kind, start: at, end, firstOnLine: first, column: first ? column() : -1})
    first = false
    passLines(end)
  }
  const passLines = (end: number): void => {
    for (let i = text.indexOf("\n", at); i !== -1 && i < end; i = text.indexOf("\n", i + 1)) lineStart = i + 1
    at = end
  }
  const match = (pattern: RegExp): number | undefined => {
    pattern.lastIndex = at
    return pattern.test(text) ? pattern.lastIndex : undefined
  }

  while (at < text.length) {
    const c = text[at] ?? ""
    if (c === "\n") {
      at++
      lineStart = at
      first = true
    } else if (/\s|\uFEFF/u.test(c)) at++
    else if (c === "{" && text[at + 1] === "-") {
      const end = blockEnd(text, at)
      if (end === undefined) token("symbol", at + 2)
      else if (text[at + 2] === "#") token("pragma", end)
      else {
        comments.push({kind: "block", start: at, end})
        passLines(end)
      }
    } else if (c === "-" && text[at + 1] === "-" && isLineComment(text, at)) {
      const newline = text.indexOf("\n", at)
      const end = newline === -1 ? text.length : text[newline - 1] === "\r" ? newline - 1 : newline
      comments.push({kind: "line", start: at, end})
      at = end
    } else if (c === "#" && at === lineStart && isDirective(text, at)) {
      const newline = text.indexOf("\n", at)
      token("directive", newline === -1 ? text.length : newline)
    } else if (c === '"') token("string", stringEnd(text, at))
    else {
      const end = c === "'" ? match(character) : (match(word) ?? match(digits))
      if (end !== undefined) token(c === "'" ? "string" : "word", end)
      else if (isSymbol(c)) {
        let i = at
        while (isSymbol(text[i])) i++
        if (c === "-" && text[at + 1] === "-") dashed.push({start: at, end: i})
        token("symbol", i)
      } else token("symbol", at + (text.codePointAt(at)! > 0xffff ? 2 : 1))
    }
  }
  return {tokens, comments, dashed}
}

/// Two dashes or more start a comment unless another symbol follows: `-->` is an operator (report §2.3).
function isLineComment(text: string, at: number): boolean {
  if (at > 0 && isSymbol(text[at - 1])) return false
  let i = at
  while (text[i] === "-") i++
  return !isSymbol(text[i])
}

/// A line of the C preprocessor, or the `#!` line of a script.
function isDirective(text: string, at: number): boolean {
  return /^#(?:!|\s*(?:if|ifdef|ifndef|elif|else|endif|define|undef|include|error|warning|line)\b)/.test(
    text.slice(at, at + 40),
  )
}

function blockEnd(text: string, at: number): number | undefined {
  let depth = 0
  for (let i = at; i < text.length - 1; i++) {
    if (text[i] === "{" && text[i + 1] === "-") {
      depth++
      i++
    } else if (text[i] === "-" && text[i + 1] === "}") {
      depth--
      i++
      if (depth === 0) return i + 1
    }
  }
  return undefined
}

/// Past the closing quote, or to the end of the line where there is none. A gap (`\`, white space, `\`) may cross lines.
function stringEnd(text: string, at: number): number {
  for (let i = at + 1; i < text.length; i++) {
    const c = text[i]
    if (c === '"') return i + 1
    if (c === "\n") return text[i - 1] === "\r" ? i - 1 : i
    if (c === "\\") {
      let gap = i + 1
      while (/\s/.test(text[gap] ?? "x")) gap++
      if (gap > i + 1 && text[gap] === "\\") i = gap
      else if (gap === i + 1) i++
    }
  }
  return text.length
}

// A line at the margin that starts with one of these can only go on with what stands above it. Haskell itself refuses most of them
// there; keeping the lines together shows the learner one broken definition instead of two.
const continues = new Set([")", "]", "}", ",", ";", "=", "|", "->", "then", "else", "of", "in", "where"])

/// The top-level items of a file, and its comments.
export function lex(text: string): Lexed {
  const {tokens, comments, dashed} = scan(text)
  const items: Item[] = []
  let margin: number | undefined
  let open: {start: number; kind: ItemKind; tokens: Token[]} | undefined
  // Inside `module … where` nothing starts an item.
  let inModule = false

  const close = (): void => {
    const last = open?.tokens[open.tokens.length - 1]
    if (open === undefined || last === undefined) return
    items.push({kind: open.kind, start: open.start, end: last.end, ...nameOf(text, open.tokens)})
    open = undefined
  }

  for (const [i, t] of tokens.entries()) {
    const said = text.slice(t.start, t.end)
    if (inModule) {
      open?.tokens.push(t)
      if (said === "where") {
        inModule = false
        margin = undefined
        close()
      }
      continue
    }
    const standing = t.kind === "pragma" || t.kind === "directive"
    if (margin === undefined && !standing && said !== "module") {
      if (said === "{") {
        close()
        const last = tokens[tokens.length - 1] ?? t
        items.push({
          kind: "declaration",
          start: t.start,
          end: last.end,
          name: "",
          signature: false,
          type: false,
          trouble: "braces",
        })
        return {items, comments, dashed}
      }
      margin = t.firstOnLine ? t.column : columnOf(text, t.start)
      close()
      open = {start: t.start, kind: said === "import" ? "import" : "declaration", tokens: [t]}
      continue
    }
    const starts =
      t.kind === "directive" ||
      (t.firstOnLine && t.column <= (margin ?? 0) && (open === undefined || !continues.has(said))) ||
      open === undefined
    if (!starts) {
      open?.tokens.push(t)
      if (t.kind === "pragma" && open !== undefined && open.tokens.length === 1) close()
      continue
    }
    close()
    const kind: ItemKind =
      t.kind === "pragma" || t.kind === "directive"
        ? t.kind
        : said === "import" || said === "module"
          ? said
          : "declaration"
    open = {start: t.start, kind, tokens: [t]}
    inModule = kind === "module" && items.every(item => item.kind !== "declaration" && item.kind !== "import")
    // A pragma or a directive is an item of its own, whatever stands behind it.
    if (standing && (tokens[i + 1]?.firstOnLine ?? true)) close()
  }
  close()
  return {items, comments, dashed}
}

function columnOf(text: string, at: number): number {
  const start = Math.max(text.lastIndexOf("\n", at - 1) + 1, text.startsWith("\uFEFF") ? 1 : 0)
  let column = 0
  for (let i = start; i < at; i++) column = text[i] === "\t" ? column + 8 - (column % 8) : column + 1
  return column
}

const keywords = new Set(
  "class data default deriving foreign import infix infixl infixr instance module newtype pattern type".split(
    " ",
  ),
)

/// `f` of `f x = …`, `x <+> y = …` defines `<+>`; the type of a `data`, `newtype` or `type`.
function nameOf(text: string, tokens: readonly Token[]): {name: string; signature: boolean; type: boolean} {
  const said = (i: number): string => {
    const t = tokens[i]
    return t === undefined ? "" : text.slice(t.start, t.end)
  }
  const named = (name: string, next: number) => ({name, signature: said(next) === "::", type: false})
  const nobody = {name: "", signature: false, type: false}
  if (said(0) === "(" && said(2) === ")" && isSymbol(said(1)[0])) return named(said(1), 3)
  const head = said(0)
  if (["data", "newtype", "type"].includes(head))
    return {name: /^\p{Lu}/u.test(said(1)) ? said(1) : "", signature: false, type: true}
  if (keywords.has(head)) return nobody
  const operator = operatorDefined(text, tokens)
  if (operator !== undefined) return {name: operator, signature: false, type: false}
  const isName = tokens[0]?.kind === "word" && /^[\p{Ll}\p{Lo}_]/u.test(head)
  return isName && said(1) !== "," && said(1) !== "@" ? named(head, 1) : nobody
}

/// The operator between the patterns of an equation, before its `=` or `|`; in `(f <+> g) x = …` it stands in brackets.
function operatorDefined(text: string, tokens: readonly Token[]): string | undefined {
  let depth = 0
  let bracketed: string | undefined
  let closed: number | undefined
  for (const [i, t] of tokens.entries()) {
    const said = text.slice(t.start, t.end)
    if ("([{".includes(said)) depth++
    else if (")]}".includes(said)) {
      depth--
      if (depth === 0) closed ??= i
    } else if (depth === 0 && (said === "=" || said === "|" || said === "::"))
      return said !== "::" && closed !== undefined && closed < i - 1 ? bracketed : undefined
    else if (depth === 0 || (depth === 1 && closed === undefined && text[tokens[0]?.start ?? 0] === "(")) {
      const operator = i === 0 ? undefined : operatorAt(text, t, tokens[i + 1])
      if (operator !== undefined && depth === 0) return operator
      bracketed ??= operator
    }
  }
  return undefined
}

/// With a space behind it, a symbol is an operator; without, a mark on the pattern that follows.
function operatorAt(text: string, t: Token, next: Token | undefined): string | undefined {
  const said = text.slice(t.start, t.end)
  if (said === "`" && next !== undefined) {
    const name = text.slice(next.start, next.end)
    return /^[\p{Ll}\p{Lo}_]/u.test(name) ? name : undefined
  }
  const isOperator =
    t.kind === "symbol" && isSymbol(said[0]) && !said.startsWith(":") && !/^(?:<-|->|\\|@|~)$/.test(said)
  return isOperator && /\s/.test(text[t.end] ?? " ") ? said : undefined
}

/// A comment's lines without its marks.
export function wordsOf(text: string, kind: Comment["kind"]): string[] {
  if (kind === "line") return [text.replace(/^-- ?/, "").trimEnd()]
  const inner = text
    .slice(2, -2)
    .split(/\r?\n/)
    .map(l => l.trim())
  while (inner.length > 1 && inner[0] === "") inner.shift()
  while (inner.length > 1 && inner[inner.length - 1] === "") inner.pop()
  return inner
}
