/// Stacks of steps inside a block, as expressions and back.

import type {Expr, Statement} from "../../model/syntax_tree.ts"
import {words} from "../../words/index.ts"
import {type Reader, stringsIn} from "../spec/block_spec.ts"

/// A stack of steps as one expression: a single plain step needs no `do`. One that has it in the text keeps it: its stack is named in `doStacks`.
export function body(r: Reader, stack: string): Expr {
  const steps = r.steps(stack)
  const [only] = steps
  if (only === undefined) {
    r.problem("hole", words.tasks.thereIsNoStepHereYet, words.tasks.putAtLeastOneStepInto, stack)
    return {kind: "hole", steps: true, from: {block: r.from.block, input: stack}}
  }
  const isPlain = steps.length === 1 && only.kind === "statement" && only.comment === undefined
  if (isPlain && !stringsIn(r.extra, "doStacks").includes(stack)) return only.expr
  const last = steps[steps.length - 1]
  if (last !== undefined && last.kind !== "statement") {
    r.problem(
      "last-step",
      words.tasks.theLastStepMustDoSomething,
      words.tasks.afterNamingAValueAddAStep,
      stack,
    )
    return {
      kind: "do",
      statements: [
        ...steps,
        {kind: "statement", expr: {kind: "hole", from: {block: r.from.block, input: stack}}},
      ],
      from: r.from,
    }
  }
  return {kind: "do", statements: steps, from: r.from}
}

/// The steps that `body` makes an expression of.
export function steps(e: Expr): Statement[] {
  return e.kind === "do" && e.statements.length > 0
    ? [...e.statements]
    : e.kind === "hole"
      ? []
      : [{kind: "statement", expr: e}]
}

/// The stacks whose one plain step has a `do` of its own in the text.
export function doStacks(stacks: Readonly<Record<string, Expr>>): {readonly doStacks?: readonly string[]} {
  const found = Object.entries(stacks).flatMap(([name, e]) => {
    const [only, ...more] = e.kind === "do" ? e.statements : []
    return only?.kind === "statement" && more.length === 0 && only.comment === undefined ? [name] : []
  })
  return found.length === 0 ? {} : {doStacks: found}
}
