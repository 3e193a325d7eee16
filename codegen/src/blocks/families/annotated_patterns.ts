/// Patterns around a pattern: with `!` or `~`, through a function, with a type.

import {words} from "../../words/index.ts"
import type {BlockSpec} from "../spec/block_spec.ts"
import {noButtons, textIn} from "../spec/block_spec.ts"

const strictness: BlockSpec = {
  type: "pattern_strictness",
  onlyFromText: true,
  shape(extra) {
    const isLazy = extra.mark === "~"
    return {
      family: "own",
      connects: {as: "pattern"},
      rows: [
        [
          {kind: "label", text: isLazy ? words.patterns.later : words.patterns.atOnce},
          {kind: "socket", name: "P", sort: "pattern", aria: words.patterns.whatIt},
        ],
      ],
      tooltip: isLazy ? words.patterns.looksAtTheValueLater : words.patterns.computesTheValueAtOnce,
      aria: isLazy ? words.patterns.later : words.patterns.atOnce,
    }
  },
  press: noButtons,
  meaning: {
    as: "pattern",
    read: r => ({
      kind: "strictness-pattern",
      mark: r.extra.mark === "~" ? "~" : "!",
      pattern: r.pattern("P"),
      from: r.from,
    }),
    write: p =>
      p.kind === "strictness-pattern" ? {extra: {mark: p.mark}, sockets: {P: p.pattern}} : undefined,
  },
}

const view: BlockSpec = {
  type: "pattern_view",
  onlyFromText: true,
  shape: () => ({
    family: "own",
    connects: {as: "pattern"},
    rows: [
      [
        {kind: "socket", name: "X", sort: "expression", aria: words.patterns.functionThatLooks},
        {kind: "label", text: words.patterns.gives},
        {kind: "socket", name: "P", sort: "pattern", aria: words.patterns.whatIt},
      ],
    ],
    tooltip: words.patterns.looksAtWhatAFunctionMakes,
    aria: words.patterns.throughAFunction,
  }),
  press: noButtons,
  meaning: {
    as: "pattern",
    read: r => ({kind: "view-pattern", expr: r.expr("X"), pattern: r.pattern("P"), from: r.from}),
    write: p => (p.kind === "view-pattern" ? {extra: {}, sockets: {X: p.expr, P: p.pattern}} : undefined),
  },
}

const typed: BlockSpec = {
  type: "pattern_typed",
  onlyFromText: true,
  shape: extra => ({
    family: "own",
    connects: {as: "pattern"},
    rows: [
      [
        {kind: "socket", name: "P", sort: "pattern", aria: words.patterns.whatIt},
        {kind: "label", text: words.patterns.ofType},
        {kind: "type", key: "type", value: textIn(extra, "type", "Double"), aria: words.patterns.type},
      ],
    ],
    tooltip: words.patterns.saysWhichTypeItHas,
    aria: words.patterns.withType(textIn(extra, "type", "Double")),
  }),
  press: noButtons,
  meaning: {
    as: "pattern",
    read: r => ({
      kind: "typed-pattern",
      pattern: r.pattern("P"),
      type: {kind: "type", text: textIn(r.extra, "type", "Double"), from: r.from},
      from: r.from,
    }),
    write: p =>
      p.kind === "typed-pattern" ? {extra: {type: p.type.text}, sockets: {P: p.pattern}} : undefined,
  },
}

export const annotatedPatterns: readonly BlockSpec[] = [strictness, view, typed]
