/// Incremental reader of a Haskell file: its pieces in order, which are the header, the definitions, and the text between them.
///
/// The slices of all pieces, concatenated, are the file, byte for byte. A definition is converted if the previous reading has none with the
/// same text; otherwise its nodes are reused. After an edit only the changed definitions are read (`incremental_reading.ts`).

import type {Language, Parser, Tree} from "web-tree-sitter"
import type {Fixities, Fixity} from "../../haskell/fixity.ts"
import {fixitiesIn, redefinedOperators} from "../../haskell/fixity.ts"
import {namesBoundBy} from "../../model/bound_names.ts"
import {everyNode} from "../../model/child_nodes.ts"
import type {Cause} from "../../model/raw_reasons.ts"
import {reasons} from "../../model/raw_reasons.ts"
import type {Declaration} from "../../model/syntax_tree.ts"
import type {Range} from "../../source/lexer.ts"
import type {Comment, Lexed} from "../../source/top_level_items.ts"
import {lex} from "../../source/top_level_items.ts"
import type {Part} from "../../source/top_level_sections.ts"
import {partsOf} from "../../source/top_level_sections.ts"
import {Context} from "../conversion/conversion_context.ts"
import {readTop} from "../conversion/declarations.ts"
import type {NodeNames, Parsed, Syntax} from "../conversion/parse_tree.ts"
import {copyTree, namedChildren, nodeNames} from "../conversion/parse_tree.ts"
import {maskCandidates, masked} from "./error_masking.ts"
import type {Reading, Section} from "./incremental_reading.ts"
import {changedPieces, hasSameFixities, replaced} from "./incremental_reading.ts"
import type {Converted, Module, Piece} from "./module_pieces.ts"
import {wordsOf} from "./semantic_tokens.ts"
import {grammarVariants} from "./source_rewriting.ts"

/// Longer definitions are kept as text: they are not shown as blocks, and a broken one would cost the parser seconds.
const longest = 40_000

/// Longer definitions that are broken are kept as text as a whole, so that a key press stays fast.
const longestPartly = 4000

/// Reads Haskell; keeps the last reading, so that the next one reads only what changed.
export class Reader {
  private readonly parser: Parser
  private readonly names: NodeNames
  private last: Reading | undefined

  /// @internal Use `openReader`.
  constructor(parser: Parser, language: Language) {
    this.parser = parser
    this.names = nodeNames(language)
  }

  read(text: string): Module {
    const reading = (this.last && this.readChange(this.last, text)) ?? this.readAll(text)
    this.last = reading
    return reading.module
  }

  private readAll(text: string): Reading {
    const lexed = lex(text)
    const parts = partsOf(text, lexed)
    const declared = fixitiesOf(text, lexed)
    const names = parts.map(part => part.name)
    const fixities = new Map([...redefinedOperators(names, declared), ...declared])
    const known = convertedByKey(this.last?.sections ?? [])
    const {pieces, sections} = this.readParts(text, parts, fixities, known)
    return {
      module: {text, pieces, fixities},
      sections,
      declared,
      margin: lexed.margin,
      isClosed: lexed.isClosed,
    }
  }

  /// The reading of a text that differs from the last one in a few definitions; undefined where all must be read.
  private readChange(last: Reading, text: string): Reading | undefined {
    if (text === last.module.text) return last
    const change = changedPieces(last, text)
    if (change === undefined) return undefined
    const window = text.slice(change.start, change.end)
    const lexed = lex(window, change.margin)
    const parts = partsOf(window, lexed)
    if (!hasSameFixities(last, change, window, parts)) return undefined
    const known = convertedByKey(last.sections.slice(change.first, change.behind))
    const read = this.readParts(window, parts, last.module.fixities, known)
    return replaced(last, text, change, {...read, margin: lexed.margin, isClosed: lexed.isClosed})
  }

  /// The pieces for the parts of a text. What `known` has by its key is taken over, node for node.
  private readParts(
    text: string,
    parts: readonly Part[],
    fixities: Fixities,
    known: ReadonlyMap<string, Converted>,
  ): {pieces: Piece[]; sections: Section[]} {
    const fixityKey = JSON.stringify([...fixities])
    const taken = new Set<string>()
    const pieces: Piece[] = []
    const sections: Section[] = []
    let start = 0
    for (const part of parts) {
      let piece: Omit<Piece, "slice" | "start" | "end" | "kind">
      if (part.kind === "declaration") {
        const tail = part.tail === undefined ? "" : text.slice(part.core.end, part.tail.end)
        const key = JSON.stringify([
          fixityKey,
          part.trouble ?? "",
          part.column,
          part.comment,
          part.source,
          tail,
        ])
        // Two equal definitions must not share their nodes.
        const converted =
          (taken.has(key) ? undefined : known.get(key)) ??
          this.convertWithTail(part, tail, fixities) ??
          this.convert(part, fixities)
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
  private convertWithTail(part: Part, tail: string, fixities: Fixities): Converted | undefined {
    if (part.tail === undefined) return undefined
    const core = {start: part.core.start, end: part.core.end + tail.length}
    const inner = [...part.inner, part.tail]
    const converted = this.convert({...part, core, source: part.source + tail, inner}, fixities, true)
    return converted.hasTail && !converted.broken ? converted : undefined
  }

  /// `withTail`: the part ends in a comment that should be that of a step.
  private convert(part: Part, fixities: Fixities, withTail = false): Converted {
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
    const words = parsed === undefined ? [] : wordsOf(parsed.root, shift)
    const whole = new Context(source, shifted, fixities, parsed?.pragmas)
    const isBroken = parsed?.broken === true && bracketDepth(source) <= deepestBrackets
    const partly = isBroken ? this.readPartly(source, part, shift, shifted, fixities) : undefined
    const context = partly?.context ?? whole
    const made: Declaration | Cause =
      part.trouble ??
      partly?.made ??
      (parsed === undefined
        ? "large"
        : parsed.broken
          ? isBroken
            ? "broken"
            : "deep"
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

  /// A broken definition with the part that holds the error as text; undefined where no such part is found.
  private readPartly(
    source: string,
    part: Part,
    shift: number,
    comments: readonly Comment[],
    fixities: Fixities,
  ): {made: Declaration; context: Context} | undefined {
    if (source.length > longestPartly) return undefined
    for (const mask of maskCandidates(source)) {
      const parsed = this.parse(masked(source, mask), part, shift)
      if (parsed === undefined || parsed.broken) continue
      const context = new Context(source, comments, fixities, parsed.pragmas, mask)
      const made = readTop(topOf(parsed.root), context)
      if (typeof made !== "string" && made.kind !== "raw-declaration" && context.isMaskRead)
        return {made, context}
    }
    return undefined
  }

  /// The first variant of the source that parses without an error, or else the first one.
  private parse(source: string, part: Part, shift: number): Parsed | undefined {
    const dashed = part.dashed.map(d => moved(d, shift - part.core.start))
    let first: Parsed | undefined
    for (const {text, place} of grammarVariants(source, dashed)) {
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

/// Nested brackets from which on the grammar may find errors that are none: its scanner keeps a bounded stack of contexts.
const deepestBrackets = 150

function bracketDepth(source: string): number {
  let depth = 0
  let deepest = 0
  for (const c of source)
    if ("([{".includes(c)) deepest = Math.max(deepest, ++depth)
    else if (")]}".includes(c)) depth--
  return deepest
}

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
