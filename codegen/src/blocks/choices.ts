/// Choices: if, case, and the operators that compute, compare and combine.

import type {Alternative, Declaration, Expr, Pattern, Statement} from "../model/tree.ts"
import type {Extra} from "../saved.ts"
import type {Family, Row} from "../shape.ts"
import {partMenu, partOf, pressPart, readRight, rightRows, savedPart, writeRight} from "./rightside.ts"
import type {BlockSpec} from "./spec.ts"
import {noButtons, objectsIn, textIn} from "./spec.ts"

const ifBlock: BlockSpec = {
  type: "if",
  shape: () => ({
    family: "choice",
    connects: {as: "expression"},
    rows: [
      [
        {kind: "label", text: "if"},
        {kind: "socket", name: "C", sort: "expression", aria: "condition", hint: "condition"},
        {kind: "label", text: "then"},
        {kind: "socket", name: "T", sort: "expression", aria: "if so"},
        {kind: "label", text: "else"},
        {kind: "socket", name: "F", sort: "expression", aria: "if not"},
      ],
    ],
    tooltip: "One of two values. Example: if hit then Velocity 0 0 else Velocity 0.5 0.",
    aria: "if then else",
  }),
  press: noButtons,
  meaning: {
    as: "expression",
    read: r => ({kind: "if", condition: r.expr("C"), yes: r.expr("T"), no: r.expr("F"), from: r.from}),
    write: e => (e.kind === "if" ? {extra: {}, sockets: {C: e.condition, T: e.yes, F: e.no}} : undefined),
  },
}

const caseBlock: BlockSpec = {
  type: "case",
  shape(extra) {
    const alternatives = alternativesOf(extra)
    const rows: Row[] = [
      [
        {kind: "label", text: "look at"},
        {kind: "socket", name: "X", sort: "expression", aria: "what to look at"},
      ],
    ]
    for (const [i, a] of alternatives.entries()) {
      rows.push([
        {kind: "label", text: "when"},
        {kind: "socket", name: `P${i}`, sort: "pattern", aria: `case ${i + 1}`},
      ])
      rows.push(...rightRows(i, partOf(a), "then", "result"))
    }
    rows.push([
      {kind: "button", action: "more-cases", text: "+", aria: "one more case"},
      ...(alternatives.length > 1
        ? ([{kind: "button", action: "fewer-cases", text: "−", aria: "remove the last case"}] as const)
        : []),
    ])
    return {
      family: "choice",
      connects: {as: "expression"},
      rows,
      tooltip:
        "Looks at a value and takes the first case that matches. Example: look at mode, when Go then Velocity 0.5 0.",
      aria: "look at a value and choose",
      menu: alternatives.flatMap((a, i) =>
        partMenu(i, partOf(a), alternatives.length > 1 ? `, case ${i + 1}` : ""),
      ),
    }
  },
  press(extra, action) {
    const alternatives = alternativesOf(extra)
    const [what = "", index = "0"] = action.split(".")
    if (what === "more-cases") return {...extra, alternatives: [...alternatives, {}]}
    if (what === "fewer-cases")
      return {...extra, alternatives: alternatives.slice(0, Math.max(1, alternatives.length - 1))}
    return {
      ...extra,
      alternatives: alternatives.map((a, i) =>
        i === Number(index) ? savedPart(pressPart(partOf(a), what)) : a,
      ),
    }
  },
  meaning: {
    as: "expression",
    read: r => ({
      kind: "case",
      scrutinee: r.expr("X"),
      alternatives: alternativesOf(r.extra).map((a, i): Alternative => {
        return {
          kind: "alternative",
          pattern: r.pattern(`P${i}`),
          right: readRight(r, i, partOf(a)),
          from: r.from,
        }
      }),
      from: r.from,
    }),
    write(e) {
      if (e.kind !== "case" || e.alternatives.length === 0) return undefined
      const sockets: {[input: string]: Expr | Pattern} = {X: e.scrutinee}
      const stacks: {[input: string]: readonly (Declaration | Statement)[]} = {}
      const alternatives: Extra[] = []
      for (const [i, a] of e.alternatives.entries()) {
        const right = writeRight(i, a.right)
        if (right === undefined || a.comment !== undefined) return undefined
        sockets[`P${i}`] = a.pattern
        Object.assign(sockets, right.sockets)
        Object.assign(stacks, right.stacks)
        alternatives.push(savedPart(right.part))
      }
      return {extra: {alternatives}, sockets, stacks}
    },
  },
}

function alternativesOf(extra: Extra): readonly Extra[] {
  const alternatives = objectsIn(extra, "alternatives")
  return alternatives.length === 0 ? [{}] : alternatives
}

/// Operators that can stand for each other in the block's menu.
const menus: readonly {readonly family: Family; readonly ops: readonly string[]; readonly tooltip: string}[] =
  [
    {family: "number", ops: ["+", "-", "*", "/"], tooltip: "Computes with two numbers. Example: vl + 0.5."},
    {
      family: "number",
      ops: ["div", "mod", "quot", "rem"],
      tooltip: "Divides whole numbers. Example: 7 mod 2 is 1.",
    },
    {family: "number", ops: ["^", "**"], tooltip: "A power. Example: 2 ^ 3 is 8."},
    {
      family: "choice",
      ops: ["==", "/=", "<", "<=", ">", ">="],
      tooltip: "Compares two values. Example: vl > 0.",
    },
    {family: "choice", ops: ["&&", "||"], tooltip: "Combines two conditions. Example: hit && fast."},
    {
      family: "own",
      ops: ["++", "<>"],
      tooltip: "Puts two lists or texts together. Example: “at ” ++ show 3 is “at 3”.",
    },
    {
      family: "number",
      ops: ["addVec", "subVec"],
      tooltip:
        "Puts two arrows together, or takes one from the other. Example: goal subVec here points from here to the goal.",
    },
    {
      family: "own",
      ops: [":"],
      tooltip: "A list with one more item in front. Example: 1 : list 2 3 is list 1 2 3.",
    },
    {
      family: "own",
      ops: ["$", "."],
      tooltip: "Gives a value to a function, or chains two functions. Example: (abs . negate) 2 is 2.",
    },
  ]

/// What a screen reader says for a symbol.
const spoken: {readonly [op: string]: string} = {
  "+": "plus",
  "-": "minus",
  "*": "times",
  "/": "divided by",
  "==": "equals",
  "/=": "differs from",
  "<": "is less than",
  "<=": "is at most",
  ">": "is greater than",
  ">=": "is at least",
  "&&": "and",
  "||": "or",
}

export function operatorMenu(op: string): (typeof menus)[number] {
  return (
    menus.find(m => m.ops.includes(op)) ?? {
      family: "own",
      ops: [op],
      tooltip: `The operator ${op}. Example: a ${op} b.`,
    }
  )
}

export function operatorOptions(op: string): (readonly [string, string])[] {
  return operatorMenu(op).ops.map(o => [o === "*" ? "×" : o === "/=" ? "≠" : o, o] as const)
}

const infix: BlockSpec = {
  type: "infix",
  shape(extra) {
    const op = textIn(extra, "op", "+")
    const menu = operatorMenu(op)
    return {
      family: menu.family,
      connects: {as: "expression"},
      rows: [
        [
          {kind: "socket", name: "L", sort: "expression", aria: "left side"},
          {kind: "menu", key: "op", value: op, options: operatorOptions(op), aria: "operator"},
          {kind: "socket", name: "R", sort: "expression", aria: "right side"},
        ],
      ],
      tooltip: menu.tooltip,
      aria: spoken[op] ?? op,
      help: `v:${op}`,
    }
  },
  press: noButtons,
  meaning: {
    as: "expression",
    read: r => ({
      kind: "infix",
      op: textIn(r.extra, "op", "+"),
      left: r.expr("L"),
      right: r.expr("R"),
      from: r.from,
    }),
    write: e => (e.kind === "infix" ? {extra: {op: e.op}, sockets: {L: e.left, R: e.right}} : undefined),
  },
}

const negate: BlockSpec = {
  type: "negate",
  shape: () => ({
    family: "number",
    connects: {as: "expression"},
    rows: [
      [
        {kind: "label", text: "−"},
        {kind: "socket", name: "X", sort: "expression", aria: "number"},
      ],
    ],
    tooltip: "The same number on the other side of zero. Example: − 2 is -2.",
    aria: "minus",
  }),
  press: noButtons,
  meaning: {
    as: "expression",
    read: r => ({kind: "negate", expr: r.expr("X"), from: r.from}),
    write: e => (e.kind === "negate" ? {extra: {}, sockets: {X: e.expr}} : undefined),
  },
}

export const choiceBlocks: readonly BlockSpec[] = [ifBlock, caseBlock, infix, negate]
