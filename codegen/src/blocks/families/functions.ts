/// Names and functions: use a name, call a function, make one on the spot, define things for one expression.

import type {Family, Item} from "../../block_shape.ts"
import {isConstructorName} from "../../haskell/lexemes.ts"
import type {Expr, Pattern} from "../../model/syntax_tree.ts"
import {words} from "../../words/index.ts"
import type {BlockSpec} from "../spec/block_spec.ts"
import {countIn, counting, foldLabel, isFolded, noButtons, shownParts, textIn} from "../spec/block_spec.ts"
import {operatorMenu, operatorOptions} from "./conditionals.ts"
import {exampleOf} from "./usage_examples.ts"

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
    const items: Item[] = [{kind: "reference", key: "name", value: word, aria: words.functions.name}]
    for (let i = 0; i < Math.min(args, shownParts); i++)
      items.push({
        kind: "socket",
        name: `A${i}`,
        sort: "expression",
        aria: words.functions.input(word, i + 1),
      })
    items.push(...foldLabel(args))
    if ((args > 0 || extra.fn === true) && !isFolded(args, true)) {
      items.push({kind: "button", action: "more", text: "+", aria: words.functions.giveOneMoreInput})
      if (args > 0)
        items.push({kind: "button", action: "fewer", text: "−", aria: words.functions.giveOneInputLess})
    }
    return {
      family: familyOfName(word),
      connects: {as: "expression"},
      rows: [items],
      tooltip:
        args === 0
          ? words.functions.whatStands(word, exampleOf(word, args))
          : words.functions.whatMakesOfItsInputs(word, exampleOf(word, args)),
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
        r.problem("name", words.functions.thisNameIsEmpty, words.functions.putANameHereThatIsKnown)
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
      {kind: "label", text: words.functions.giveTo},
      {
        kind: "socket",
        name: "F",
        sort: "expression",
        aria: words.functions.function,
        hint: words.functions.function,
      },
    ]
    for (let i = 0; i < Math.min(args, shownParts); i++)
      items.push({kind: "socket", name: `A${i}`, sort: "expression", aria: words.functions.input2(i + 1)})
    items.push(...foldLabel(args))
    if (!isFolded(args, true))
      items.push({kind: "button", action: "more", text: "+", aria: words.functions.giveOneMoreInput})
    if (args > 1 && !isFolded(args, false))
      items.push({kind: "button", action: "fewer", text: "−", aria: words.functions.giveOneInputLess})
    return {
      family: "own",
      connects: {as: "expression"},
      rows: [items],
      tooltip: words.functions.givesInputsToAnyFunction,
      aria: words.functions.giveInputsToAFunction,
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
    for (let i = 0; i < Math.min(count, shownParts); i++) {
      items.push({kind: "label", text: i === 0 ? words.functions.functionOf : words.functions.and})
      items.push({kind: "socket", name: `P${i}`, sort: "pattern", aria: words.functions.input2(i + 1)})
    }
    items.push(...foldLabel(count))
    if (!isFolded(count, true))
      items.push({kind: "button", action: "more", text: "+", aria: words.functions.oneMoreInput})
    if (count > 1 && !isFolded(count, false))
      items.push({kind: "button", action: "fewer", text: "−", aria: words.functions.oneInputLess})
    items.push(
      {kind: "label", text: words.functions.gives},
      {kind: "socket", name: "B", sort: "expression", aria: words.functions.whatItGives},
    )
    return {
      family: "own",
      connects: {as: "expression"},
      rows: [items],
      tooltip: words.functions.aFunctionWithoutAName,
      aria: words.functions.functionWithoutAName,
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
    const menu: Item = {
      kind: "menu",
      key: "op",
      value: op,
      options: operatorOptions(op),
      aria: words.functions.operator,
    }
    const operand: Item = {kind: "socket", name: "X", sort: "expression", aria: words.functions.theKnownSide}
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
      tooltip: words.functions.anOperatorWithOneSideStillOpen,
      aria: words.functions.operatorWithOneSideOpen(op),
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
        {kind: "label", text: words.functions.let},
        {kind: "stack", name: "D", sort: "definition", aria: words.functions.definitions},
      ],
      [
        {kind: "label", text: words.functions.in},
        {kind: "socket", name: "B", sort: "expression", aria: words.functions.whatTheyAreUsed},
      ],
    ],
    tooltip: words.functions.definesNamesForOneExpression,
    aria: words.functions.letIn,
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
        {kind: "socket", name: "X", sort: "expression", aria: words.functions.value},
        {kind: "label", text: words.functions.ofType},
        {kind: "type", key: "type", value: textIn(extra, "type", "Double"), aria: words.functions.type},
      ],
    ],
    tooltip: words.functions.saysWhichTypeAValueHas,
    aria: words.functions.valueOfType(textIn(extra, "type", "Double")),
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

const typeApply: BlockSpec = {
  type: "type_apply",
  onlyFromText: true,
  shape: extra => ({
    family: "own",
    connects: {as: "expression"},
    rows: [
      [
        {kind: "socket", name: "F", sort: "expression", aria: words.functions.function},
        {kind: "label", text: words.functions.forType},
        {kind: "type", key: "type", value: textIn(extra, "type", "Int"), aria: words.functions.type},
      ],
    ],
    tooltip: words.functions.saysForWhichTypeAFunctionIsUsed,
    aria: words.functions.functionForType(textIn(extra, "type", "Int")),
  }),
  press: noButtons,
  meaning: {
    as: "expression",
    read: r => ({
      kind: "type-apply",
      fn: r.expr("F"),
      type: {kind: "type", text: textIn(r.extra, "type", "Int"), from: r.from},
      from: r.from,
    }),
    write: e => (e.kind === "type-apply" ? {extra: {type: e.type.text}, sockets: {F: e.fn}} : undefined),
  },
}

export const functions: readonly BlockSpec[] = [name, apply, lambda, section, letBlock, typed, typeApply]
