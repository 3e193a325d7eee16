/// Source rewriting before parsing: replaces what tree-sitter-haskell does not parse by equivalents of the same length.
///
/// In: the source of one declaration. Out: variants of it, to be parsed in order until one has no error, each with a map from its offsets to
/// those of the source. Only the shape of the syntax tree is taken from a variant; names and literals are read from the source itself.

import type {Range} from "../../source/lexer.ts"
import {untabbed} from "../../source/tab_expansion.ts"

export interface GrammarVariant {
  readonly text: string
  /// The offset in the source of an offset in `text`.
  place(offset: number): number
}

/// `dashed` are operators that start with two dashes (`-->`), which the grammar takes for comments.
export function grammarVariants(source: string, dashed: readonly Range[]): readonly GrammarVariant[] {
  let given = source
  for (const {start, end} of dashed)
    given = `${given.slice(0, start)}${"+".repeat(end - start)}${given.slice(end)}`
  // The grammar accepts tabs only as indentation.
  const tabs = given.includes("\t") ? untabbed(given) : undefined
  const place = tabs === undefined ? (at: number) => at : (at: number) => tabs.from[at] ?? given.length
  const plain = withGrammarEquivalents(tabs?.text ?? given)
  const texts = new Set([
    plain,
    withNamedNegatives(plain, /\s*`[\p{Ll}_]/uy),
    withNamedNegatives(plain, /\s*[`:]/uy),
  ])
  return [...texts].map(text => ({text, place}))
}

/// The source with equivalents that the grammar accepts. Every token keeps its offset and its length.
function withGrammarEquivalents(source: string): string {
  return (
    source
      // Letters without case count as lower-case. (`\u{1D44E}` is a surrogate pair, like the letter that it replaces.)
      .replace(/\p{Lo}/gu, c => (c.length === 1 ? "a" : "\u{1D44E}"))
      // A hole, where the grammar expects no `_`.
      .replace(/(?<![\p{L}\p{N}\p{M}_'])_(?![\p{L}\p{N}\p{M}_'])/gu, "a")
      // `f$x` and `f $(g x)` apply an operator: Template Haskell splices are not supported.
      .replace(/(?<=[\p{L}\p{N}_'")\]] *)\$\$?(?=[\p{L}_(])/gu, o => "+".repeat(o.length))
      // `(-1)`, `[-x]` at the start of a condition or step: as one word, which `expressions.ts` splits again.
      .replace(
        /(?<=[([,]\s*)- *(?:0[xXoObB][\da-fA-F_]+|\d[\d._]*(?:[eE][-+]?[\d_]+)?|[\p{Ll}_][\p{L}\p{N}_']*)(?=\s*(?:[)\],]|::))/gu,
        n => (/^- *\d/.test(n) ? "0" : "a").repeat(n.length),
      )
      // `-1 :: Int` as a step or condition: the grammar expects a pattern. As a name, which `expressions.ts` reads as the number it is.
      .replace(/(?<=(?<![\d_.][eE])- *)(?:0[xXoObB][\da-fA-F_]+|\d[\d._]*(?:[eE][-+]?\d+)?)(?=\s*::)/gu, n =>
        "a".repeat(n.length),
      )
      // The grammar's `'\n'` may go on to the next quote, as the one in `x'`.
      .replace(/(?<![\p{L}\p{N}_'])'\\(?:[abfnrtv\\"']|\^.|\d+|o[0-7]+|x[\da-fA-F]+|[A-Z]{2,3}\d?)'/gu, c =>
        "0".repeat(c.length),
      )
  )
}

/// A name for each negative number before an operator that `operator` matches: in ``| -1 `elem` x`` the grammar expects a pattern.
function withNamedNegatives(plain: string, operator: RegExp): string {
  return plain.replace(/(?<=- *)\d[\d._]*(?:[eE][-+]?\d+)?/gu, (n, at: number) => {
    operator.lastIndex = at + n.length
    return operator.test(plain) ? "a".repeat(n.length) : n
  })
}
