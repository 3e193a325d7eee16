/// Blocks for choices: if, case, and the operators that compute, compare and combine.

import type {Family, Row} from "../../block_shape.ts"
import type {Alternative, Declaration, Expr, Pattern, Statement} from "../../model/syntax_tree.ts"
import type {Extra} from "../../serialized_blocks.ts"
import {perLanguage, words} from "../../words/index.ts"
import type {BlockSpec} from "../spec/block_spec.ts"
import {foldLabel, isFolded, noButtons, objectsIn, shownParts, textIn} from "../spec/block_spec.ts"
import type {Part} from "./right_hand_side.ts"
import {partMenu, partOf, pressPart, readRight, rightRows, savedPart, writeRight} from "./right_hand_side.ts"

const ifBlock: BlockSpec = {
  type: "if",
  shape: () => ({
    family: "choice",
    connects: {as: "expression"},
    rows: [
      [
        {kind: "label", text: words.choices.if},
        {
          kind: "socket",
          name: "C",
          sort: "expression",
          aria: words.choices.condition,
          hint: words.choices.condition,
        },
        {kind: "label", text: words.choices.thenWord},
        {kind: "socket", name: "T", sort: "expression", aria: words.choices.ifSo},
        {kind: "label", text: words.choices.else},
        {kind: "socket", name: "F", sort: "expression", aria: words.choices.ifNot},
      ],
    ],
    tooltip: words.choices.oneOfTwoValues,
    aria: words.choices.ifThenElse,
  }),
  press: noButtons,
  meaning: {
    as: "expression",
    read: r => ({kind: "if", condition: r.expr("C"), yes: r.expr("T"), no: r.expr("F"), from: r.from}),
    write: e => (e.kind === "if" ? {extra: {}, sockets: {C: e.condition, T: e.yes, F: e.no}} : undefined),
  },
}

/// An `if` of many branches.
const branches: BlockSpec = {
  type: "branches",
  shape(extra) {
    const part = branchesOf(extra)
    return {
      family: "choice",
      connects: {as: "expression"},
      rows: rightRows(0, part, words.choices.thenWord, words.choices.result, ""),
      tooltip: words.choices.takesTheFirstThatHolds,
      aria: words.choices.theFirstThatHolds,
      menu: partMenu(0, part, "").filter(({action}) => !action.startsWith("where")),
    }
  },
  press: (extra, action) => savedPart(pressPart(branchesOf(extra), action.split(".")[0] ?? "")),
  meaning: {
    as: "expression",
    read(r) {
      const {body} = readRight(r, 0, branchesOf(r.extra))
      return {kind: "branches", branches: Array.isArray(body) ? body : [], from: r.from}
    },
    write(e) {
      if (e.kind !== "branches") return undefined
      const right = writeRight(0, {kind: "right", body: e.branches, where: []})
      return right && {extra: savedPart(right.part), sockets: right.sockets, stacks: right.stacks}
    },
  },
}

/// There is always one branch.
function branchesOf(extra: Extra): Part {
  const part = partOf(extra)
  return {...part, guards: Math.max(1, part.guards), where: false}
}

/// With `lambda`, what it looks at is its input: a function.
const caseBlock: BlockSpec = {
  type: "case",
  shape(extra) {
    const alternatives = alternativesOf(extra)
    const rows: Row[] = [
      extra.lambda === true
        ? [{kind: "label", text: words.choices.lookAtTheInput}]
        : [
            {kind: "label", text: words.choices.lookAt},
            {kind: "socket", name: "X", sort: "expression", aria: words.choices.whatToLookAt},
          ],
    ]
    for (const [i, a] of alternatives.slice(0, shownParts).entries()) {
      rows.push([
        {kind: "label", text: words.choices.when},
        {kind: "socket", name: `P${i}`, sort: "pattern", aria: words.choices.case(i + 1)},
      ])
      const which = alternatives.length > 1 ? words.choices.case2(i + 1) : ""
      rows.push(...rightRows(i, partOf(a), words.choices.thenWord, words.choices.result, which))
    }
    if (alternatives.length > shownParts) rows.push(foldLabel(alternatives.length))
    rows.push([
      ...(isFolded(alternatives.length, true)
        ? []
        : ([{kind: "button", action: "more-cases", text: "+", aria: words.choices.oneMoreCase}] as const)),
      ...(alternatives.length > 1 && !isFolded(alternatives.length, false)
        ? ([
            {kind: "button", action: "fewer-cases", text: "−", aria: words.choices.removeTheLastCase},
          ] as const)
        : []),
    ])
    return {
      family: "choice",
      connects: {as: "expression"},
      rows,
      tooltip: words.choices.looksAtAValueAndTakes,
      aria: words.choices.lookAtAValueAndChoose,
      menu: alternatives
        .slice(0, shownParts)
        .flatMap((a, i) => partMenu(i, partOf(a), alternatives.length > 1 ? words.choices.case2(i + 1) : "")),
    }
  },
  press(extra, action) {
    const alternatives = alternativesOf(extra)
    const [what = "", index = "0"] = action.split(".")
    if (isFolded(alternatives.length, what === "more-cases") && what.endsWith("-cases")) return extra
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
    read(r) {
      const scrutinee = r.extra.lambda === true ? undefined : r.expr("X")
      const alternatives = alternativesOf(r.extra).map((a, i): Alternative => {
        return {
          kind: "alternative",
          pattern: r.pattern(`P${i}`),
          right: readRight(r, i, partOf(a)),
          from: r.from,
        }
      })
      return scrutinee === undefined
        ? {kind: "lambda-case", alternatives, from: r.from}
        : {kind: "case", scrutinee, alternatives, from: r.from}
    },
    write(e) {
      if ((e.kind !== "case" && e.kind !== "lambda-case") || e.alternatives.length === 0) return undefined
      const sockets: {[input: string]: Expr | Pattern} = e.kind === "case" ? {X: e.scrutinee} : {}
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
      const lambda = e.kind === "lambda-case" ? {lambda: true} : {}
      return {extra: {...lambda, alternatives}, sockets, stacks}
    },
  },
}

function alternativesOf(extra: Extra): readonly Extra[] {
  const alternatives = objectsIn(extra, "alternatives")
  return alternatives.length === 0 ? [{}] : alternatives
}

/// Operators that can stand for each other in the block's menu.
interface OperatorMenu {
  readonly family: Family
  readonly ops: readonly string[]
  readonly tooltip: string
}

const menus = perLanguage((): readonly OperatorMenu[] => [
  {family: "number", ops: ["+", "-", "*", "/"], tooltip: words.choices.computesWithTwoNumbers},
  {
    family: "number",
    ops: ["div", "mod", "quot", "rem"],
    tooltip: words.choices.dividesWholeNumbers,
  },
  {family: "number", ops: ["^", "**"], tooltip: words.choices.aPower},
  {
    family: "choice",
    ops: ["==", "/=", "<", "<=", ">", ">="],
    tooltip: words.choices.comparesTwoValues,
  },
  {family: "choice", ops: ["&&", "||"], tooltip: words.choices.combinesTwoConditions},
  {
    family: "own",
    ops: ["++", "<>"],
    tooltip: words.choices.putsTwoListsOrTextsTogether,
  },
  {
    family: "number",
    ops: ["addVec", "subVec"],
    tooltip: words.choices.putsTwoArrowsTogetherOrTakesOne,
  },
  {
    family: "own",
    ops: [":"],
    tooltip: words.choices.aListWithOneMoreItem,
  },
  {
    family: "own",
    ops: ["$", "."],
    tooltip: words.choices.givesAValueToAFunction,
  },
])

/// What a screen reader says for a symbol.
function spoken(op: string): string {
  const operatorWords: {readonly [op: string]: string} = words.operators
  return operatorWords[op] ?? op
}

export function operatorMenu(op: string): OperatorMenu {
  return (
    menus().find(m => m.ops.includes(op)) ?? {
      family: "own",
      ops: [op],
      tooltip: words.choices.theOperator(op),
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
          {kind: "socket", name: "L", sort: "expression", aria: words.choices.leftSide},
          {kind: "menu", key: "op", value: op, options: operatorOptions(op), aria: words.choices.operator},
          {kind: "socket", name: "R", sort: "expression", aria: words.choices.rightSide},
        ],
      ],
      tooltip: menu.tooltip,
      aria: spoken(op),
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
        {kind: "socket", name: "X", sort: "expression", aria: words.choices.number},
      ],
    ],
    tooltip: words.choices.theSameNumberOnTheOtherSide,
    aria: words.choices.minus,
  }),
  press: noButtons,
  meaning: {
    as: "expression",
    read: r => ({kind: "negate", expr: r.expr("X"), from: r.from}),
    write: e => (e.kind === "negate" ? {extra: {}, sockets: {X: e.expr}} : undefined),
  },
}

export const choiceBlocks: readonly BlockSpec[] = [ifBlock, branches, caseBlock, infix, negate]
