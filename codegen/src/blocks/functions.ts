/// Names and functions: use a name, call a function, make one on the spot, define things for one expression.

import {isConstructorName} from "../haskell/lexemes.ts"
import type {Expr, Pattern} from "../model/tree.ts"
import type {Family, Item} from "../shape.ts"
import {operatorMenu, operatorOptions} from "./choices.ts"
import {exampleOf} from "./samples.ts"
import type {BlockSpec} from "./spec.ts"
import {countIn, counting, noButtons, textIn} from "./spec.ts"

const taskWords = new Set(
  "task once say wait parallel race forever when unless replicateM_ replicateM forM_ mapM_ return pure".split(
    " ",
  ),
)

function familyOfName(name: string): Family {
  return taskWords.has(name) ? "task" : "own"
}

const name: BlockSpec = {
  type: "name",
  shape(extra) {
    const word = textIn(extra, "name", "x")
    const args = countIn(extra, "args", 0)
    const items: Item[] = [{kind: "reference", key: "name", value: word, aria: "name"}]
    for (let i = 0; i < args; i++)
      items.push({kind: "socket", name: `A${i}`, sort: "expression", aria: `${word}: input ${i + 1}`})
    if (args > 0 || extra.fn === true) {
      items.push({kind: "button", action: "more", text: "+", aria: "give one more input"})
      if (args > 0) items.push({kind: "button", action: "fewer", text: "−", aria: "give one input less"})
    }
    return {
      family: familyOfName(word),
      connects: {as: "expression"},
      rows: [items],
      tooltip: `${args === 0 ? `What ${word} stands for.` : `What ${word} makes of its inputs.`} Example: ${exampleOf(word, args)}.`,
      aria: word,
      help: `v:${word}`,
    }
  },
  press: counting("args", 0, 0),
  meaning: {
    as: "expression",
    read(r) {
      const word = textIn(r.extra, "name", "x")
      const count = countIn(r.extra, "args", 0)
      // A constructor that was dragged out of its type is a name like any other.
      const fn: Expr = {
        kind: isConstructorName(word) ? "constructor-name" : "variable",
        name: word,
        from: r.from,
      }
      if (word.trim() === "")
        r.problem("name", "This name is empty.", "Put a name here that is known in this place.")
      if (count === 0) return fn
      const args: Expr[] = []
      for (let i = 0; i < count; i++) args.push(r.expr(`A${i}`))
      return {kind: "apply", fn, args, from: r.from}
    },
    write(e) {
      if (e.kind === "variable") return {extra: {name: e.name, args: 0}}
      if (e.kind !== "apply" || e.fn.kind !== "variable") return undefined
      return {
        extra: {name: e.fn.name, args: e.args.length},
        sockets: Object.fromEntries(e.args.map((a, i) => [`A${i}`, a])),
      }
    },
  },
}

const apply: BlockSpec = {
  type: "apply",
  shape(extra) {
    const args = countIn(extra, "args", 1, 1)
    const items: Item[] = [
      {kind: "label", text: "give to"},
      {kind: "socket", name: "F", sort: "expression", aria: "function", hint: "function"},
    ]
    for (let i = 0; i < args; i++)
      items.push({kind: "socket", name: `A${i}`, sort: "expression", aria: `input ${i + 1}`})
    items.push({kind: "button", action: "more", text: "+", aria: "give one more input"})
    if (args > 1) items.push({kind: "button", action: "fewer", text: "−", aria: "give one input less"})
    return {
      family: "own",
      connects: {as: "expression"},
      rows: [items],
      tooltip: "Gives inputs to any function. Example: give to (… * 2) the number 3: it makes 6.",
      aria: "give inputs to a function",
    }
  },
  press: counting("args", 1, 1),
  meaning: {
    as: "expression",
    read(r) {
      const args: Expr[] = []
      const fn = r.expr("F")
      for (let i = 0; i < countIn(r.extra, "args", 1, 1); i++) args.push(r.expr(`A${i}`))
      return {kind: "apply", fn, args, from: r.from}
    },
    write(e) {
      if (e.kind !== "apply" || e.args.length === 0) return undefined
      return {
        extra: {args: e.args.length},
        sockets: {F: e.fn, ...Object.fromEntries(e.args.map((a, i) => [`A${i}`, a]))},
      }
    },
  },
}

const lambda: BlockSpec = {
  type: "lambda",
  shape(extra) {
    const count = countIn(extra, "inputs", 1, 1)
    const items: Item[] = []
    for (let i = 0; i < count; i++) {
      items.push({kind: "label", text: i === 0 ? "function of" : "and"})
      items.push({kind: "socket", name: `P${i}`, sort: "pattern", aria: `input ${i + 1}`})
    }
    items.push({kind: "button", action: "more", text: "+", aria: "one more input"})
    if (count > 1) items.push({kind: "button", action: "fewer", text: "−", aria: "one input less"})
    items.push(
      {kind: "label", text: "gives"},
      {kind: "socket", name: "B", sort: "expression", aria: "what it gives"},
    )
    return {
      family: "own",
      connects: {as: "expression"},
      rows: [items],
      tooltip: "A function without a name. Example: function of x gives x + 1.",
      aria: "function without a name",
    }
  },
  press: counting("inputs", 1, 1),
  meaning: {
    as: "expression",
    read(r) {
      const parameters: Pattern[] = []
      for (let i = 0; i < countIn(r.extra, "inputs", 1, 1); i++) parameters.push(r.pattern(`P${i}`))
      return {kind: "lambda", parameters, body: r.expr("B"), from: r.from}
    },
    write(e) {
      if (e.kind !== "lambda" || e.parameters.length === 0) return undefined
      return {
        extra: {inputs: e.parameters.length},
        sockets: {...Object.fromEntries(e.parameters.map((p, i) => [`P${i}`, p])), B: e.body},
      }
    },
  },
}

const section: BlockSpec = {
  type: "section",
  shape(extra) {
    const op = textIn(extra, "op", "+")
    const menu: Item = {kind: "menu", key: "op", value: op, options: operatorOptions(op), aria: "operator"}
    const operand: Item = {kind: "socket", name: "X", sort: "expression", aria: "the known side"}
    const missing: Item = {kind: "label", text: "…"}
    return {
      family: operatorMenu(op).family,
      connects: {as: "expression"},
      rows: [
        [
          {kind: "label", text: "("},
          ...(textIn(extra, "side", "right") === "left"
            ? [operand, menu, missing]
            : [missing, menu, operand]),
          {kind: "label", text: ")"},
        ],
      ],
      tooltip: "An operator with one side still open: a function. Example: (… * 2) doubles.",
      aria: `operator ${op} with one side open`,
    }
  },
  press: noButtons,
  meaning: {
    as: "expression",
    read: r => ({
      kind: "section",
      op: textIn(r.extra, "op", "+"),
      side: textIn(r.extra, "side", "right") === "left" ? "left" : "right",
      operand: r.expr("X"),
      from: r.from,
    }),
    write: e =>
      e.kind === "section" ? {extra: {op: e.op, side: e.side}, sockets: {X: e.operand}} : undefined,
  },
}

const letBlock: BlockSpec = {
  type: "let",
  shape: () => ({
    family: "own",
    connects: {as: "expression"},
    rows: [
      [
        {kind: "label", text: "let"},
        {kind: "stack", name: "D", sort: "definition", aria: "definitions"},
      ],
      [
        {kind: "label", text: "in"},
        {kind: "socket", name: "B", sort: "expression", aria: "what they are used for"},
      ],
    ],
    tooltip: "Defines names for one expression. Example: let half be 0.25 in Velocity half 0.",
    aria: "let in",
  }),
  press: noButtons,
  meaning: {
    as: "expression",
    read: r => ({kind: "let", declarations: r.definitions("D"), body: r.expr("B"), from: r.from}),
    write: e =>
      e.kind === "let" && e.declarations.length > 0
        ? {extra: {}, sockets: {B: e.body}, stacks: {D: e.declarations}}
        : undefined,
  },
}

const typed: BlockSpec = {
  type: "typed",
  shape: extra => ({
    family: "own",
    connects: {as: "expression"},
    rows: [
      [
        {kind: "socket", name: "X", sort: "expression", aria: "value"},
        {kind: "label", text: "of type"},
        {kind: "type", key: "type", value: textIn(extra, "type", "Double"), aria: "type"},
      ],
    ],
    tooltip: "Says which type a value has. Example: 3 of type Double.",
    aria: `value of type ${textIn(extra, "type", "Double")}`,
  }),
  press: noButtons,
  meaning: {
    as: "expression",
    read: r => ({
      kind: "typed",
      expr: r.expr("X"),
      type: {kind: "type", text: textIn(r.extra, "type", "Double"), from: r.from},
      from: r.from,
    }),
    write: e => (e.kind === "typed" ? {extra: {type: e.type.text}, sockets: {X: e.expr}} : undefined),
  },
}

export const functions: readonly BlockSpec[] = [name, apply, lambda, section, letBlock, typed]
