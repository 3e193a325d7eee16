/// Lexer of Haskell text (Haskell 2010 report §2), for any text and fast enough for every key press: keywords, names, numbers, strings, comments. Brackets and
/// white space lie between the tokens. The layout of the file is read in `top_level_items.ts`.

/// Offsets are in UTF-16 units; `end` is exclusive.
export interface Range {
  readonly start: number
  readonly end: number
}

export type TokenKind =
  | "keyword"
  | "type"
  | "name"
  | "number"
  | "string"
  | "comment"
  | "operator"
  | "hole"
  | "pragma"

export interface Token extends Range {
  readonly kind: TokenKind
}

/// Haskell 2010 report §2.4, without those that a learner's program does not contain.
const keywords = new Set(
  "case class data default deriving do else if import in infix infixl infixr instance let module newtype of then type where".split(
    " ",
  ),
)

// Symbols of operators: report §2.2, with the symbols and punctuation of Unicode. (A set difference would need the `v` flag.)
const symbol = String.raw`(?![()[\]{},;\x60'"_])[\p{S}\p{P}]`
const numbers = String.raw`0[xX][\da-fA-F_]+|0[oO][0-7_]+|0[bB][01_]+|\d[\d_]*(?:\.\d[\d_]*)?(?:[eE][+-]?\d+)?`
// A string that is not closed ends with its line. A gap (`\`, white space, `\`) may cross lines.
const strings = String.raw`"(?:[^"\\\n]|\\\s+\\|\\\S|\\(?![^\S\n]*(?:\n|$)))*"?|'(?:\\(?:[^'\n]|'(?='))[^'\n]*|[^\\'\n]{1,2})'`

// In this order: a comment begins like an operator, an upper-case name is a name.
const pieces = new RegExp(
  [
    `(?<line>--+(?!${symbol})[^\\n]*)`,
    `(?<string>${strings})`,
    `(?<number>${numbers})`,
    String.raw`(?<upper>\p{Lu}[\p{L}\p{N}\p{M}_']*)`,
    String.raw`(?<lower>[\p{L}_][\p{L}\p{N}\p{M}_']*)`,
    `(?<operator>(?:${symbol})+)`,
    String.raw`(?<open>\{-)`,
  ].join("|"),
  "gu",
)
const startsWithSymbol = new RegExp(`^${symbol}`, "u")

/// Whether a text begins like an operator.
export function isSymbol(text: string): boolean {
  return startsWithSymbol.test(text)
}

/// All tokens of a text, in order.
export function tokens(text: string): readonly Token[] {
  const found: Token[] = []
  for (let token = tokenAt(text, 0); token !== null; token = tokenAt(text, token.end)) found.push(token)
  return found
}

/// The tokens of `text` after an edit. `old` are the tokens before; `from` to `to` is the changed range in the new text, and the text behind it moved by `shift`. Tokens far
/// from the change are reused.
export function tokensAfter(
  old: readonly Token[],
  text: string,
  {from, to, shift}: {readonly from: number; readonly to: number; readonly shift: number},
): readonly Token[] {
  // The kind of a token before the change may depend on characters up to the end of its line (comment or operator, number or name).
  const line = lineBefore(text, from)
  const kept = firstWith(old, token => token.end > line)
  const found = old.slice(0, kept)
  let rest = firstWith(old, token => token.end + shift >= to)
  for (let token = tokenAt(text, found.at(-1)?.end ?? 0); token !== null; token = tokenAt(text, token.end)) {
    found.push(token)
    // Where an old token ends, the text goes on as it did.
    while (rest < old.length && (old[rest]?.end ?? 0) + shift < token.end) rest += 1
    if (token.end >= to && (old[rest]?.end ?? -1) + shift === token.end) {
      for (let i = rest + 1; i < old.length; i += 1) {
        const {kind, start, end} = old[i] as Token
        found.push(shift === 0 ? (old[i] as Token) : {kind, start: start + shift, end: end + shift})
      }
      return found
    }
  }
  return found
}

/// The last line end before an offset that is not inside of a string gap (report §2.6).
function lineBefore(text: string, from: number): number {
  for (let at = from; ; ) {
    const line = text.lastIndexOf("\n", at - 1)
    at = line
    while (at > 0 && /\s/.test(text[at - 1] ?? "")) at -= 1
    if (line === -1 || text[at - 1] !== "\\") return line
  }
}

/// Binary search: the index of the first item for which `is` holds; it holds for all items behind it, too.
export function firstWith<A>(all: readonly A[], is: (item: A) => boolean): number {
  let [low, high] = [0, all.length]
  while (low < high) {
    const middle = (low + high) >> 1
    if (is(all[middle] as A)) high = middle
    else low = middle + 1
  }
  return low
}

/// The first token at or behind `from`, which is not inside of a token.
export function tokenAt(text: string, from: number): Token | null {
  pieces.lastIndex = from
  const match = pieces.exec(text)
  if (match === null) return null
  const groups = match.groups ?? {}
  const start = match.index
  // Block comments nest, which a regular expression cannot say.
  if (groups["open"] !== undefined)
    return {
      kind: text[start + 2] === "#" ? "pragma" : "comment",
      start,
      end: blockEnd(text, start) ?? text.length,
    }
  const word = match[0]
  return {kind: kindOf(groups, word), start, end: start + word.length}
}

function kindOf(groups: {[name: string]: string | undefined}, word: string): TokenKind {
  if (groups["lower"] !== undefined) {
    if (word.startsWith("_") && word.length > 1) return "hole"
    return keywords.has(word) ? "keyword" : "name"
  }
  if (groups["upper"] !== undefined) return "type"
  if (groups["operator"] !== undefined) return "operator"
  if (groups["line"] !== undefined) return "comment"
  return groups["string"] !== undefined ? "string" : "number"
}

/// Whether a block comment or a pragma has its end.
export function isClosed(text: string, {start, end}: Range): boolean {
  return end < text.length || (text.endsWith("-}") && blockEnd(text, start) !== undefined)
}

function blockEnd(text: string, start: number): number | undefined {
  let depth = 0
  for (let i = start; i < text.length - 1; i++) {
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
