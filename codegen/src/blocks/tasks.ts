/// Tasks: steps one after the other, in stacks; what is repeated or done on a condition is a stack inside a step.

import type {Expr, Statement} from "../model/tree.ts"
import type {Row} from "../shape.ts"
import type {BlockSpec, Reader, Written} from "./spec.ts"
import {noButtons} from "./spec.ts"

/// A stack of steps as one expression: a single plain step needs no `do`.
function body(r: Reader, stack: string): Expr {
  const steps = r.steps(stack)
  const [only] = steps
  if (only === undefined) {
    r.problem("hole", "There is no step here yet.", "Put at least one step into the stack.", stack)
    return {kind: "hole", from: {block: r.from.block, input: stack}}
  }
  if (steps.length === 1 && only.kind === "statement" && only.comment === undefined) return only.expr
  const last = steps[steps.length - 1]
  if (last !== undefined && last.kind !== "statement") {
    r.problem(
      "last-step",
      "The last step must do something.",
      "After naming a value, add a step that uses it.",
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
function steps(e: Expr): Statement[] {
  return e.kind === "do" && e.statements.length > 0
    ? [...e.statements]
    : e.kind === "hole"
      ? []
      : [{kind: "statement", expr: e}]
}

const doBlock: BlockSpec = {
  type: "do",
  shape: () => ({
    family: "task",
    connects: {as: "expression"},
    rows: [
      [{kind: "label", text: "do these steps"}],
      [{kind: "stack", name: "S", sort: "step", aria: "steps, one after the other"}],
    ],
    tooltip: "Does its steps one after the other. Example: wait 1, then say “done”.",
    aria: "steps one after the other",
  }),
  press: noButtons,
  meaning: {
    as: "expression",
    read: r => body(r, "S"),
    write: e =>
      e.kind === "do" && e.statements.length > 0 ? {extra: {}, stacks: {S: e.statements}} : undefined,
  },
}

const bind: BlockSpec = {
  type: "step_bind",
  shape: () => ({
    family: "task",
    connects: {as: "step"},
    rows: [
      [
        {kind: "label", text: "do"},
        {kind: "socket", name: "X", sort: "expression", aria: "what to do"},
        {kind: "label", text: "and call its result"},
        {kind: "socket", name: "P", sort: "pattern", aria: "name of the result"},
      ],
    ],
    tooltip:
      "Does something and names what comes out, for the steps below. Example: do measure and call its result d.",
    aria: "do and name the result",
  }),
  press: noButtons,
  meaning: {
    as: "step",
    read: r => ({kind: "bind", pattern: r.pattern("P"), expr: r.expr("X"), from: r.from}),
    write: s => (s.kind === "bind" ? {extra: {}, sockets: {P: s.pattern, X: s.expr}} : undefined),
  },
}

const letStep: BlockSpec = {
  type: "step_let",
  shape: () => ({
    family: "own",
    connects: {as: "step"},
    rows: [
      [
        {kind: "label", text: "let"},
        {kind: "stack", name: "D", sort: "definition", aria: "definitions for the steps below"},
      ],
    ],
    tooltip: "Defines names for the steps below. Example: let speed be 0.5.",
    aria: "let, for the steps below",
  }),
  press: noButtons,
  meaning: {
    as: "step",
    read: r => ({kind: "let-statement", declarations: r.definitions("D"), from: r.from}),
    write: s =>
      s.kind === "let-statement" && s.declarations.length > 0
        ? {extra: {}, stacks: {D: s.declarations}}
        : undefined,
  },
}

/// A step that is a call of one function: sockets first, then a stack or nothing.
function call(
  type: string,
  fn: string,
  sockets: readonly {
    readonly name: string
    readonly words: string
    readonly aria: string
    readonly hint?: string
  }[],
  stack: {readonly name: string; readonly words: string; readonly aria: string} | undefined,
  tooltip: string,
): BlockSpec {
  const row: Row = sockets.flatMap(s => [
    ...(s.words === "" ? [] : [{kind: "label", text: s.words} as const]),
    {
      kind: "socket",
      name: s.name,
      sort: "expression",
      aria: s.aria,
      ...(s.hint === undefined ? {} : {hint: s.hint}),
    } as const,
  ])
  const words = stack === undefined || stack.words === "" ? [] : [{kind: "label", text: stack.words} as const]
  return {
    type,
    shape: () => ({
      family: "task",
      connects: {as: "step"},
      rows: [
        [...row, ...words],
        ...(stack === undefined
          ? []
          : [[{kind: "stack", name: stack.name, sort: "step", aria: stack.aria} as const]]),
      ],
      tooltip,
      aria: sockets[0]?.words ?? stack?.words ?? fn,
      help: `v:${fn}`,
    }),
    press: noButtons,
    meaning: {
      as: "step",
      read(r) {
        const head: Expr = {kind: "variable", name: fn, from: r.from}
        const args = sockets.map(s => r.expr(s.name))
        if (stack === undefined)
          return {kind: "statement", expr: {kind: "apply", fn: head, args, from: r.from}, from: r.from}
        const inner = body(r, stack.name)
        // `replicateM_ 4 $ do …` reads better than brackets around many lines.
        const expr: Expr =
          inner.kind === "do"
            ? {
                kind: "infix",
                op: "$",
                left: args.length === 0 ? head : {kind: "apply", fn: head, args, from: r.from},
                right: inner,
                from: r.from,
              }
            : {kind: "apply", fn: head, args: [...args, inner], from: r.from}
        return {kind: "statement", expr, from: r.from}
      },
      write(s): Written | undefined {
        if (s.kind !== "statement") return undefined
        const all = callParts(s.expr, fn)
        if (all === undefined || all.length !== sockets.length + (stack === undefined ? 0 : 1))
          return undefined
        const last = all[all.length - 1]
        return {
          extra: {},
          sockets: Object.fromEntries(
            sockets.flatMap((x, i) => (all[i] === undefined ? [] : [[x.name, all[i]]])),
          ),
          ...(stack === undefined || last === undefined ? {} : {stacks: {[stack.name]: steps(last)}}),
        }
      },
    },
  }
}

/// The arguments of a call of `fn`, also when the last one comes after `$`.
function callParts(e: Expr, fn: string): Expr[] | undefined {
  if (e.kind === "apply") return e.fn.kind === "variable" && e.fn.name === fn ? [...e.args] : undefined
  if (e.kind === "infix" && e.op === "$" && e.right.kind === "do") {
    if (e.left.kind === "variable") return e.left.name === fn ? [e.right] : undefined
    const before = callParts(e.left, fn)
    return before === undefined ? undefined : [...before, e.right]
  }
  return undefined
}

const stack = {name: "S", words: "times", aria: "steps to repeat"}

const ifStep: BlockSpec = {
  type: "step_if",
  shape: () => ({
    family: "choice",
    connects: {as: "step"},
    rows: [
      [
        {kind: "label", text: "if"},
        {kind: "socket", name: "C", sort: "expression", aria: "condition", hint: "condition"},
        {kind: "label", text: "do"},
      ],
      [{kind: "stack", name: "T", sort: "step", aria: "steps if so"}],
      [{kind: "label", text: "else"}],
      [{kind: "stack", name: "F", sort: "step", aria: "steps if not"}],
    ],
    tooltip: "Does one or the other. Example: if d > 1 do say “far” else say “near”.",
    aria: "if, do, else",
  }),
  press: noButtons,
  meaning: {
    as: "step",
    read(r) {
      const expr: Expr = {
        kind: "if",
        condition: r.expr("C"),
        yes: body(r, "T"),
        no: body(r, "F"),
        from: r.from,
      }
      return {kind: "statement", expr, from: r.from}
    },
    write: s =>
      s.kind === "statement" && s.expr.kind === "if"
        ? {extra: {}, sockets: {C: s.expr.condition}, stacks: {T: steps(s.expr.yes), F: steps(s.expr.no)}}
        : undefined,
  },
}

const run: BlockSpec = {
  type: "step_do",
  shape: () => ({
    family: "task",
    connects: {as: "step"},
    rows: [
      [
        {kind: "label", text: "do"},
        {kind: "socket", name: "X", sort: "expression", aria: "what to do", hint: "task"},
      ],
    ],
    tooltip: "Does something, then goes on below. Example: do move (Forward 50).",
    aria: "do",
  }),
  press: noButtons,
  meaning: {
    as: "step",
    read: r => ({kind: "statement", expr: r.expr("X"), from: r.from}),
    write: s => (s.kind === "statement" ? {extra: {}, sockets: {X: s.expr}} : undefined),
  },
}

export const tasks: readonly BlockSpec[] = [
  doBlock,
  bind,
  letStep,
  call(
    "step_repeat",
    "replicateM_",
    [{name: "N", words: "repeat", aria: "how many times", hint: "number"}],
    stack,
    "Does its steps a number of times. Example: repeat 4 times.",
  ),
  call(
    "step_forever",
    "forever",
    [],
    {name: "S", words: "forever", aria: "steps to repeat for ever"},
    "Does its steps again and again. Example: forever, say “tick” and wait 1.",
  ),
  call(
    "step_when",
    "when",
    [{name: "C", words: "only if", aria: "condition", hint: "condition"}],
    {name: "S", words: "do", aria: "steps if the condition holds"},
    "Does its steps if the condition holds, and otherwise nothing. Example: only if d > 1, say “far”.",
  ),
  call(
    "step_unless",
    "unless",
    [{name: "C", words: "unless", aria: "condition", hint: "condition"}],
    {name: "S", words: "do", aria: "steps if the condition does not hold"},
    "Does its steps if the condition does not hold. Example: unless d > 1, say “near”.",
  ),
  call(
    "step_say",
    "say",
    [{name: "X", words: "say", aria: "text", hint: "text"}],
    undefined,
    "The robot says something. Example: say “done”.",
  ),
  call(
    "step_wait",
    "wait",
    [{name: "X", words: "wait seconds", aria: "seconds", hint: "seconds"}],
    undefined,
    "Waits. Example: wait 2 seconds.",
  ),
  ifStep,
  run,
]
