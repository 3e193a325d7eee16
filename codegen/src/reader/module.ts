/// A file as its pieces in order: header, definitions, and what stands between them.
///
/// The slices of all pieces, one after the other, are the file, byte for byte. A definition is converted when its text has not been seen in
/// the reading before; the rest is taken over, node for node.

import type {Language, Parser, Tree} from "web-tree-sitter"
import type {Fixities, Fixity} from "../haskell/fixity.ts"
import {fixitiesIn} from "../haskell/fixity.ts"
import {everyNode} from "../model/children.ts"
import {boundBy} from "../model/names.ts"
import type {Declaration} from "../model/tree.ts"
import {Context} from "./context.ts"
import {readTop} from "./declarations.ts"
import type {Lexed, Range} from "./lexer.ts"
import {lex} from "./lexer.ts"
import type {Part} from "./parts.ts"
import {partsOf} from "./parts.ts"
import type {Cause} from "./reasons.ts"
import {reasons} from "./reasons.ts"
import type {NodeNames, Parsed, Syntax} from "./syntax.ts"
import {copyTree, namedChildren, nodeNames} from "./syntax.ts"
import {untabbed} from "./tabs.ts"
import type {Word} from "./wordroles.ts"
import {wordsOf} from "./wordroles.ts"

/// A part of a file. `header` holds `module`, imports, pragmas and directives, which have no blocks; `end` what follows the last definition.
export interface Piece extends Range {
  readonly kind: "header" | "declaration" | "end"
  /// From the end of the piece before to the end of this one: `text.slice(start, end)`.
  readonly slice: string
  /// The definition itself, in the file; without the comment above it. Empty for other kinds.
  readonly core: Range
  /// The comment directly above the definition.
  readonly remark: Range | undefined
  /// The words of that comment; where `declaration.comment` says more, the rest stood inside the definition.
  readonly remarkText: string
  /// The names it defines: a function, a type, or all names of a pattern.
  readonly names: readonly string[]
  /// What it says. A raw one has the exact text, and the reason why blocks cannot say it. Absent in a header.
  readonly declaration: Declaration | undefined
  /// It holds something that is not Haskell, or lacks something.
  readonly broken: boolean
  /// Where each node of `declaration` stands, counted from `core.start`.
  readonly spans: ReadonlyMap<object, Range>
  /// What its names are there for, in their order, counted from `core.start`; also of a broken one.
  readonly words: readonly Word[]
}

export interface Module {
  readonly text: string
  readonly pieces: readonly Piece[]
  /// Operators whose binding the file declares.
  readonly fixities: ReadonlyMap<string, Fixity>
}

interface Converted {
  readonly declaration: Declaration
  readonly broken: boolean
  readonly spans: ReadonlyMap<object, Range>
  readonly words: readonly Word[]
}

/// Longer definitions are kept as text: nobody shows them as blocks, and a broken one would cost the parser seconds.
const longest = 40_000

/// Reads Haskell; remembers the last reading so that the next one costs only what changed.
export class Reader {
  private readonly parser: Parser
  private readonly names: NodeNames
  private known = new Map<string, Converted>()

  /// @internal Use `openReader`.
  constructor(parser: Parser, language: Language) {
    this.parser = parser
    this.names = nodeNames(language)
  }

  read(text: string): Module {
    const lexed = lex(text)
    const fixities = fixitiesOf(text, lexed)
    const key = JSON.stringify([...fixities])
    const seen = new Map<string, Converted>()
    const pieces: Piece[] = []
    let start = 0
    for (const part of partsOf(text, lexed)) {
      let piece: Omit<Piece, "slice" | "start" | "end" | "kind">
      if (part.kind === "declaration") {
        const source = JSON.stringify([key, part.trouble ?? "", part.column, part.comment, part.source])
        // Two equal definitions must not share their nodes.
        const converted =
          (seen.has(source) ? undefined : this.known.get(source)) ?? this.convert(part, fixities)
        seen.set(source, converted)
        piece = {
          ...converted,
          core: part.core,
          remark: part.remark,
          remarkText: part.comment,
          names: namesOf(converted.declaration, part.name),
        }
      } else
        piece = {
          core: part.core,
          remark: undefined,
          remarkText: "",
          names: [],
          declaration: undefined,
          broken: false,
          spans: new Map(),
          words: [],
        }
      pieces.push({...piece, kind: part.kind, slice: text.slice(start, part.end), start, end: part.end})
      start = part.end
    }
    this.known = seen
    return {text, pieces, fixities}
  }

  private convert(part: Part, fixities: Fixities): Converted {
    const comments = part.inner.map(c => ({
      ...c,
      start: c.start - part.core.start,
      end: c.end - part.core.start,
    }))
    // The first line keeps its column: what stands below is indented against it. (The grammar sees the indentation of
    // a line only behind a line end.)
    const above = part.column === 0 ? "" : `\n${" ".repeat(part.column)}`
    const shift = above.length
    const source = above + part.source
    const shifted = comments.map(c => ({...c, start: c.start + shift, end: c.end + shift}))
    const parsed =
      part.trouble !== undefined || part.source.length > longest ? undefined : this.parse(source, part, shift)
    const context = new Context(source, shifted, fixities, parsed?.pragmas)
    const words = parsed === undefined ? [] : wordsOf(parsed.root, shift)
    const made: Declaration | Cause =
      part.trouble ??
      (parsed === undefined ? "large" : parsed.broken ? "broken" : readTop(topOf(parsed.root), context))
    const remarkAbove = part.comment === "" ? [] : part.comment.split("\n")
    if (typeof made !== "string") {
      const beside = context.takeComments(0, source.length).comment
      const remarks = [
        ...remarkAbove,
        ...(made.kind === "raw-declaration" || beside === undefined ? [] : [beside]),
      ]
      const declaration = remarks.length === 0 ? made : {...made, comment: remarks.join("\n")}
      const spans =
        shift === 0
          ? context.spans
          : new Map([...context.spans].map(([node, span]) => [node, moved(span, -shift)]))
      spans.set(declaration, {start: 0, end: part.source.length})
      return {declaration, broken: false, spans, words}
    }
    const declaration: Declaration = {
      kind: "raw-declaration",
      text: part.source.replaceAll("\r\n", "\n"),
      reason: reasons[made],
      ...(remarkAbove.length === 0 ? {} : {comment: remarkAbove.join("\n")}),
    }
    return {
      declaration,
      broken: made === "broken",
      spans: new Map([[declaration, {start: 0, end: part.source.length}]]),
      words,
    }
  }

  private parse(source: string, part: Part, shift: number): Parsed | undefined {
    for (const d of part.dashed) {
      const at = d.start - part.core.start + shift
      source = `${source.slice(0, at)}${"+".repeat(d.end - d.start)}${source.slice(at + d.end - d.start)}`
    }
    // Between words, the grammar does not know tabs.
    const tabs = source.includes("\t") ? untabbed(source) : undefined
    const plain = plainer(tabs?.text ?? source)
    let first: Parsed | undefined
    for (const text of new Set([plain, negated(plain, /\s*`[\p{Ll}_]/uy), negated(plain, /\s*[`:]/uy)])) {
      const tree: Tree | null = this.parser.parse(`${text}\n`)
      if (tree === null) return undefined
      const parsed = copyTree(
        tree,
        this.names,
        tabs === undefined ? at => at : at => tabs.from[at] ?? source.length,
      )
      tree.delete()
      if (!parsed.broken) return parsed
      first ??= parsed
    }
    return first
  }
}

function moved(span: Range, by: number): Range {
  return {start: span.start + by, end: span.end + by}
}

/// The text in words that the grammar knows, with every token in its place. The model takes its words from the true text.
function plainer(source: string): string {
  return (
    source
      // Letters without case count as small ones. (The second `a` is a pair, as what it stands for.)
      .replace(/\p{Lo}/gu, c => (c.length === 1 ? "a" : "\u{1D44E}"))
      // An empty socket, where the grammar expects no `_`.
      .replace(/(?<![\p{L}\p{N}\p{M}_'])_(?![\p{L}\p{N}\p{M}_'])/gu, "a")
      // `f$x` and `f $(g x)` apply an operator: no program of ours has code that writes code.
      .replace(/(?<=[\p{L}\p{N}_'")\]] *)\$\$?(?=[\p{L}_(])/gu, o => "+".repeat(o.length))
      // `(-1)`, `[-x]` at the start of a condition or step: as one word, which `expressions.ts` takes apart again.
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

/// With a name for each negative number before an operator: in `| -1 `elem` x` the grammar expects a pattern, and is tried with these when it has found an error.
function negated(plain: string, operator: RegExp): string {
  return plain.replace(/(?<=- *)\d[\d._]*(?:[eE][-+]?\d+)?/gu, (n, at: number) => {
    operator.lastIndex = at + n.length
    return operator.test(plain) ? "a".repeat(n.length) : n
  })
}

function topOf(root: Syntax): Syntax[] {
  return namedChildren(root).flatMap(c => (c.type === "declarations" ? namedChildren(c) : [c]))
}

/// The fixity declarations of the top level. (Those inside a definition keep that definition from becoming blocks.)
function fixitiesOf(text: string, lexed: Lexed): Map<string, Fixity> {
  const found = new Map<string, Fixity>()
  for (const item of lexed.items)
    if (item.kind === "declaration" && text.startsWith("infix", item.start))
      for (const [op, fixity] of fixitiesIn(text.slice(item.start, item.end))) found.set(op, fixity)
  return found
}

function namesOf(d: Declaration, guessed: string): readonly string[] {
  switch (d.kind) {
    case "function":
    case "data":
    case "synonym":
      return [d.name]
    case "binding":
      return boundBy(d.pattern)
    case "instance":
    case "raw-declaration":
      return guessed === "" ? [] : [guessed]
  }
}

/// How many expressions a definition holds, and those that were kept as text.
export function expressionsIn(d: Declaration): {
  all: number
  raw: readonly {text: string; reason: string | undefined}[]
} {
  let all = 0
  const raw: {text: string; reason: string | undefined}[] = []
  for (const node of everyNode(d)) {
    if (node.kind === "raw") raw.push({text: node.text, reason: node.reason})
    if (isExpression(node.kind)) all++
  }
  return {all, raw}
}

const expressionKinds = new Set(
  "variable constructor-name number string character apply infix negate section lambda if branches case lambda-case let do tuple list range comprehension typed record update hole raw".split(
    " ",
  ),
)

function isExpression(kind: string): boolean {
  return expressionKinds.has(kind)
}
