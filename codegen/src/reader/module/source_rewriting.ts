/// Source rewriting before parsing: replaces what tree-sitter-haskell does not parse by equivalents of the same length.
///
/// In: the source of one declaration. Out: variants of it, to be parsed in order until one has no error, each with a map from its offsets to
/// those of the source. Only the shape of the syntax tree is taken from a variant; names and literals are read from the source itself.

import {unicodeSyntax} from "../../haskell/lexemes.ts"
import type {Cause} from "../../model/raw_reasons.ts"
import type {Range} from "../../source/lexer.ts"
import {untabbed} from "../../source/tab_expansion.ts"

export interface GrammarVariant {
  readonly text: string
  /// The offset in the source of an offset in `text`.
  place(offset: number): number
}

/// `dashed` are operators that start with two dashes (`-->`), which the grammar takes for comments. The grammar takes `→` for `->` even where the
/// extension is off that makes it so.
export function grammarVariants(
  source: string,
  dashed: readonly Range[],
  extensions: ReadonlySet<string>,
  hasUnicodeSyntax = false,
): readonly GrammarVariant[] {
  let given = source
  for (const {start, end} of dashed)
    given = `${given.slice(0, start)}${"+".repeat(end - start)}${given.slice(end)}`
  if (!hasUnicodeSyntax) given = given.replace(unicodeSyntax, "⊕")
  // The grammar accepts tabs only as indentation.
  const tabs = given.includes("\t") ? untabbed(given) : undefined
  const place = tabs === undefined ? (at: number) => at : (at: number) => tabs.from[at] ?? given.length
  const hasSplices = extensions.has("TemplateHaskell") || extensions.has("TemplateHaskellQuotes")
  const plain = withGrammarEquivalents(tabs?.text ?? given, hasSplices)
  const texts = new Set([
    plain,
    // Of the signs of UnicodeSyntax `★` is an operator wherever no kind can stand.
    plain.replaceAll("★", "⊕"),
    withNamedNegatives(plain, /\s*`[\p{Ll}_]/uy),
    withNamedNegatives(plain, /\s*[`:]/uy),
  ])
  return [...texts].map(text => ({text, place}))
}

/// The source with equivalents that the grammar accepts. Every token keeps its offset and its length.
function withGrammarEquivalents(source: string, hasSplices: boolean): string {
  return (
    source
      // Letters without case count as lower-case. Of letters that are surrogate pairs the grammar knows few.
      .replace(/\p{Lo}/gu, c => "a".repeat(c.length))
      .replace(/(?=[\u{10000}-\u{10FFFF}])[\p{Ll}\p{Lu}]/gu, c => (/\p{Lu}/u.test(c) ? "Aa" : "aa"))
      .replace(/(?<=[\p{L}\p{N}\p{M}_'])(?=[\u{10000}-\u{10FFFF}])\p{N}/gu, "00")
      // A hole, where the grammar expects no `_`.
      .replace(/(?<![\p{L}\p{N}\p{M}_'])_(?![\p{L}\p{N}\p{M}_'])/gu, "a")
      // `f$x` applies an operator, and so does `f $(g x)`, but for a file with splices of Template Haskell.
      .replace(
        hasSplices
          ? /(?<=[\p{L}\p{N}_'")\]])\$\$?(?=[\p{L}_(])/gu
          : /(?<=[\p{L}\p{N}_'")\]] *)\$\$?(?=[\p{L}_(])/gu,
        o => "+".repeat(o.length),
      )
      // `s!i` applies an operator, as GHC reads it where no space stands on either side.
      .replace(/(?<=[\p{L}\p{N}_'")\]])!(?=[\p{L}\p{N}_'"([])/gu, "+")
      // `(-1)`, `[-x]` at the start of a condition or step: as one word, which `expressions.ts` splits again.
      .replace(
        /(?<=[([,]\s*)- *(?:0[xXoObB][\da-fA-F_]+|\d[\d_]*(?:\.\d[\d_]*)?(?:[eE][-+]?[\d_]+)?|[\p{Ll}_][\p{L}\p{N}_']*)(?=\s*(?:[)\],]|::))/gu,
        n => (/^- *\d/.test(n) ? "0" : "a").repeat(n.length),
      )
      // `-1 :: Int` as a step or condition: the grammar expects a pattern. As a name, which `expressions.ts` reads as the number it is.
      .replace(
        /(?<=(?<![\d_.][eE])- *)(?:0[xXoObB][\da-fA-F_]+|\d[\d_]*(?:\.\d[\d_]*)?(?:[eE][-+]?\d+)?)(?=\s*::)/gu,
        n => "a".repeat(n.length),
      )
      // The grammar's `'\n'` may go on to the next quote, as the one in `x'`.
      .replace(/(?<![\p{L}\p{N}_'])'\\(?:[abfnrtv\\"']|\^.|\d+|o[0-7]+|x[\da-fA-F]+|[A-Z]{2,3}\d?)'/gu, c =>
        "0".repeat(c.length),
      )
  )
}

/// Haskell that the grammar does not know and blocks cannot show, and the text of the same form that it knows.
const standIns: readonly {readonly cause: Cause; readonly part: RegExp; readonly by: string}[] = [
  // Arrow notation: `proc x -> f -< x` has the form of a function.
  {cause: "arrow", part: /(?<![\p{L}\p{N}_'])proc(?=\s*[\p{L}_(~![])/gu, by: "\\"},
  {cause: "arrow", part: /(?<![!#$%&*+./<=>?@\\^|~:-])-<<?(?![!#$%&*+./<=>?@\\^|~:-])/gu, by: "+"},
  // `(| e c |)` passes a command to an operator.
  {cause: "arrow", part: /\(\|(?=\s)|(?<=\s)\|\)/gu, by: " "},
  // A constructor that is an operator, with fields.
  {cause: "data", part: /\(\s*:[!#$%&*+./<=>?@\\^|~:-]+\s*\)(?=\s*\{)/gu, by: "A"},
]

/// The source with stand-ins, and why blocks cannot show what they stand for; undefined where there is nothing of that kind.
export function withStandIns(source: string): {readonly text: string; readonly cause: Cause} | undefined {
  const found = standIns.filter(({part}) => source.search(part) !== -1)
  const [first] = found
  if (first === undefined) return undefined
  return {text: found.reduce((text, {part, by}) => text.replace(part, by), source), cause: first.cause}
}

/// A name for each negative number before an operator that `operator` matches: in ``| -1 `elem` x`` the grammar expects a pattern.
function withNamedNegatives(plain: string, operator: RegExp): string {
  return plain.replace(/(?<=- *)\d[\d_]*(?:\.\d[\d_]*)?(?:[eE][-+]?\d+)?/gu, (n, at: number) => {
    operator.lastIndex = at + n.length
    return operator.test(plain) ? "a".repeat(n.length) : n
  })
}
