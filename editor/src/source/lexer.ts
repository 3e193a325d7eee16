/// Haskell's words, found fast enough for every keystroke: keywords, names, numbers, texts, comments. Colours
/// need no more; what a program means is codegen's. Haskell 2010 report §2.

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

export interface Token {
  readonly kind: TokenKind
  readonly start: number
  readonly end: number
}

/// Haskell 2010 report §2.4, without those that a learner's program does not contain.
const keywords = new Set(
  "case class data default deriving do else if import in infix infixl infixr instance let module newtype of then type where".split(
    " ",
  ),
)

// In this order: a pragma is a comment by form, a comment begins like an operator.
const pieces =
  /(?<pragma>\{-#[\s\S]*?(?:#-\}|$))|(?<line>--+(?![!#$%&*+./<=>?@\\^|~:-]).*)|(?<string>"(?:[^"\\\n]|\\\S|\\\s+\\)*"?|'(?:[^'\\\n]|\\[^\n]{1,5})')|(?<number>0[xX][\da-fA-F]+|\d+(?:\.\d+)?(?:[eE][+-]?\d+)?)|(?<upper>\p{Lu}[\p{L}\p{N}_']*)|(?<lower>[\p{Ll}_][\p{L}\p{N}_']*)|(?<operator>[!#$%&*+./<=>?@\\^|~:-]+)|(?<open>\{-)/gu

/// All tokens of a text, in order; what lies between them is space and brackets.
export function tokens(text: string): readonly Token[] {
  const found: Token[] = []
  for (let token = tokenAt(text, 0); token !== null; token = tokenAt(text, token.end)) found.push(token)
  return found
}

/// The tokens of `text`, which was another where `old` are the tokens: from `from` on, up to `to` in the new text, it has changed, and what stands behind has
/// moved by `shift`. Tokens far from the change are taken over.
export function tokensAfter(
  old: readonly Token[],
  text: string,
  {from, to, shift}: {readonly from: number; readonly to: number; readonly shift: number},
): readonly Token[] {
  // A token before the change may have looked a few characters ahead (a comment is told from an operator, a number from a name), as far as its line's end.
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

/// The line end before an offset that no text goes across. (A gap, `\` and space and `\`, goes on with a text on another line: report §2.6.)
function lineBefore(text: string, from: number): number {
  for (let at = from; ; ) {
    const line = text.lastIndexOf("\n", at - 1)
    at = line
    while (at > 0 && /\s/.test(text[at - 1] ?? "")) at -= 1
    if (line === -1 || text[at - 1] !== "\\") return line
  }
}

/// The number of the first item of which something is true that is then true of all behind it.
export function firstWith<A>(all: readonly A[], is: (item: A) => boolean): number {
  let [low, high] = [0, all.length]
  while (low < high) {
    const middle = (low + high) >> 1
    if (is(all[middle] as A)) high = middle
    else low = middle + 1
  }
  return low
}

/// The first token at or behind an offset at which none is under way.
function tokenAt(text: string, from: number): Token | null {
  pieces.lastIndex = from
  const match = pieces.exec(text)
  if (match === null) return null
  const groups = match.groups ?? {}
  const start = match.index
  // Block comments nest, which a regular expression cannot say.
  if (groups.open !== undefined) return {kind: "comment", start, end: endOfComment(text, start)}
  const word = match[0]
  return {kind: kindOf(groups, word), start, end: start + word.length}
}

function kindOf(groups: {[name: string]: string | undefined}, word: string): TokenKind {
  if (groups.pragma !== undefined) return "pragma"
  if (groups.line !== undefined) return "comment"
  if (groups.string !== undefined) return "string"
  if (groups.number !== undefined) return "number"
  if (groups.upper !== undefined) return "type"
  if (groups.operator !== undefined) return "operator"
  if (word.startsWith("_") && word.length > 1) return "hole"
  return keywords.has(word) ? "keyword" : "name"
}

function endOfComment(text: string, start: number): number {
  let depth = 0
  for (let i = start; i < text.length; i += 1) {
    if (text.startsWith("{-", i)) {
      depth += 1
      i += 1
    } else if (text.startsWith("-}", i)) {
      depth -= 1
      i += 1
      if (depth === 0) return i + 1
    }
  }
  return text.length
}
