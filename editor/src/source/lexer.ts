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
  /(?<pragma>\{-#[\s\S]*?(?:#-\}|$))|(?<line>--+(?![!#$%&*+./<=>?@\\^|~:-]).*)|(?<string>"(?:[^"\\\n]|\\.)*"?|'(?:[^'\\\n]|\\[^\n]{1,5})')|(?<number>0[xX][\da-fA-F]+|\d+(?:\.\d+)?(?:[eE][+-]?\d+)?)|(?<upper>\p{Lu}[\p{L}\p{N}_']*)|(?<lower>[\p{Ll}_][\p{L}\p{N}_']*)|(?<operator>[!#$%&*+./<=>?@\\^|~:-]+)|(?<open>\{-)/gu

/// All tokens of a text, in order; what lies between them is space and brackets.
export function tokens(text: string): readonly Token[] {
  const found: Token[] = []
  pieces.lastIndex = 0
  for (let match = pieces.exec(text); match !== null; match = pieces.exec(text)) {
    const groups = match.groups ?? {}
    const start = match.index
    if (groups.open !== undefined) {
      // Block comments nest, which a regular expression cannot say.
      const end = endOfComment(text, start)
      found.push({kind: "comment", start, end})
      pieces.lastIndex = end
      continue
    }
    const word = match[0]
    found.push({kind: kindOf(groups, word), start, end: start + word.length})
  }
  return found
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
