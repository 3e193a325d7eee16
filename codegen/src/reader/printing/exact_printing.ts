/// Exact printing: the edits of a definition's text that make it say what another definition says.
///
/// In: the definition as it stands, and the new one as the pretty-printer writes it, both read. The models are compared from the root; only
/// changed nodes are written, in the place and the column of what they replace. Subtrees that stood elsewhere bring their own text and comments
/// along. The caller reads the result again and asks for larger replacements (`depth`) where it says something else.

import type {Node} from "../../model/syntax_tree.ts"
import type {Range} from "../../source/lexer.ts"
import {derivingEdits} from "./deriving_edits.ts"
import {deletion, itemRange, paired, separatorText} from "./list_edits.ts"
import type {Separator} from "./model_parts.ts"
import {equalItems, inBlockForm, keyOf, partsOf} from "./model_parts.ts"
import type {MovedTexts} from "./moved_texts.ts"
import {isItem, written} from "./moved_texts.ts"
import {nameEdits} from "./name_edits.ts"
import {isRecord, punEdits} from "./pun_edits.ts"
import type {Source} from "./source_fragments.ts"
import {bracketsAround, columnAt, indentAt, rangeOf, withBrackets, withComments} from "./source_fragments.ts"
import type {Edit} from "./text_edits.ts"
import {applied, withShiftedLayout} from "./text_edits.ts"

/// Which items of two versions of a list belong together: equal ones, also where they have moved, or those in the same place.
export type Pairing = "moved" | "in place"

/// The new text; undefined when the whole definition has to be printed. Nodes deeper than `depth` are not compared.
export function editedText(
  before: {root: Node; source: Source},
  now: {root: Node; source: Source},
  moved: MovedTexts,
  depth: number,
  pairing: Pairing = "moved",
): {text: string; deepest: number} | undefined {
  const printing = new ExactPrinting(before.source, now.source, moved, depth, pairing)
  const edits = printing.compare(before.root, now.root, 0)
  if (edits === undefined) return undefined
  const shifted = withShiftedLayout(before, edits)
  return {text: applied(before.source.text, shifted), deepest: printing.deepest}
}

class ExactPrinting {
  private readonly before: Source
  private readonly now: Source
  private readonly moved: MovedTexts
  private readonly depth: number
  private readonly pairing: Pairing
  deepest = 0

  constructor(before: Source, now: Source, moved: MovedTexts, depth: number, pairing: Pairing) {
    this.before = before
    this.now = now
    this.moved = moved
    this.depth = depth
    this.pairing = pairing
  }

  /// The edits inside of a node; undefined when the node has to be replaced.
  compare(whole: Node, printed: Node, level: number): readonly Edit[] | undefined {
    if (keyOf(whole) === keyOf(printed)) return []
    const [old, fresh] =
      whole.kind === printed.kind ? [whole, printed] : [inBlockForm(whole), inBlockForm(printed)]
    if (level > this.depth || old.kind !== fresh.kind) return undefined
    this.deepest = Math.max(this.deepest, level)
    const [a, b] = [rangeOf(this.before, old), rangeOf(this.now, fresh)]
    if (a === undefined || b === undefined) return undefined
    const [was, is] = [partsOf(old), partsOf(fresh)]
    const own = was.label === is.label ? [] : wordEdits(this.before, old, fresh)
    const remark = level === 0 || commentOf(old) === commentOf(fresh) ? [] : undefined
    if (own === undefined || remark === undefined || was.lists.length !== is.lists.length) return undefined
    const edits = [...own]
    for (const [i, place] of was.places.entries()) {
      const other = is.places[i]
      const inner =
        place === undefined || other === undefined ? undefined : this.change(place, other, a, b, level)
      if (inner === undefined) return undefined
      edits.push(...inner)
    }
    for (const [i, list] of was.lists.entries()) {
      const inner = this.list(list.separator, list.items, is.lists[i]?.items ?? [], a, b, level)
      if (inner === undefined) return undefined
      edits.push(...inner)
    }
    return edits
  }

  /// The edits of a part of a node, down to a replacement of the part.
  private change(old: Node, fresh: Node, a: Range, b: Range, level: number): readonly Edit[] | undefined {
    const inside = this.compare(old, fresh, level + 1)
    if (inside !== undefined) return inside
    const [from, to] = [rangeOf(this.before, old), rangeOf(this.now, fresh)]
    if (from === undefined || to === undefined) return undefined
    if (isItem(old) !== isItem(fresh)) return undefined
    if (isItem(old)) {
      const range = withComments(this.before, from, a.start)
      return [{...range, text: this.text(fresh, b, columnAt(this.before, range.start), range)}]
    }
    const around = bracketsAround(this.before, from, a)
    const needed = bracketsAround(this.now, to, b) !== undefined
    const areSteps = old.kind !== "do" && inBlockForm(fresh).kind === "do"
    const isBehindDollar = areSteps && dollarBefore(this.now, to, b) !== undefined
    // Brackets that the old part needed go with it; others stay, and steps without a `$` need them.
    const isFreed = around !== undefined && !needed && !isBehindDollar && mayNeedBrackets(old)
    const all = isFreed ? withBrackets(this.before, from, a) : from
    const isArgument = inBlockForm(fresh).kind !== "do" && dollarBefore(this.now, to, b) === undefined
    const dollar = old.kind === "do" && isArgument ? dollarBefore(this.before, all, a) : undefined
    if (dollar !== undefined) {
      // The steps after `$` are an argument of the call; another argument that is not behind `$` stands there, in brackets where it needs them.
      const own = this.text(fresh, b, columnAt(this.before, dollar) + (needed ? 1 : 0), all)
      return [{start: dollar, end: all.end, text: needed ? `(${own})` : own}]
    }
    if (isBehindDollar && around === undefined && dollarBefore(this.before, all, a) === undefined) {
      const own = this.text(fresh, b, columnAt(this.before, all.start) + "$ ".length, all)
      return [{start: all.start, end: all.end, text: `$ ${own}`}]
    }
    const open = needed && around === undefined ? "(" : ""
    const text = this.text(fresh, b, columnAt(this.before, all.start) + open.length, all)
    const below = open === "" ? this.onOwnLines(fresh, to, text, all, a, b) : undefined
    return [below ?? spaced(this.before, {...all, text: open === "" ? text : `(${text})`})]
  }

  /// A new node as text for a place of the old definition.
  private text(fresh: Node, b: Range, column: number, place: Range, startsLine = false): string {
    const indent = startsLine ? column : indentAt(this.before, place.start)
    return written(this.now, this.moved, fresh, b, column, {...place, source: this.before, indent})
  }

  /// A new part of several lines that the pretty-printer begins on a line of its own: it does so here, too.
  private onOwnLines(
    fresh: Node,
    to: Range,
    text: string,
    place: Range,
    a: Range,
    b: Range,
  ): Edit | undefined {
    const lead = (source: Source, at: number): string =>
      source.text.slice(source.text.lastIndexOf("\n", at - 1) + 1, at)
    if (!text.includes("\n") || lead(this.now, to.start).trim() !== "") return undefined
    if (lead(this.before, place.start).trim() === "") return undefined
    const blanks = /[ \t]*$/.exec(this.before.text.slice(a.start, place.start))?.[0].length ?? 0
    const column = columnAt(this.before, a.start) + columnAt(this.now, to.start) - columnAt(this.now, b.start)
    if (column < 0) return undefined
    const start = place.start - blanks
    return {
      start,
      end: place.end,
      text: `\n${" ".repeat(column)}${this.text(fresh, b, column, place, true)}`,
    }
  }

  private list(
    separator: Separator,
    old: readonly Node[],
    fresh: readonly Node[],
    a: Range,
    b: Range,
    level: number,
  ): readonly Edit[] | undefined {
    const [was, is] = [old.map(keyOf), fresh.map(keyOf)]
    const pairs = [...equalItems(was, is), [old.length, fresh.length] as [number, number]]
    if (old.length === 0 || fresh.length === 0) return old.length === fresh.length ? [] : undefined
    const edits: Edit[] = []
    if (this.pairing === "in place" && old.length === fresh.length) {
      for (const [i, node] of old.entries()) {
        const edit = was[i] === is[i] ? [] : this.change(node, fresh[i] as Node, a, b, level)
        if (edit === undefined) return undefined
        edits.push(...edit)
      }
      return edits
    }
    let [from, to] = [0, 0]
    for (const [i, k] of pairs) {
      const [gone, come] = [old.slice(from, i), fresh.slice(to, k)]
      const matched = paired(gone, come)
      const kept = new Set<number>()
      // What has no partner is deleted, and what is new is written behind the item before it.
      for (const [g, node] of gone.entries()) {
        const partner = matched.get(g)
        const edit =
          partner === undefined
            ? deletion(this.before, separator, old, from + g, a)
            : this.change(node, come[partner] as Node, a, b, level)
        if (edit === undefined) return undefined
        edits.push(...edit)
        if (partner !== undefined) kept.add(partner)
      }
      const places = new Map([...matched].map(([g, c]) => [c, from + g]))
      let last = from - 1
      for (const [c, node] of come.entries()) {
        const place = places.get(c)
        if (place !== undefined) last = place
        else {
          const edit = this.inserted(separator, old, last, node, a, b)
          if (edit === undefined) return undefined
          edits.push(edit)
        }
      }
      from = i + 1
      to = k + 1
    }
    return edits
  }

  /// A new item behind the item `last`, or before the first.
  private inserted(
    separator: Separator,
    items: readonly Node[],
    last: number,
    fresh: Node,
    a: Range,
    b: Range,
  ): Edit | undefined {
    const beside = itemRange(this.before, separator, items, Math.max(last, 0), a)
    const node = items[Math.max(last, 0)]
    const span = node && rangeOf(this.before, node)
    if (beside === undefined || span === undefined) return undefined
    const column = columnAt(this.before, span.start)
    const between = separatorText(this.before, separator, items, Math.max(last, 0), column, a)
    const to = rangeOf(this.now, fresh)
    if (between === undefined || to === undefined) return undefined
    const needed = separator !== "line" && bracketsAround(this.now, to, b) !== undefined
    const start = last === -1 ? beside.start : beside.end
    const newline = between.lastIndexOf("\n")
    const at =
      last === -1
        ? columnAt(this.before, start)
        : newline === -1
          ? columnAt(this.before, start) + between.length
          : between.length - newline - 1
    const text = this.text(fresh, b, at + (needed ? 1 : 0), beside, separator === "line")
    const own = needed ? `(${text})` : text
    return {start, end: start, text: last === -1 ? own + between : between + own}
  }
}

/// The edits of what a node says itself, beside its parts.
function wordEdits(source: Source, old: Node, fresh: Node): readonly Edit[] | undefined {
  if (old.kind === "data" && fresh.kind === "data") return derivingEdits(source, old, fresh)
  if (isRecord(old) && isRecord(fresh)) return punEdits(source, old, fresh)
  return nameEdits(source, old, fresh)
}

/// Where the `$` before a part of the node `a` stands.
function dollarBefore(source: Source, part: Range, a: Range): number | undefined {
  const lead = /(?<![!#$%&*+./<=>?@\\^|~:-])\$\s*$/.exec(source.text.slice(a.start, part.start))
  return lead === null ? undefined : a.start + lead.index
}

/// Whether a part stands in brackets where it is an argument; a single word does not, unless it is a negative number.
function mayNeedBrackets(node: Node): boolean {
  const {places, lists} = partsOf(node)
  return places.length > 0 || lists.length > 0 || ("text" in node && String(node.text).startsWith("-"))
}

/// The edit with a blank where words would run together.
function spaced(source: Source, edit: Edit): Edit {
  const {text} = source
  const joins = (l: string | undefined, r: string | undefined): boolean =>
    /^[\p{L}\p{N}_']{2}$/u.test(`${l ?? ""}${r ?? ""}`)
  const left = joins(text[edit.start - 1], edit.text[0]) ? " " : ""
  const right = joins(edit.text[edit.text.length - 1], text[edit.end]) ? " " : ""
  return {...edit, text: left + edit.text + right}
}

function commentOf(node: Node): string {
  return (node as {comment?: string}).comment ?? ""
}
