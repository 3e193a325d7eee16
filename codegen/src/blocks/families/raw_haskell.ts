/// Raw blocks: Haskell text that no other block represents, unchanged and editable.

import type {Connects, Row, Shape} from "../../block_shape.ts"
import {causeOf} from "../../model/raw_reasons.ts"
import type {Extra} from "../../serialized_blocks.ts"
import {words} from "../../words/index.ts"
import type {BlockSpec} from "../spec/block_spec.ts"
import {noButtons, textIn} from "../spec/block_spec.ts"

function shape(connects: Connects, what: () => string): (extra: Extra) => Shape {
  return extra => ({
    family: "own",
    connects,
    rows: textRows(textIn(extra, "text"), what()),
    tooltip:
      extra.reason === undefined ? words.raw.aPieceOfHaskellAsItStands : reasonWords(textIn(extra, "reason")),
    aria: what(),
  })
}

/// Lines and characters of a raw block that are drawn.
const shownLines = 60
const shownCharacters = 4000

/// The text as a field, or the beginning of a long one as labels: a field of thousands of lines would halt the page.
function textRows(text: string, aria: string): readonly Row[] {
  const lines = text.split("\n")
  if (lines.length <= shownLines && text.length <= shownCharacters)
    return [[{kind: "text", key: "text", value: text, aria, lines: true}]]
  const shown = lines.slice(0, 5).map(l => (l.length > 80 ? `${l.slice(0, 80)} …` : l))
  const hidden = Math.max(1, lines.length - shown.length)
  return [...shown, words.program.moreLines(hidden)].map(label => [{kind: "label", text: label}])
}

/// A reason is kept in English (`model/raw_reasons.ts`), and shown in the learner's language.
function reasonWords(reason: string): string {
  const cause = causeOf(reason)
  return cause === undefined ? reason : words.reasons[cause]
}

const reason = (extra: Extra) => (typeof extra.reason === "string" ? {reason: extra.reason} : {})
const saved = (node: {text: string; reason?: string | undefined}): Extra => ({
  text: node.text,
  ...(node.reason === undefined ? {} : {reason: node.reason}),
})

export const raw: readonly BlockSpec[] = [
  {
    type: "raw_expression",
    shape: shape({as: "expression"}, () => words.raw.haskellExpression),
    press: noButtons,
    meaning: {
      as: "expression",
      read: r => ({kind: "raw", text: textIn(r.extra, "text"), ...reason(r.extra), from: r.from}),
      write: e => (e.kind === "raw" ? {extra: saved(e)} : undefined),
    },
  },
  {
    type: "raw_pattern",
    shape: shape({as: "pattern"}, () => words.raw.haskellPattern),
    press: noButtons,
    meaning: {
      as: "pattern",
      read: r => ({kind: "raw-pattern", text: textIn(r.extra, "text"), ...reason(r.extra), from: r.from}),
      write: p => (p.kind === "raw-pattern" ? {extra: saved(p)} : undefined),
    },
  },
  {
    type: "raw_definition",
    shape: shape({as: "definition"}, () => words.raw.haskellDefinition),
    press: noButtons,
    meaning: {
      as: "definition",
      // While its field is empty or ends in a blank it stays one declaration, so that the block is not made anew under the hand that types.
      read: r => ({
        kind: "raw-declaration",
        text: textIn(r.extra, "text").trim() || "_",
        ...reason(r.extra),
        from: r.from,
      }),
      write: d => (d.kind === "raw-declaration" ? {extra: saved(d)} : undefined),
    },
  },
]
