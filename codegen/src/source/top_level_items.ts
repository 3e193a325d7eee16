/// Top-level items of Haskell text by layout alone, and its comments.
///
/// An item starts at every line whose first token stands at the file's own margin (Haskell 2010 report §10.3), so an error inside one
/// item never reaches the next. Any text at all is accepted: each character belongs to an item or to a gap between two.

import {isClosed, isSymbol, type Range, tokenAt} from "./lexer.ts"

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
  readonly trouble?: "braces" | "directive" | undefined
}

export interface Lexed {
  readonly items: readonly Item[]
  readonly comments: readonly Comment[]
  /// Operators that start with two dashes, as `-->`: the grammar takes them for comments.
  readonly dashed: readonly Range[]
  /// The column at which items start; undefined where no item has set it.
  readonly margin: number | undefined
  /// Whether every comment and pragma has its end. The text behind one without an end is read as program text, up to the end of the file.
  readonly isClosed: boolean
}

interface LayoutToken extends Range {
  readonly kind: "word" | "string" | "pragma" | "directive" | "symbol"
  readonly firstOnLine: boolean
  /// Counted from 0, tabs to the next multiple of 8 (report §10.3).
  readonly column: number
}

/// The start of a quotation: `[sql|`, `[d|`, `[|` or `[||`. It ends at the next `|]`. GHC User's Guide, "Template Haskell quasi-quotation".
const quotation = /\[(?:(?:\p{Lu}[\p{L}\p{N}_']*\.)*[\p{Ll}_][\p{L}\p{N}_']*)?\|/uy

/// A token with its place in the layout. Of brackets and other characters that are no Haskell words each one is a token, and so is a quotation.
function scan(
  text: string,
  hasQuotations: boolean,
): {
  tokens: LayoutToken[]
  comments: Comment[]
  dashed: Range[]
  isEveryCommentClosed: boolean
} {
  let isEveryCommentClosed = true
  const dashed: Range[] = []
  const tokens: LayoutToken[] = []
  const comments: Comment[] = []
  // A byte order mark takes no column.
  const begin = text.startsWith("\uFEFF") ? 1 : 0
  let at = begin
  let lineStart = begin
  let first = true
  const passLines = (to: number): void => {
    const newline = text.lastIndexOf("\n", to - 1)
    if (newline >= at) lineStart = newline + 1
    at = to
  }
  const add = (kind: LayoutToken["kind"], end: number): void => {
    tokens.push({
      kind,
      start: at,
      end,
      firstOnLine: first,
      column: first ? columnOf(text, lineStart, at) : -1,
    })
    first = false
    if (kind === "word" || kind === "symbol") at = end
    else passLines(end)
  }
  /// The end of the quotation that starts here; undefined for none, also for one without an end.
  const endOfQuotation = (): number | undefined => {
    quotation.lastIndex = at
    const end = hasQuotations && quotation.test(text) ? text.indexOf("|]", quotation.lastIndex) : -1
    return end < 0 ? undefined : end + 2
  }
  const addBetween = (to: number): void => {
    while (at < to) {
      const c = text[at] ?? ""
      const end = c === "[" ? endOfQuotation() : undefined
      if (end !== undefined) {
        add("string", end)
        continue
      }
      if (c === "\n") {
        at++
        lineStart = at
        first = true
      } else if (c === " " || /\s/.test(c)) at++
      else add("symbol", at + ((text.codePointAt(at) ?? 0) > 0xffff ? 2 : 1))
    }
  }
  for (let token = tokenAt(text, at); token !== null; token = tokenAt(text, at)) {
    addBetween(token.start)
    const {kind, start, end} = token
    // The token stands in a quotation.
    if (at > start) continue
    if (kind === "comment") {
      if (text[start] === "-") comments.push({kind: "line", start, end: beforeReturn(text, end)})
      else if (isClosed(text, token)) comments.push({kind: "block", start, end})
      // The text behind a comment that is not closed is read as program text.
      if (text[start] === "-" || isClosed(text, token)) passLines(end)
      else {
        isEveryCommentClosed = false
        add("symbol", start + 2)
      }
    } else if (kind === "pragma") {
      if (isClosed(text, token)) add("pragma", end)
      else {
        isEveryCommentClosed = false
        add("symbol", start + 2)
      }
    } else if (text[start] === "#" && start === lineStart && isDirective(text, start)) {
      const newline = text.indexOf("\n", start)
      add("directive", newline === -1 ? text.length : newline)
    } else if (kind === "string")
      add("string", /["']$/.test(text.slice(start + 1, end)) ? end : beforeReturn(text, end))
    else {
      if (kind === "operator" && text.startsWith("--", start)) dashed.push({start, end})
      add(kind === "operator" ? "symbol" : "word", end)
    }
  }
  addBetween(text.length)
  return {tokens, comments, dashed, isEveryCommentClosed}
}

/// The end of a token at the end of its line, without the `\r` of a Windows line ending.
function beforeReturn(text: string, end: number): number {
  return text[end - 1] === "\r" && (end === text.length || text[end] === "\n") ? end - 1 : end
}

/// A line of the C preprocessor, or the `#!` line of a script.
function isDirective(text: string, at: number): boolean {
  return /^#(?:!|\s*(?:if|ifdef|ifndef|elif|else|endif|define|undef|include|error|warning|line)\b)/.test(
    text.slice(at, at + 40),
  )
}

/// Column of an offset in its line, from 0; tabs go to the next multiple of 8 (report §10.3).
function columnOf(text: string, lineStart: number, at: number): number {
  let column = 0
  for (let i = lineStart; i < at; i++) column = text[i] === "\t" ? column + 8 - (column % 8) : column + 1
  return column
}

// A line at the margin that starts with one of these can only go on with what stands above it. Haskell itself refuses most of them
// there; keeping the lines together shows the learner one broken definition instead of two.
const continues = new Set([")", "]", "}", ",", ";", "=", "|", "->", "then", "else", "of", "in", "where"])

/// The top-level items of a file, and its comments. `marginAbove` is the margin of the file when `text` is what follows some of its definitions.
/// `hasUnicodeSyntax`: `∷` stands between a name and its type, too. `hasQuotations`: what stands between `[name|` and `|]` is no Haskell.
export function lex(
  text: string,
  marginAbove?: number,
  hasUnicodeSyntax = isUnicodeSyntaxOn(text),
  hasQuotations = areQuotationsOn(text),
): Lexed {
  const {tokens, comments, dashed, isEveryCommentClosed} = scan(text, hasQuotations)
  const items: Item[] = []
  // Items that stand deeper than the margin behind a directive: they belong to a definition above it.
  const continuations = new Set<number>()
  let margin = marginAbove
  let open: {start: number; kind: ItemKind; tokens: LayoutToken[]} | undefined
  // Inside `module … where` nothing starts an item.
  let inModule = false

  const close = (): void => {
    const last = open?.tokens[open.tokens.length - 1]
    if (open === undefined || last === undefined) return
    items.push({
      kind: open.kind,
      start: open.start,
      end: last.end,
      ...nameOf(text, open.tokens, hasUnicodeSyntax),
    })
    open = undefined
  }

  for (const [i, t] of tokens.entries()) {
    const word = text.slice(t.start, t.end)
    if (inModule) {
      open?.tokens.push(t)
      if (word === "where") {
        inModule = false
        margin = undefined
        close()
      }
      continue
    }
    const standing = t.kind === "pragma" || t.kind === "directive"
    if (margin === undefined && !standing && word !== "module") {
      if (word === "{") {
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
        return {items, comments, dashed, margin, isClosed: isEveryCommentClosed}
      }
      margin = t.firstOnLine ? t.column : columnOf(text, lineStartOf(text, t.start), t.start)
      close()
      open = {start: t.start, kind: word === "import" ? "import" : "declaration", tokens: [t]}
      continue
    }
    const starts =
      t.kind === "directive" ||
      (t.firstOnLine && t.column <= (margin ?? 0) && (open === undefined || !continues.has(word))) ||
      open === undefined
    if (!starts) {
      open?.tokens.push(t)
      if (t.kind === "pragma" && open !== undefined && open.tokens.length === 1) close()
      continue
    }
    close()
    if (t.firstOnLine && t.column > (margin ?? t.column) && items.at(-1)?.kind === "directive")
      continuations.add(items.length)
    const kind: ItemKind =
      t.kind === "pragma" || t.kind === "directive"
        ? t.kind
        : word === "import" || word === "module"
          ? word
          : "declaration"
    open = {start: t.start, kind, tokens: [t]}
    inModule = kind === "module" && items.every(item => item.kind !== "declaration" && item.kind !== "import")
    // A pragma or a directive is an item of its own, whatever stands behind it.
    if (standing && (tokens[i + 1]?.firstOnLine ?? true)) close()
  }
  close()
  return {
    items: withContinuations(text, items, continuations),
    comments,
    dashed,
    margin,
    isClosed: isEveryCommentClosed,
  }
}

/// The items with each definition that goes on behind directives as one, with these.
function withContinuations(
  text: string,
  items: readonly Item[],
  continuations: ReadonlySet<number>,
): readonly Item[] {
  if (continuations.size === 0) return items
  const joined: Item[] = []
  for (const [i, item] of items.entries()) {
    const at = continuations.has(i)
      ? joined.findLastIndex(other => other.kind !== "directive")
      : joined.length - 1
    const owner = joined[at]
    const joins =
      owner?.kind === "declaration" &&
      (continuations.has(i) ||
        (item.kind === "directive" &&
          owner.trouble === "directive" &&
          openConditions(text.slice(owner.start, owner.end)) > 0))
    if (joins) joined.splice(at, joined.length - at, {...owner, end: item.end, trouble: "directive"})
    else joined.push(item)
  }
  return joined
}

/// How many conditions of the preprocessor begin in a text and do not end in it.
function openConditions(text: string): number {
  return (text.match(/^#\s*if/gm)?.length ?? 0) - (text.match(/^#\s*endif/gm)?.length ?? 0)
}

const keywords = new Set(
  "class data default deriving foreign import infix infixl infixr instance module newtype pattern type".split(
    " ",
  ),
)

/// `f` of `f x = …`, `x <+> y = …` defines `<+>`; the type of a `data`, `newtype` or `type`.
function nameOf(
  text: string,
  tokens: readonly LayoutToken[],
  hasUnicodeSyntax: boolean,
): {name: string; signature: boolean; type: boolean} {
  const word = (i: number): string => wordOf(text, tokens[i], hasUnicodeSyntax)
  const named = (name: string, next: number) => ({name, signature: word(next) === "::", type: false})
  const noHead = {name: "", signature: false, type: false}
  // A type for several operators at once belongs to none of them.
  if (word(0) === "(" && word(2) === ")" && isSymbol(word(1)))
    return word(3) === "," ? noHead : named(word(1), 3)
  const head = word(0)
  if (["data", "newtype", "type"].includes(head))
    return {name: /^\p{Lu}/u.test(word(1)) ? word(1) : "", signature: false, type: true}
  if (keywords.has(head)) return noHead
  const operator = operatorDefined(text, tokens, hasUnicodeSyntax)
  if (operator !== undefined) return {name: operator, signature: false, type: false}
  const isName = tokens[0]?.kind === "word" && /^[\p{Ll}\p{Lo}_]/u.test(head)
  return isName && word(1) !== "," && word(1) !== "@" ? named(head, 1) : noHead
}

/// The text of a token; empty for none.
function wordOf(text: string, token: LayoutToken | undefined, hasUnicodeSyntax: boolean): string {
  const word = token === undefined ? "" : text.slice(token.start, token.end)
  return hasUnicodeSyntax && word === "∷" ? "::" : word
}

/// Whether a text switches on the extension UnicodeSyntax.
export function isUnicodeSyntaxOn(text: string): boolean {
  return text.includes("UnicodeSyntax") && /\{-#\s*LANGUAGE\b[^#]*\bUnicodeSyntax\b/i.test(text)
}

/// Whether a text switches on an extension with quotations.
export function areQuotationsOn(text: string): boolean {
  return /\{-#\s*LANGUAGE\b[^#]*\b(?:QuasiQuotes|TemplateHaskell(?:Quotes)?)\b/i.test(text)
}

/// Whether a text has lines of the C preprocessor that choose among others.
export function hasConditions(text: string): boolean {
  return /^#\s*(?:if|el|endif)/m.test(text)
}

/// The operator between the patterns of an equation, before its `=` or `|`; in `(f <+> g) x = …` it stands in brackets.
function operatorDefined(
  text: string,
  tokens: readonly LayoutToken[],
  hasUnicodeSyntax: boolean,
): string | undefined {
  let depth = 0
  let bracketed: string | undefined
  let closed: number | undefined
  for (const [i, t] of tokens.entries()) {
    const word = wordOf(text, t, hasUnicodeSyntax)
    if ("([{".includes(word)) depth++
    else if (")]}".includes(word)) {
      depth--
      if (depth === 0) closed ??= i
    } else if (depth === 0 && (word === "=" || word === "|" || word === "::"))
      return word !== "::" && closed !== undefined && closed < i - 1 ? bracketed : undefined
    else if (depth === 0 || (depth === 1 && closed === undefined && text[tokens[0]?.start ?? 0] === "(")) {
      const operator = i === 0 ? undefined : operatorAt(text, t, tokens[i + 1])
      if (operator !== undefined && depth === 0) return operator
      bracketed ??= operator
    }
  }
  return undefined
}

/// With a space behind it, a symbol is an operator; without, a mark on the pattern that follows.
function operatorAt(text: string, t: LayoutToken, next: LayoutToken | undefined): string | undefined {
  const word = text.slice(t.start, t.end)
  if (word === "`" && next !== undefined) {
    const name = text.slice(next.start, next.end)
    return /^[\p{Ll}\p{Lo}_]/u.test(name) ? name : undefined
  }
  const isOperator =
    t.kind === "symbol" && isSymbol(word) && !word.startsWith(":") && !/^(?:<-|->|\\|@|~)$/.test(word)
  return isOperator && /\s/.test(text[t.end] ?? " ") ? word : undefined
}

function lineStartOf(text: string, at: number): number {
  return Math.max(text.lastIndexOf("\n", at - 1) + 1, text.startsWith("\uFEFF") ? 1 : 0)
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
