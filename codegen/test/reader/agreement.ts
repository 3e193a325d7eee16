/// Disagreements between the text and the blocks of a view. Without Vitest, because walks in the real page ask the same (`e2e-tests/walks`).

import {isDeepStrictEqual} from "node:util"
import {readTree} from "../../src/blocks/block_reader.ts"
import {printDeclarationAlone} from "../../src/haskell/printer.ts"
import type {Declaration} from "../../src/model/syntax_tree.ts"
import type {Reader, View} from "../../src/reader/index.ts"
import {spansOf, workspaceOf} from "../../src/reader/index.ts"
import type {SavedBlock} from "../../src/serialized_blocks.ts"

export function everyBlock(block: SavedBlock): SavedBlock[] {
  const below = [...Object.values(block.inputs ?? {}).map(i => i.block), block.next?.block]
  return [block, ...below.flatMap(b => (b === undefined ? [] : everyBlock(b)))]
}

/// What a definition says, without what only says how. A `do` of one step is that step, and is printed so; a pattern
/// kept as text has brackets where it needs them.
function said(d: Declaration | undefined, signed: boolean): unknown {
  return JSON.parse(
    JSON.stringify(d ?? null, (key, v: unknown) =>
      ["from", "comment", "reason"].includes(key) || (key === "signature" && !signed) ? undefined : v,
    ),
    (_, v: unknown) => {
      const {kind, statements, text, op, left, right} = (v ?? {}) as {
        kind?: string
        statements?: {kind: string; expr: unknown}[]
        text?: string
        op?: string
        left?: {kind: string; fn: unknown; args: unknown[]}
        right?: unknown
      }
      // The steps after `$` may be one step without `do`, which is printed in brackets.
      if (kind === "infix" && op === "$" && left !== undefined)
        return left.kind === "apply"
          ? {...left, args: [...left.args, right]}
          : {kind: "apply", fn: left, args: [right]}
      if (kind === "raw-pattern") return {kind, text: text?.replace(/^\((.*)\)$/s, "$1")}
      const [only, ...more] = kind === "do" ? (statements ?? []) : []
      return only?.kind === "statement" && more.length === 0 ? only.expr : v
    },
  )
}

/// Whether an expression in a definition is kept as text: it does not parse, or no blocks show it.
function hasRawExpression(d: Declaration): boolean {
  return JSON.stringify(d).includes('"kind":"raw"')
}

/// The program's own fixities, as Haskell.
function fixityLines(view: View): string {
  const words = {left: "infixl", right: "infixr", none: "infix"}
  return [...view.module.fixities]
    .map(([op, f]) => `${words[f.associates]} ${f.precedence} ${/^[\p{L}_]/u.test(op) ? `\`${op}\`` : op}`)
    .join("\n")
}

/// Where two texts begin to differ.
function difference(blocks: string, text: string): string {
  let at = 0
  while (at < blocks.length && blocks[at] === text[at]) at++
  const from = Math.max(0, at - 60)
  return `the blocks say …${blocks.slice(from, at + 200)}\nand the text …${text.slice(from, at + 200)}`
}

/// Where the text and the blocks of a view say different things; none when they agree. `reader` is not the view's own, which remembers the text.
/// `agreed` remembers definitions that did agree, for a program that is asked about again and again.
export function disagreements(
  view: View,
  reader: Reader,
  agreed: Set<string> = new Set(),
): readonly string[] {
  const found: string[] = []
  if (view.module.pieces.map(p => p.slice).join("") !== view.text)
    found.push("the pieces of the text are not the text")
  const ids = workspaceOf(view)
    .blocks.blocks.flatMap(everyBlock)
    .map(b => b.id)
  const known = new Set(ids)
  if (known.size !== ids.length) found.push("two blocks have one id")
  for (const span of spansOf(view).spans)
    if (!known.has(span.block)) found.push(`${span.block} has a place in the text and is no block`)
  const operators = fixityLines(view)
  for (const shown of view.declarations) {
    const piece = view.module.pieces[shown.piece]
    if (piece?.declaration === undefined) found.push(`${shown.name} has blocks and no declaration`)
    if (shown.dimmed || piece === undefined) continue
    const asked = JSON.stringify([operators, piece.slice, shown.block])
    if (agreed.has(asked)) continue
    const [own] = readTree(shown.block).declarations
    if (own === undefined) {
      found.push(`the blocks of ${shown.name} say nothing`)
      continue
    }
    if (own.kind === "raw-declaration") {
      const text = piece.slice.slice(piece.core.start - piece.start, piece.core.end - piece.start)
      if (own.text !== text.replaceAll("\r\n", "\n"))
        found.push(`the text of ${shown.name} is\n${text}\nand its block says\n${own.text}`)
      continue
    }
    // What does not parse is found by its lines: in another layout more of the definition may be text.
    if (hasRawExpression(own) && isDeepStrictEqual(said(own, false), said(piece.declaration, false))) continue
    const printed = printDeclarationAlone({...own, comment: undefined}, view.module.fixities)
    const again = reader
      .read(`${operators}\n${printed}`)
      .pieces.findLast(p => p.declaration !== undefined)?.declaration
    // `main` has its type in blocks, and a definition made of blocks in the text, whether it is written or not.
    const has = (d: Declaration | undefined) => d?.kind !== "function" || d.signature !== undefined
    const signed = has(own) && has(piece.declaration)
    const [blocks, text] = [said(again, signed), said(piece.declaration, signed)]
    if (isDeepStrictEqual(blocks, text)) agreed.add(asked)
    else found.push(`${printed}\n${shown.name}: ${difference(JSON.stringify(blocks), JSON.stringify(text))}`)
  }
  return found
}
