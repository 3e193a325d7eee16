/// Patterns: how a definition looks at what it gets, and names its parts.

import type {Item} from "../../block_shape.ts"
import type {Pattern} from "../../model/syntax_tree.ts"
import {words} from "../../words/index.ts"
import type {BlockSpec} from "../spec/block_spec.ts"
import {countIn, counting, foldLabel, isFolded, noButtons, shownParts, textIn} from "../spec/block_spec.ts"
import {choiceOf, choices, exampleNameOf, labelsOf, valueLabel} from "../spec/constructor_labels.ts"
import {checkedName} from "./definitions.ts"
import {checkNumber, choiceItems, choiceValue} from "./values.ts"

const name: BlockSpec = {
  type: "pattern_name",
  shape: extra => ({
    family: "own",
    connects: {as: "pattern"},
    rows: [[{kind: "binder", key: "name", value: textIn(extra, "name", "x"), aria: words.patterns.name}]],
    tooltip: words.patterns.givesANameToWhat,
    aria: words.patterns.name2(textIn(extra, "name", "x")),
  }),
  press: noButtons,
  meaning: {
    as: "pattern",
    read: r => ({kind: "name-pattern", name: checkedName(r, "name", "x"), from: r.from}),
    write: p => (p.kind === "name-pattern" ? {extra: {name: p.name}} : undefined),
  },
}

/// What a wildcard stands for is kept in English, as the toolbox made it.
function anyOf(what: string): string {
  const known: {readonly [what: string]: string} = words.anyOf
  return known[what] ?? words.patterns.any(what)
}

const any: BlockSpec = {
  type: "pattern_any",
  shape(extra) {
    const what = textIn(extra, "what", "thing")
    return {
      family: "own",
      connects: {as: "pattern"},
      rows: [[{kind: "label", text: anyOf(what)}]],
      tooltip: words.patterns.whateverIsHereItDoesNotMatter,
      aria: anyOf(what),
    }
  },
  press: noButtons,
  meaning: {
    as: "pattern",
    read: r => ({kind: "wildcard", from: r.from}),
    write: p => (p.kind === "wildcard" ? {extra: {}} : undefined),
  },
}

const construct: BlockSpec = {
  type: "pattern_construct",
  shape(extra) {
    const con = textIn(extra, "con", "Just")
    const look = labelsOf(con)
    const items: Item[] = [{kind: "label", text: look.word ?? con}]
    const args = countIn(extra, "args", 0)
    for (let i = 0; i < Math.min(args, shownParts); i++) {
      const part = look.parts[i] ?? words.patterns.part(i + 1)
      items.push({
        kind: "socket",
        name: `A${i}`,
        sort: "pattern",
        aria: `${look.word ?? con}: ${part}`,
        hint: part,
      })
    }
    items.push(...foldLabel(args))
    return {
      family: look.asPattern,
      connects: {as: "pattern"},
      rows: [items],
      tooltip: look.tooltip,
      aria: look.word ?? con,
      help: `v:${con}`,
    }
  },
  press: noButtons,
  meaning: {
    as: "pattern",
    read(r) {
      const args: Pattern[] = []
      for (let i = 0; i < countIn(r.extra, "args", 0); i++) args.push(r.pattern(`A${i}`))
      return {kind: "constructor-pattern", name: textIn(r.extra, "con", "Just"), args, from: r.from}
    },
    write(p) {
      if (p.kind !== "constructor-pattern" || p.name === "()") return undefined
      if (p.args.length === 0 && choiceOf(p.name) !== undefined) return undefined
      return {
        extra: {con: p.name, args: p.args.length},
        sockets: Object.fromEntries(p.args.map((a, i) => [`A${i}`, a])),
      }
    },
  },
}

const choice: BlockSpec = {
  type: "pattern_choice",
  shape(extra) {
    const type = textIn(extra, "of", "ButtonStatus")
    const value = choiceValue(type, textIn(extra, "value"))
    return {
      family: choices[type]?.family ?? "own",
      connects: {as: "pattern"},
      rows: [choiceItems(type, value)],
      tooltip: words.patterns.onlyWhen(value),
      aria: `${exampleNameOf(type)} ${valueLabel(type, value)}`,
      help: `t:${type}`,
    }
  },
  press: noButtons,
  meaning: {
    as: "pattern",
    read: r => ({
      kind: "constructor-pattern",
      name: choiceValue(textIn(r.extra, "of", "ButtonStatus"), textIn(r.extra, "value")),
      args: [],
      from: r.from,
    }),
    write(p) {
      const type = p.kind === "constructor-pattern" && p.args.length === 0 ? choiceOf(p.name) : undefined
      return p.kind === "constructor-pattern" && type !== undefined
        ? {extra: {of: type, value: p.name}}
        : undefined
    },
  },
}

const number: BlockSpec = {
  type: "pattern_number",
  shape: extra => ({
    family: "number",
    connects: {as: "pattern"},
    rows: [
      [
        {
          kind: "number",
          key: "value",
          value: textIn(extra, "value", "0"),
          aria: words.patterns.exactlyThisNumber,
        },
      ],
    ],
    tooltip: words.patterns.onlyWhenItIsExactlyThisNumber,
    aria: words.patterns.exactly(textIn(extra, "value", "0")),
  }),
  press: noButtons,
  meaning: {
    as: "pattern",
    read(r) {
      const text = textIn(r.extra, "value", "0").trim()
      checkNumber(r, text)
      return {kind: "number-pattern", text, from: r.from}
    },
    write: p => (p.kind === "number-pattern" ? {extra: {value: p.text}} : undefined),
  },
}

const string: BlockSpec = {
  type: "pattern_text",
  shape: extra => ({
    family: "own",
    connects: {as: "pattern"},
    rows: [
      [
        {kind: "label", text: "“"},
        {kind: "text", key: "value", value: textIn(extra, "value"), aria: words.patterns.exactlyThisText},
        {kind: "label", text: "”"},
      ],
    ],
    tooltip: words.patterns.onlyWhenItIsExactlyThisText,
    aria: words.patterns.exactlyTheText(textIn(extra, "value")),
  }),
  press: noButtons,
  meaning: {
    as: "pattern",
    read: r => ({kind: "string-pattern", value: textIn(r.extra, "value"), from: r.from}),
    write: p => (p.kind === "string-pattern" ? {extra: {value: p.value}} : undefined),
  },
}

const character: BlockSpec = {
  type: "pattern_character",
  shape: extra => ({
    family: "own",
    connects: {as: "pattern"},
    rows: [
      [
        {kind: "label", text: "‘"},
        {
          kind: "text",
          key: "value",
          value: textIn(extra, "value", "a"),
          aria: words.patterns.exactlyThisCharacter,
        },
        {kind: "label", text: "’"},
      ],
    ],
    tooltip: words.patterns.onlyWhenItIsExactlyThisCharacter,
    aria: words.patterns.exactlyTheCharacter(textIn(extra, "value", "a")),
  }),
  press: noButtons,
  meaning: {
    as: "pattern",
    read: r => ({kind: "character-pattern", value: textIn(r.extra, "value", "a"), from: r.from}),
    write: p => (p.kind === "character-pattern" ? {extra: {value: p.value}} : undefined),
  },
}

const tuple: BlockSpec = {
  type: "pattern_tuple",
  shape(extra) {
    const count = countIn(extra, "items", 2)
    const items: Item[] = count === 0 ? [{kind: "label", text: "()"}] : []
    for (let i = 0; i < Math.min(count, shownParts); i++) {
      items.push({kind: "label", text: i === 0 ? "(" : ","})
      items.push({kind: "socket", name: `I${i}`, sort: "pattern", aria: words.patterns.part(i + 1)})
    }
    if (count > 0) items.push(...foldLabel(count), {kind: "label", text: ")"})
    if (!isFolded(count, true))
      items.push({kind: "button", action: "more", text: "+", aria: words.patterns.oneMorePart})
    if (count > 2 && !isFolded(count, false))
      items.push({kind: "button", action: "fewer", text: "−", aria: words.patterns.onePartLess})
    return {
      family: "own",
      connects: {as: "pattern"},
      rows: [items],
      tooltip: words.patterns.severalThingsThatComeTogether,
      aria: words.patterns.thingsTogether(count),
    }
  },
  press(extra, action) {
    const now = countIn(extra, "items", 2)
    if (action === "more") return {...extra, items: now === 0 ? 2 : Math.max(now, Math.min(9, now + 1))}
    return isFolded(now, false) ? extra : {...extra, items: Math.max(2, now - 1)}
  },
  meaning: {
    as: "pattern",
    read(r) {
      const count = countIn(r.extra, "items", 2)
      const items: Pattern[] = []
      if (count === 0) return {kind: "constructor-pattern", name: "()", args: [], from: r.from}
      for (let i = 0; i < Math.max(2, count); i++) items.push(r.pattern(`I${i}`))
      return {kind: "tuple-pattern", items, from: r.from}
    },
    write(p) {
      if (p.kind === "constructor-pattern" && p.name === "()") return {extra: {items: 0}}
      if (p.kind !== "tuple-pattern" || p.items.length === 1) return undefined
      return {
        extra: {items: p.items.length},
        sockets: Object.fromEntries(p.items.map((x, i) => [`I${i}`, x])),
      }
    },
  },
}

const list: BlockSpec = {
  type: "pattern_list",
  shape(extra) {
    const count = countIn(extra, "items", 0)
    const items: Item[] = [
      {kind: "label", text: count === 0 ? words.patterns.emptyList : words.patterns.list},
    ]
    for (let i = 0; i < Math.min(count, shownParts); i++)
      items.push({kind: "socket", name: `I${i}`, sort: "pattern", aria: words.patterns.item(i + 1)})
    items.push(...foldLabel(count))
    if (!isFolded(count, true))
      items.push({kind: "button", action: "more", text: "+", aria: words.patterns.oneMoreItem})
    if (count > 0 && !isFolded(count, false))
      items.push({kind: "button", action: "fewer", text: "−", aria: words.patterns.oneItemLess})
    return {
      family: "own",
      connects: {as: "pattern"},
      rows: [items],
      tooltip: words.patterns.onlyWhenItIsAList,
      aria: count === 0 ? words.patterns.emptyList : words.patterns.listOf(count),
    }
  },
  press: counting("items", 0, 0),
  meaning: {
    as: "pattern",
    read(r) {
      const items: Pattern[] = []
      for (let i = 0; i < countIn(r.extra, "items", 0); i++) items.push(r.pattern(`I${i}`))
      return {kind: "list-pattern", items, from: r.from}
    },
    write: p =>
      p.kind === "list-pattern"
        ? {extra: {items: p.items.length}, sockets: Object.fromEntries(p.items.map((x, i) => [`I${i}`, x]))}
        : undefined,
  },
}

const infix: BlockSpec = {
  type: "pattern_infix",
  shape(extra) {
    const op = textIn(extra, "op", ":")
    return {
      family: "own",
      connects: {as: "pattern"},
      rows: [
        [
          {
            kind: "socket",
            name: "L",
            sort: "pattern",
            aria: op === ":" ? words.patterns.firstItem : words.patterns.left,
            hint: words.patterns.first,
          },
          {kind: "label", text: op},
          {
            kind: "socket",
            name: "R",
            sort: "pattern",
            aria: op === ":" ? words.patterns.otherItems : words.patterns.right,
            hint: words.patterns.rest,
          },
        ],
      ],
      tooltip: words.patterns.aListsFirstItemAndTheRest,
      aria: op === ":" ? words.patterns.firstItemAndTheRest : words.patterns.pattern(op),
    }
  },
  press: noButtons,
  meaning: {
    as: "pattern",
    read: r => ({
      kind: "infix-pattern",
      op: textIn(r.extra, "op", ":"),
      left: r.pattern("L"),
      right: r.pattern("R"),
      from: r.from,
    }),
    write: p =>
      p.kind === "infix-pattern" ? {extra: {op: p.op}, sockets: {L: p.left, R: p.right}} : undefined,
  },
}

const as: BlockSpec = {
  type: "pattern_as",
  shape: extra => ({
    family: "own",
    connects: {as: "pattern"},
    rows: [
      [
        {kind: "binder", key: "name", value: textIn(extra, "name", "x"), aria: words.patterns.nameOfTheWhole},
        {kind: "label", text: words.patterns.whichIs},
        {kind: "socket", name: "P", sort: "pattern", aria: words.patterns.whatIt},
      ],
    ],
    tooltip: words.patterns.namesTheWholeAndLooksInsideAt,
    aria: words.patterns.nameForTheWhole(textIn(extra, "name", "x")),
  }),
  press: noButtons,
  meaning: {
    as: "pattern",
    read: r => ({
      kind: "as-pattern",
      name: checkedName(r, "name", "x"),
      pattern: r.pattern("P"),
      from: r.from,
    }),
    write: p => (p.kind === "as-pattern" ? {extra: {name: p.name}, sockets: {P: p.pattern}} : undefined),
  },
}

export const patterns: readonly BlockSpec[] = [
  name,
  any,
  choice,
  construct,
  tuple,
  list,
  infix,
  as,
  number,
  string,
  character,
]
