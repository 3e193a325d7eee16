/// Values: numbers, text, constructors with their parts, choices from a menu, tuples, lists.

import type {Item} from "../../block_shape.ts"
import {isNumberLiteral} from "../../haskell/lexemes.ts"
import type {Expr} from "../../model/syntax_tree.ts"
import type {Extra} from "../../serialized_blocks.ts"
import {words} from "../../words/index.ts"
import type {BlockSpec, Reader} from "../spec/block_spec.ts"
import {
  countIn,
  counting,
  foldLabel,
  isFolded,
  listIn,
  noButtons,
  shownParts,
  textIn,
} from "../spec/block_spec.ts"
import {choiceOf, choices, exampleNameOf, labelsOf, units, valueLabel} from "../spec/constructor_labels.ts"

const number: BlockSpec = {
  type: "number",
  shape: extra => ({
    family: "number",
    connects: {as: "expression"},
    rows: [[{kind: "number", key: "value", value: textIn(extra, "value", "0"), aria: words.values.number}]],
    tooltip: words.values.aNumber,
    aria: words.values.number2(textIn(extra, "value", "0")),
  }),
  press: noButtons,
  meaning: {
    as: "expression",
    read(r) {
      const text = textIn(r.extra, "value", "0").trim()
      checkNumber(r, text)
      return {kind: "number", text, from: r.from}
    },
    write: e =>
      e.kind === "number"
        ? {extra: {value: e.text}}
        : e.kind === "negate" && e.expr.kind === "number" && !e.expr.text.startsWith("-")
          ? {extra: {value: `-${e.expr.text}`}}
          : undefined,
  },
}

export function checkNumber(r: Reader, text: string): void {
  if (!isNumberLiteral(text.replace(/^-/, "")))
    r.problem("number", words.values.isNotANumber(text), words.values.writeItWithDigitsLike2)
}

const string: BlockSpec = {
  type: "text",
  shape: extra => ({
    family: "own",
    connects: {as: "expression"},
    rows: [
      [
        {kind: "label", text: "“"},
        {kind: "text", key: "value", value: textIn(extra, "value"), aria: words.values.text},
        {kind: "label", text: "”"},
      ],
    ],
    tooltip: words.values.aPieceOfText,
    aria: words.values.text2(textIn(extra, "value")),
  }),
  press: noButtons,
  meaning: {
    as: "expression",
    read: r => ({kind: "string", value: textIn(r.extra, "value"), from: r.from}),
    write: e => (e.kind === "string" ? {extra: {value: e.value}} : undefined),
  },
}

const character: BlockSpec = {
  type: "character",
  shape: extra => ({
    family: "own",
    connects: {as: "expression"},
    rows: [
      [
        {kind: "label", text: "‘"},
        {kind: "text", key: "value", value: textIn(extra, "value", "a"), aria: words.values.oneCharacter},
        {kind: "label", text: "’"},
      ],
    ],
    tooltip: words.values.oneCharacter2,
    aria: words.values.character(textIn(extra, "value", "a")),
  }),
  press: noButtons,
  meaning: {
    as: "expression",
    read: r => ({kind: "character", value: textIn(r.extra, "value", "a"), from: r.from}),
    write: e => (e.kind === "character" ? {extra: {value: e.value}} : undefined),
  },
}

const construct: BlockSpec = {
  type: "construct",
  shape(extra) {
    const name = textIn(extra, "con", "Just")
    const look = labelsOf(name)
    const args = countIn(extra, "args", 0)
    const items: Item[] = [{kind: "label", text: look.word ?? name}]
    for (let i = 0; i < Math.min(args, shownParts); i++) {
      const part = look.parts[i] ?? words.values.part(i + 1)
      items.push({
        kind: "socket",
        name: `A${i}`,
        sort: "expression",
        aria: `${look.word ?? name}: ${part}`,
        hint: part,
      })
      const unit = units[name]?.[i]
      if (unit !== undefined) items.push({kind: "label", text: unit, unit: true})
    }
    items.push(...foldLabel(args))
    return {
      family: look.family,
      connects: {as: "expression"},
      rows: [items],
      tooltip: look.tooltip,
      aria: look.word ?? name,
      help: `v:${name}`,
      menu: [
        {action: "more", text: words.values.giveItOneValueMore},
        ...(args > 0
          ? [
              {action: "fewer", text: words.values.giveItOneValueLess},
              {action: "bare", text: words.values.useItAsAFunction},
            ]
          : []),
      ],
    }
  },
  press: (extra, action) => (action === "bare" ? {...extra, args: 0} : counting("args", 0, 0)(extra, action)),
  meaning: {
    as: "expression",
    read(r) {
      const fn: Expr = {kind: "constructor-name", name: textIn(r.extra, "con", "Just"), from: r.from}
      const count = countIn(r.extra, "args", 0)
      if (count === 0) return fn
      const args: Expr[] = []
      for (let i = 0; i < count; i++) args.push(r.expr(`A${i}`))
      return {kind: "apply", fn, args, from: r.from}
    },
    write(e) {
      if (e.kind === "constructor-name")
        return choiceOf(e.name) === undefined ? {extra: {con: e.name, args: 0}} : undefined
      if (e.kind !== "apply" || e.fn.kind !== "constructor-name") return undefined
      return {
        extra: {con: e.fn.name, args: e.args.length},
        sockets: Object.fromEntries(e.args.map((a, i) => [`A${i}`, a])),
      }
    },
  },
}

export function choiceItems(type: string, value: string): Item[] {
  const look = choices[type]
  const options = look?.options ?? []
  const all = options.includes(value) ? options : [value, ...options]
  const menu: Item = {
    kind: "menu",
    key: "value",
    value,
    options: all.map(o => [valueLabel(type, o), o] as const),
    aria: exampleNameOf(type),
  }
  return look?.word === undefined ? [menu] : [{kind: "label", text: look.word}, menu]
}

export function choiceValue(type: string, value: string): string {
  return value !== "" ? value : (choices[type]?.options[0] ?? "True")
}

const choice: BlockSpec = {
  type: "choice",
  shape(extra) {
    const type = textIn(extra, "of", "Bool")
    const value = choiceValue(type, textIn(extra, "value"))
    return {
      family: choices[type]?.family ?? "own",
      connects: {as: "expression"},
      rows: [choiceItems(type, value)],
      tooltip: words.values.oneOf((choices[type]?.options ?? [value]).join(", "), value),
      aria: `${exampleNameOf(type)} ${valueLabel(type, value)}`,
      help: `t:${type}`,
    }
  },
  press: noButtons,
  meaning: {
    as: "expression",
    read: r => ({
      kind: "constructor-name",
      name: choiceValue(textIn(r.extra, "of", "Bool"), textIn(r.extra, "value")),
      from: r.from,
    }),
    write(e) {
      const type = e.kind === "constructor-name" ? choiceOf(e.name) : undefined
      return e.kind === "constructor-name" && type !== undefined
        ? {extra: {of: type, value: e.name}}
        : undefined
    },
  },
}

/// The parts of a tuple that stay open.
function gapsIn(extra: Extra): ReadonlySet<number> {
  return new Set(listIn(extra, "gaps").filter(n => typeof n === "number"))
}

const tuple: BlockSpec = {
  type: "tuple",
  shape(extra) {
    const count = countIn(extra, "items", 2)
    if (count === 0)
      return {
        family: "own",
        connects: {as: "expression"},
        rows: [
          [
            {kind: "label", text: "()"},
            {kind: "button", action: "more", text: "+", aria: words.values.oneMorePart},
          ],
        ],
        tooltip: words.values.theValueThatSaysNothing,
        aria: words.values.nothingInParticular,
      }
    const gaps = gapsIn(extra)
    const items: Item[] = []
    for (let i = 0; i < Math.min(count, shownParts); i++) {
      items.push({kind: "label", text: i === 0 ? "(" : ","})
      items.push(
        gaps.has(i)
          ? {kind: "label", text: "…"}
          : {kind: "socket", name: `I${i}`, sort: "expression", aria: words.values.part(i + 1)},
      )
    }
    items.push(...foldLabel(count), {kind: "label", text: ")"})
    if (!isFolded(count, true))
      items.push({kind: "button", action: "more", text: "+", aria: words.values.oneMorePart})
    if (count > 2 && !isFolded(count, false))
      items.push({kind: "button", action: "fewer", text: "−", aria: words.values.onePartLess})
    return {
      family: "own",
      connects: {as: "expression"},
      rows: [items],
      tooltip:
        gaps.size > 0 ? words.values.aTupleWithOpenParts : words.values.severalValuesTogetherSentToTheRobot,
      aria: words.values.valuesTogether(count),
    }
  },
  press(extra, action) {
    const now = countIn(extra, "items", 2)
    if (action === "more") return {...extra, items: now === 0 ? 2 : Math.max(now, Math.min(9, now + 1))}
    return isFolded(now, false) ? extra : {...extra, items: Math.max(2, now - 1)}
  },
  meaning: {
    as: "expression",
    read(r) {
      const count = countIn(r.extra, "items", 2)
      if (count === 0) return {kind: "constructor-name", name: "()", from: r.from}
      const gaps = gapsIn(r.extra)
      const items: Expr[] = []
      for (let i = 0; i < Math.max(2, count); i++)
        items.push(gaps.has(i) ? {kind: "gap", from: r.from} : r.expr(`I${i}`))
      return {kind: "tuple", items, from: r.from}
    },
    write(e) {
      if (e.kind === "constructor-name" && e.name === "()") return {extra: {items: 0}}
      if (e.kind !== "tuple" || e.items.length === 1) return undefined
      const gaps = e.items.flatMap((x, i) => (x.kind === "gap" ? [i] : []))
      return {
        extra: {items: e.items.length, ...(gaps.length > 0 ? {gaps} : {})},
        sockets: Object.fromEntries(
          e.items.flatMap((x, i) => (x.kind === "gap" ? [] : [[`I${i}`, x] as const])),
        ),
      }
    },
  },
}

const list: BlockSpec = {
  type: "list",
  shape(extra) {
    const count = countIn(extra, "items", 2)
    const items: Item[] = [{kind: "label", text: count === 0 ? words.values.emptyList : words.values.list}]
    for (let i = 0; i < Math.min(count, shownParts); i++)
      items.push({kind: "socket", name: `I${i}`, sort: "expression", aria: words.values.item(i + 1)})
    items.push(...foldLabel(count))
    if (!isFolded(count, true))
      items.push({kind: "button", action: "more", text: "+", aria: words.values.oneMoreItem})
    if (count > 0 && !isFolded(count, false))
      items.push({kind: "button", action: "fewer", text: "−", aria: words.values.oneItemLess})
    return {
      family: "own",
      connects: {as: "expression"},
      rows: [items],
      tooltip: words.values.anyNumberOfValuesOfOneType,
      aria: count === 0 ? words.values.emptyList : words.values.listOf(count),
    }
  },
  press: counting("items", 2, 0),
  meaning: {
    as: "expression",
    read(r) {
      const items: Expr[] = []
      for (let i = 0; i < countIn(r.extra, "items", 2); i++) items.push(r.expr(`I${i}`))
      return {kind: "list", items, from: r.from}
    },
    write: e =>
      e.kind === "list"
        ? {extra: {items: e.items.length}, sockets: Object.fromEntries(e.items.map((x, i) => [`I${i}`, x]))}
        : e.kind === "constructor-name" && e.name === "[]"
          ? {extra: {items: 0}}
          : undefined,
  },
}

const range: BlockSpec = {
  type: "range",
  shape(extra) {
    const items: Item[] = [
      {kind: "label", text: words.values.from},
      {kind: "socket", name: "A", sort: "expression", aria: words.values.first},
    ]
    if (extra.step === true)
      items.push(
        {kind: "label", text: words.values.thenWord},
        {kind: "socket", name: "S", sort: "expression", aria: words.values.second},
      )
    if (extra.end !== false)
      items.push(
        {kind: "label", text: words.values.to},
        {kind: "socket", name: "B", sort: "expression", aria: words.values.last},
      )
    items.push({
      kind: "button",
      action: "step",
      text: extra.step === true ? "−" : "+",
      aria: extra.step === true ? words.values.removeTheSecondValue : words.values.setTheSecondValue,
    })
    return {
      family: "own",
      connects: {as: "expression"},
      rows: [items],
      tooltip: words.values.theListOfAllValuesFromOne,
      aria: words.values.listFromOneValueToAnother,
    }
  },
  press: (extra, action) => (action === "step" ? {...extra, step: extra.step !== true} : extra),
  meaning: {
    as: "expression",
    read: r => ({
      kind: "range",
      first: r.expr("A"),
      ...(r.extra.step === true ? {second: r.expr("S")} : {}),
      ...(r.extra.end !== false ? {last: r.expr("B")} : {}),
      from: r.from,
    }),
    write(e) {
      if (e.kind !== "range") return undefined
      const sockets: {[input: string]: Expr} = {A: e.first}
      if (e.second !== undefined) sockets.S = e.second
      if (e.last !== undefined) sockets.B = e.last
      return {
        extra: {
          ...(e.second !== undefined ? {step: true} : {}),
          ...(e.last === undefined ? {end: false} : {}),
        },
        sockets,
      }
    },
  },
}

const comprehension: BlockSpec = {
  type: "comprehension",
  shape: () => ({
    family: "own",
    connects: {as: "expression"},
    rows: [
      [
        {kind: "label", text: words.values.listOf2},
        {kind: "socket", name: "B", sort: "expression", aria: words.values.whatIsInTheList},
      ],
      [
        {kind: "label", text: words.values.forAll},
        {kind: "stack", name: "S", sort: "step", aria: words.values.whereTheValuesComeFromAndWhich},
      ],
    ],
    tooltip: words.values.aListMadeFromOtherLists,
    aria: words.values.listMadeFromOtherLists,
  }),
  press: noButtons,
  meaning: {
    as: "expression",
    read: r => ({kind: "comprehension", body: r.expr("B"), statements: r.steps("S"), from: r.from}),
    write: e =>
      e.kind === "comprehension" && e.statements.length > 0
        ? {extra: {}, sockets: {B: e.body}, stacks: {S: e.statements}}
        : undefined,
  },
}

export const values: readonly BlockSpec[] = [
  number,
  string,
  character,
  tuple,
  list,
  range,
  comprehension,
  choice,
  construct,
]
