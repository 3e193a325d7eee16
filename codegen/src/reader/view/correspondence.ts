/// Correspondence of blocks and text: whether a definition, read from its new text, is the tree of its blocks.
///
/// In: the definition as the blocks say it, and as the reader found it. Out: whether they are the same tree. Text that blocks keep to the letter is compared as
/// text, white space aside, with what stands in its place.

import {everyNode} from "../../model/child_nodes.ts"
import type {Declaration, Node} from "../../model/syntax_tree.ts"
import type {Piece} from "../module/module_pieces.ts"
import {asWritten, inBlockForm, partsOf} from "../printing/model_parts.ts"

export function isSaidBy(declaration: Declaration, piece: Piece): boolean {
  const core = piece.slice.slice(piece.core.start - piece.start, piece.core.end - piece.start)
  const textOf = (node: Node): string | undefined => {
    const span = piece.spans.get(asWritten(node))
    return span === undefined ? undefined : core.slice(span.start, span.end)
  }
  const isSame = (whole: Node, other: Node): boolean => {
    const [one, two] = [inBlockForm(whole), inBlockForm(other)]
    if (isText(one) || isText(two)) {
      const text = isText(two) ? two.text : textOf(two)
      return isText(one) && text !== undefined && flat(one.text) === flat(text)
    }
    const [shown, read] = [partsOf(one), partsOf(two)]
    if (shown.label !== read.label || shown.lists.length !== read.lists.length) return false
    const areSame = (a: readonly (Node | undefined)[], b: readonly (Node | undefined)[]) =>
      a.length === b.length && a.every((x, i) => sameOrAbsent(x, b[i], isSame))
    return (
      areSame(shown.places, read.places) &&
      shown.lists.every((list, i) => areSame(asEquations(list.items), read.lists[i]?.items ?? []))
    )
  }
  return piece.declaration !== undefined && isSame(declaration, piece.declaration)
}

/// Definitions of one name below each other, as after one was copied, are equations of one function in the text.
function asEquations(items: readonly Node[]): readonly Node[] {
  const joined: Node[] = []
  for (const node of items) {
    const last = joined[joined.length - 1]
    if (
      node.kind === "function" &&
      last?.kind === "function" &&
      last.name === node.name &&
      node.signature === undefined
    )
      joined[joined.length - 1] = {...last, clauses: [...last.clauses, ...node.clauses]}
    else joined.push(node)
  }
  return joined
}

function sameOrAbsent(
  a: Node | undefined,
  b: Node | undefined,
  isSame: (a: Node, b: Node) => boolean,
): boolean {
  return a === undefined || b === undefined ? a === b : isSame(a, b)
}

/// Whether a definition has empty places, which the text fills with holes: an empty stack of steps is a hole as well. GHC compiles none of it.
export function isUnfinished(declaration: Declaration): boolean {
  return [...everyNode(declaration)].some(
    node => node.kind.startsWith("hole") || (node.kind === "do" && node.statements.length === 0),
  )
}

/// Pieces of a definition that blocks keep to the letter. What a learner writes in them is read only once it stands in the text.
export function textsIn(declaration: Declaration): readonly string[] {
  return [...everyNode(declaration)].flatMap(node =>
    isText(node) && node.kind !== "type" ? [node.text] : [],
  )
}

type TextNode = Extract<Node, {kind: "raw" | "raw-pattern" | "raw-declaration" | "type"}>

function isText(node: Node): node is TextNode {
  return ["raw", "raw-pattern", "raw-declaration", "type"].includes(node.kind)
}

/// A text without white space and without the brackets around it.
function flat(text: string): string {
  const bare = text.replace(/\s+/g, "")
  const inner = /^\((.*)\)$/s.exec(bare)?.[1]
  return inner === undefined ? bare : inner
}
