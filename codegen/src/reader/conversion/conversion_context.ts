/// Context of one definition's conversion: its text, comments, spans, and pieces kept as text.

import type {Fixities} from "../../haskell/fixity.ts"
import {unicodeSyntax} from "../../haskell/lexemes.ts"
import type {Cause} from "../../model/raw_reasons.ts"
import {reasons} from "../../model/raw_reasons.ts"
import type {Expr} from "../../model/syntax_tree.ts"
import type {Range} from "../../source/lexer.ts"
import {expandTabs} from "../../source/tab_expansion.ts"
import type {Comment} from "../../source/top_level_items.ts"
import {wordsOf} from "../../source/top_level_items.ts"
import type {Syntax} from "./parse_tree.ts"

/// What the signs of UnicodeSyntax stand for in a type.
const typeSigns: {readonly [sign: string]: string} = {"→": "->", "⇒": "=>", "∷": "::"}

const arrow = /(?<![!#$%&*+./<=>?@\\^|~:-]) ?([-=]>) ?(?![!#$%&*+./<=>?@\\^|~:-])/g

/// A word that opens a block, with the block's first line behind it.
const opensLayout =
  /(?:^|[^\p{L}\p{N}_'])(?:do|mdo|of|where|let|if|\\ *case|rec)(?![\p{L}\p{N}_'])\s*(?!--|\{-)\S/u

/// Deeper expressions and patterns stay text, so that every recursion over the model and its blocks is bounded.
export const maximumDepth = 100

/// What a file says about how its Haskell is to be read.
export interface Dialect {
  /// How its own operators bind.
  readonly fixities: Fixities
  /// Extensions of the language that it turns on.
  readonly extensions: ReadonlySet<string>
}

export class Context {
  readonly text: string
  fixities: Fixities
  /// Extensions of the language that the file turns on.
  readonly extensions: ReadonlySet<string>
  /// Where each model node stands in `text`.
  readonly spans = new Map<object, Range>()
  /// Set when only the whole can be kept as text: it is broken, or keeping a piece would move its lines against each other.
  whole: Cause | undefined
  /// Reads the expression of a view pattern; set by `declarations.ts`, so that patterns and expressions are files without a cycle.
  expression: ((node: Syntax) => Expr) | undefined
  /// Nesting of the expression or pattern that is being converted, and of those that are finished.
  depth = 0
  readonly depths = new WeakMap<object, number>()
  private readonly comments: readonly Comment[]
  private readonly taken: boolean[]
  private pragmas: readonly Range[]
  /// A part with a syntax error; the syntax tree has a name in its place.
  private readonly mask: Range | undefined
  /// Whether that part was found in the tree.
  isMaskRead = false

  constructor(
    text: string,
    comments: readonly Comment[],
    {fixities, extensions}: Dialect,
    pragmas: readonly Range[] = [],
    mask?: Range,
  ) {
    this.extensions = extensions
    this.mask = mask
    this.pragmas = pragmas
    this.text = text
    this.comments = comments
    this.fixities = fixities
    this.taken = comments.map(() => false)
  }

  of(node: Range): string {
    return this.text.slice(node.start, node.end)
  }

  /// Remembers where a new node stands.
  at<const T extends object>(range: Range, node: T): T {
    this.spans.set(node, {start: range.start, end: this.endOf(range)})
    return node
  }

  /// Whether a node stands for the part with the error.
  isMask(node: Range): boolean {
    return this.mask !== undefined && node.start === this.mask.start && node.end <= node.start + 1
  }

  /// The part with the error, if it is what a node stands for.
  maskAt(node: Range): Range | undefined {
    if (!this.isMask(node)) return undefined
    this.isMaskRead = true
    return this.mask
  }

  /// The end of a node in the text: the name that stands for the part with the error is shorter.
  private endOf({end}: Range): number {
    return this.mask !== undefined && end === this.mask.start + 1 ? this.mask.end : end
  }

  /// The exact text of a piece that blocks cannot say. Its later lines keep their places towards the first.
  exact(node: Range, cause: Cause): {text: string; reason: string} {
    this.comments.forEach((c, i) => {
      if (c.start >= node.start && c.end <= node.end) this.taken[i] = true
    })
    this.takePragmas(node.start, node.end, [])
    const [first = "", ...below] = this.of(node).split(/\r?\n/)
    const others = below.map(expandTabs)
    const indents = others.filter(l => l.trim() !== "").map(l => l.length - l.trimStart().length)
    const column = this.columnOf(node.start)
    const least = Math.min(column, ...indents)
    // Lines further left than the first go as far to the right together as needed; but not past what they are measured against.
    if (least < column && opensLayout.test(first)) this.whole ??= "displaced"
    const by = least < column ? least - 2 : column
    const lines = others.map(line =>
      line.trim() === "" ? "" : by < 0 ? " ".repeat(-by) + line : line.slice(by),
    )
    return {text: [first, ...lines].join("\n"), reason: reasons[cause]}
  }

  private columnOf(at: number): number {
    return [...expandTabs(this.text.slice(this.text.lastIndexOf("\n", at - 1) + 1, at))].length
  }

  /// What tells the compiler something between two places, and in none of those that are inside of these.
  takePragmas(from: number, to: number, inside: readonly Range[]): readonly Range[] {
    const isHere = (p: Range) =>
      p.start >= from && p.end <= to && !inside.some(i => i.start <= p.start && p.end <= i.end)
    const found = this.pragmas.filter(isHere)
    this.pragmas = this.pragmas.filter(p => !isHere(p))
    return found
  }

  /// Why only the whole can be kept as text, if so: what no node took would be lost.
  kept(): Cause | undefined {
    return this.whole ?? (this.pragmas.length > 0 ? "directive" : undefined)
  }

  /// Comments between two places that no inner node took, and one that follows on the same line.
  takeComments(from: number, to: number): {comment?: string} {
    const lines: string[] = []
    this.comments.forEach((c, i) => {
      if (this.taken[i] || c.start < from) return
      if (c.end > to && (c.start < to || /[^ \t]/.test(this.text.slice(to, c.start)))) return
      this.taken[i] = true
      lines.push(...wordsOf(this.of(c), c.kind))
    })
    return lines.length === 0 ? {} : {comment: lines.join("\n")}
  }

  /// Whether a node has taken the last comment.
  isLastTaken(): boolean {
    return this.taken[this.taken.length - 1] === true
  }

  /// A type as text on one line, its comments left for the node around it.
  typeText(node: Range): string {
    let text = ""
    let at = node.start
    for (const c of this.comments)
      if (c.start >= at && c.end <= node.end) {
        text += `${this.text.slice(at, c.start)} `
        at = c.end
      }
    // `a->b` and `a -> b` are one type; blocks compare types as text.
    return (text + this.text.slice(at, node.end))
      .replace(unicodeSyntax, sign => (sign === "∀" ? "forall " : (typeSigns[sign] ?? sign)))
      .replace(arrow, " $1 ")
      .replace(/\s+/g, " ")
      .trim()
  }
}
