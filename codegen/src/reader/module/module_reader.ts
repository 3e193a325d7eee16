/// Incremental reader of a Haskell file: its pieces in order, which are the header, the definitions, and the text between them.
///
/// The slices of all pieces, concatenated, are the file, byte for byte. A definition is converted if the previous reading has none with the
/// same text; otherwise its nodes are reused. After an edit only the changed definitions are read (`incremental_reading.ts`).

import type {Language, Parser, Tree} from "web-tree-sitter"
import type {Fixity} from "../../haskell/fixity.ts"
import {fixitiesIn, redefinedOperators} from "../../haskell/fixity.ts"
import {importedFixities, operatorsIn} from "../../haskell/import_fixities.ts"
import {namesBoundBy} from "../../model/bound_names.ts"
import type {Cause} from "../../model/raw_reasons.ts"
import {reasons} from "../../model/raw_reasons.ts"
import type {Declaration} from "../../model/syntax_tree.ts"
import {extensionsIn} from "../../source/directives.ts"
import type {Range} from "../../source/lexer.ts"
import {nestingDepth} from "../../source/nesting_depth.ts"
import type {Comment, Lexed} from "../../source/top_level_items.ts"
import {areQuotationsOn, hasConditions, isUnicodeSyntaxOn, lex} from "../../source/top_level_items.ts"
import type {Part} from "../../source/top_level_sections.ts"
import {partsOf} from "../../source/top_level_sections.ts"
import type {Dialect} from "../conversion/conversion_context.ts"
import {Context} from "../conversion/conversion_context.ts"
import {readTop} from "../conversion/declarations.ts"
import type {NodeNames, Parsed, Syntax} from "../conversion/parse_tree.ts"
import {copyTree, namedChildren, nodeNames} from "../conversion/parse_tree.ts"
import {maskCandidates, masked} from "./error_masking.ts"
import type {Reading, Section} from "./incremental_reading.ts"
import {changedPieces, hasSameDialect, replaced} from "./incremental_reading.ts"
import type {Converted, Module, Piece} from "./module_pieces.ts"
import {wordsOf} from "./semantic_tokens.ts"
import {grammarVariants, withStandIns} from "./source_rewriting.ts"

/// Longer definitions are kept as text: they are not shown as blocks, and a broken one would cost the parser seconds.
const longest = 40_000

/// Longer definitions that are broken are kept as text as a whole, so that a key press stays fast.
const longestPartly = 4000

/// Reads Haskell; keeps the last reading, so that the next one reads only what changed.
export class Reader {
  private readonly parser: Parser
  private readonly names: NodeNames
  private last: Reading | undefined
  /// Whether the text that is read has the extension UnicodeSyntax, in which `→` is `->`; else it is an operator like any other.
  private hasUnicodeSyntax = false

  /// @internal Use `openReader`.
  constructor(parser: Parser, language: Language) {
    this.parser = parser
    this.names = nodeNames(language)
  }

  read(text: string): Module {
    const hasUnicodeSyntax = isUnicodeSyntaxOn(text)
    if (hasUnicodeSyntax !== this.hasUnicodeSyntax) this.last = undefined
    this.hasUnicodeSyntax = hasUnicodeSyntax
    const reading = (this.last && this.readChange(this.last, text)) ?? this.readAll(text)
    this.last = reading
    return reading.module
  }

  private readAll(text: string): Reading {
    const lexed = lex(text, undefined, this.hasUnicodeSyntax)
    const parts = partsOf(text, lexed)
    const declared = fixitiesOf(text, lexed)
    const names = parts.map(part => part.name)
    const imported = importedOperators(text, lexed, names)
    const fixities = new Map([...imported, ...redefinedOperators(names, declared), ...declared])
    const known = convertedByKey(this.last?.sections ?? [])
    const extensions = extensionsIn(text)
    const {pieces, sections} = this.readParts(text, parts, {fixities, extensions}, known)
    return {
      module: {text, pieces, fixities},
      extensions,
      sections,
      declared,
      operators: imported.size === 0 ? undefined : operatorsIn(text),
      margin: lexed.margin,
      isClosed: lexed.isClosed,
    }
  }

  /// The reading of a text that differs from the last one in a few definitions; undefined where all must be read.
  private readChange(last: Reading, text: string): Reading | undefined {
    if (text === last.module.text) return last
    // A quotation or a condition of the preprocessor may reach over several pieces.
    if (areQuotationsOn(text) || hasConditions(text)) return undefined
    const change = changedPieces(last, text)
    if (change === undefined) return undefined
    const window = text.slice(change.start, change.end)
    const lexed = lex(window, change.margin, this.hasUnicodeSyntax)
    const parts = partsOf(window, lexed)
    if (!hasSameDialect(last, change, window, parts)) return undefined
    const known = convertedByKey(last.sections.slice(change.first, change.behind))
    const dialect = {fixities: last.module.fixities, extensions: last.extensions}
    const read = this.readParts(window, parts, dialect, known)
    return replaced(last, text, change, {...read, margin: lexed.margin, isClosed: lexed.isClosed})
  }

  /// The pieces for the parts of a text. What `known` has by its key is taken over, node for node.
  private readParts(
    text: string,
    parts: readonly Part[],
    dialect: Dialect,
    known: ReadonlyMap<string, Converted>,
  ): {pieces: Piece[]; sections: Section[]} {
    const dialectKey = JSON.stringify([[...dialect.fixities], [...dialect.extensions]])
    const taken = new Set<string>()
    const pieces: Piece[] = []
    const sections: Section[] = []
    let start = 0
    for (const part of parts) {
      let piece: Omit<Piece, "slice" | "start" | "end" | "kind">
      if (part.kind === "declaration") {
        const tail = part.tail === undefined ? "" : text.slice(part.core.end, part.tail.end)
        const key = JSON.stringify([
          dialectKey,
          part.trouble ?? "",
          part.column,
          part.comment,
          part.source,
          tail,
        ])
        // Two equal definitions must not share their nodes.
        const converted =
          (taken.has(key) ? undefined : known.get(key)) ??
          this.convertWithTail(part, tail, dialect) ??
          this.convert(part, dialect)
        taken.add(key)
        sections.push({name: part.name, key, converted, isDefinition: part.trouble === undefined})
        piece = {
          ...converted,
          core: converted.hasTail ? {start: part.core.start, end: part.core.end + tail.length} : part.core,
          remark: part.remark,
          remarkText: part.comment,
          names: namesOf(converted.declaration, part.name),
        }
      } else {
        sections.push({name: part.name, key: "", converted: undefined, isDefinition: false})
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
      }
      pieces.push({...piece, kind: part.kind, slice: text.slice(start, part.end), start, end: part.end})
      start = part.end
    }
    return {pieces, sections}
  }

  /// The definition with the comment behind it; undefined when that is not the comment of its last step or local definition.
  private convertWithTail(part: Part, tail: string, dialect: Dialect): Converted | undefined {
    if (part.tail === undefined) return undefined
    const core = {start: part.core.start, end: part.core.end + tail.length}
    const inner = [...part.inner, part.tail]
    const converted = this.convert({...part, core, source: part.source + tail, inner}, dialect, true)
    return converted.hasTail && !converted.broken ? converted : undefined
  }

  /// `withTail`: the part ends in a comment that should be that of a step.
  private convert(part: Part, dialect: Dialect, withTail = false): Converted {
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
    const depth = nestingDepth(source)
    const isUnparsed = depth > deepestParsed
    const parsed =
      part.trouble !== undefined || part.source.length > longest || isUnparsed
        ? undefined
        : this.parse(source, part, shift, dialect)
    const words = parsed === undefined ? [] : wordsOf(parsed.root, shift)
    const whole = new Context(source, shifted, dialect, parsed?.pragmas)
    const hasError = parsed?.broken === true && depth <= deepestContexts
    const beyondGrammar = hasError ? this.causeBeyondGrammar(source, part, dialect) : undefined
    const isBroken = hasError && beyondGrammar === undefined
    const partly = isBroken ? this.readPartly(source, part, shift, shifted, dialect) : undefined
    const context = partly?.context ?? whole
    const made: Declaration | Cause =
      part.trouble ??
      partly?.made ??
      (parsed === undefined
        ? isUnparsed
          ? "deep"
          : "large"
        : parsed.broken
          ? isBroken
            ? "broken"
            : (beyondGrammar ?? "deep")
          : readTop(topOf(parsed.root), context))
    const remarkAbove = part.comment === "" ? [] : part.comment.split("\n")
    if (typeof made !== "string") {
      const hasTail = withTail && context.isLastTaken()
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
      return {declaration, broken: isBroken, spans, words, hasTail}
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
      hasTail: false,
    }
  }

  /// Why a definition in which the grammar finds an error is Haskell all the same; undefined where the error is one.
  private causeBeyondGrammar(source: string, part: Part, dialect: Dialect): Cause | undefined {
    const known = withStandIns(source)
    // The places of dashed operators are those of the source.
    if (known === undefined || part.dashed.length > 0) return undefined
    return this.parse(known.text, part, 0, dialect)?.broken === false ? known.cause : undefined
  }

  /// A broken definition with the part that holds the error as text; undefined where no such part is found.
  private readPartly(
    source: string,
    part: Part,
    shift: number,
    comments: readonly Comment[],
    dialect: Dialect,
  ): {made: Declaration; context: Context} | undefined {
    if (source.length > longestPartly) return undefined
    for (const mask of maskCandidates(source)) {
      const parsed = this.parse(masked(source, mask), part, shift, dialect)
      if (parsed === undefined || parsed.broken) continue
      const context = new Context(source, comments, dialect, parsed.pragmas, mask)
      const made = readTop(topOf(parsed.root), context)
      if (typeof made !== "string" && made.kind !== "raw-declaration" && context.isMaskRead)
        return {made, context}
    }
    return undefined
  }

  /// The first variant of the source that parses without an error, or else the first one.
  private parse(source: string, part: Part, shift: number, {extensions}: Dialect): Parsed | undefined {
    const dashed = part.dashed.map(d => moved(d, shift - part.core.start))
    let first: Parsed | undefined
    for (const {text, place} of grammarVariants(source, dashed, extensions, this.hasUnicodeSyntax)) {
      const tree: Tree | null = this.parser.parse(`${text}\n`)
      if (tree === null) return undefined
      const parsed = copyTree(tree, this.names, place)
      tree.delete()
      if (!parsed.broken) return parsed
      first ??= parsed
    }
    return first
  }
}

/// The first of several equal ones.
function convertedByKey(sections: readonly Section[]): ReadonlyMap<string, Converted> {
  const known = new Map<string, Converted>()
  for (const {key, converted} of sections)
    if (converted !== undefined && !known.has(key)) known.set(key, converted)
  return known
}

/// Nested brackets and layout blocks from which on the grammar may find errors that are none: its scanner keeps a bounded stack of contexts, which
/// holds 120 and does not hold 126 of them (measured with tree-sitter-haskell 0.23.1).
const deepestContexts = 120

/// Nested brackets and layout blocks from which on a definition is not parsed: its blocks would be too deep to draw, and parsing takes long (a type
/// with 2,000 brackets takes ten seconds).
const deepestParsed = 300

function moved(span: Range, by: number): Range {
  return {start: span.start + by, end: span.end + by}
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

/// Fixities of operators that the file imports and does not define.
function importedOperators(text: string, {items}: Lexed, names: readonly string[]): Map<string, Fixity> {
  const first = items.find(item => item.kind === "declaration")
  const header = text.slice(0, first?.start ?? text.length)
  if (!/^[ \t]*import\b/m.test(header)) return new Map()
  const definers = items.flatMap(({start, end}) => {
    const slice = text.slice(start, end)
    return /^(?:data|newtype|type|class|pattern|foreign)\b/.test(slice) ? [slice] : []
  })
  const signed = text.match(/^[ \t]*\([!#$%&*+./<=>?@\\^|~:\p{S}-]+\).*::/gmu) ?? []
  const own = new Set([...names, ...operatorsIn([...definers, ...signed].join("\n"))])
  return importedFixities(
    header,
    [...operatorsIn(text)].filter(op => !own.has(op)),
  )
}

function namesOf(d: Declaration, guessed: string): readonly string[] {
  switch (d.kind) {
    case "function":
    case "data":
    case "synonym":
      return [d.name]
    case "binding":
      return namesBoundBy(d.pattern)
    case "instance":
    case "raw-declaration":
      return guessed === "" ? [] : [guessed]
  }
}
