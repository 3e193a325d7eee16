/// Haskell that no other block can say, kept to the letter and editable.

import {causeOf} from "../reader/reasons.ts"
import type {Extra} from "../saved.ts"
import type {Connects, Shape} from "../shape.ts"
import {words} from "../words/index.ts"
import type {BlockSpec} from "./spec.ts"
import {noButtons, textIn} from "./spec.ts"

function shape(connects: Connects, what: () => string): (extra: Extra) => Shape {
  return extra => ({
    family: "own",
    connects,
    rows: [[{kind: "text", key: "text", value: textIn(extra, "text"), aria: what(), lines: true}]],
    tooltip:
      extra.reason === undefined ? words.raw.aPieceOfHaskellAsItStands : reasonWords(textIn(extra, "reason")),
    aria: what(),
  })
}

/// A reason is kept in English (`reader/reasons.ts`), and said in the learner's language.
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
      read: r => ({kind: "raw-declaration", text: textIn(r.extra, "text"), ...reason(r.extra), from: r.from}),
      write: d => (d.kind === "raw-declaration" ? {extra: saved(d)} : undefined),
    },
  },
]
