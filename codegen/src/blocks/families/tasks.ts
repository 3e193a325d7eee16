/// Tasks: steps one after the other, in stacks; what is done on a condition is a stack inside a step.

import type {Expr} from "../../model/syntax_tree.ts"
import {words} from "../../words/index.ts"
import {type BlockSpec, noButtons} from "../spec/block_spec.ts"
import {librarySteps} from "./library_steps.ts"
import {body, doStacks, steps} from "./step_stacks.ts"

const doBlock: BlockSpec = {
  type: "do",
  shape: () => ({
    family: "task",
    connects: {as: "expression"},
    rows: [
      [{kind: "label", text: words.tasks.doTheseSteps}],
      [{kind: "stack", name: "S", sort: "step", aria: words.tasks.stepsOneAfterTheOther}],
    ],
    tooltip: words.tasks.doesItsStepsOneAfterTheOther,
    aria: words.tasks.stepsOneAfterTheOther2,
  }),
  press: noButtons,
  meaning: {
    as: "expression",
    read: r => body(r, "S"),
    write: e =>
      e.kind === "do" && e.statements.length > 0
        ? {extra: doStacks({S: e}), stacks: {S: e.statements}}
        : undefined,
  },
}

const bind: BlockSpec = {
  type: "step_bind",
  shape: () => ({
    family: "task",
    connects: {as: "step"},
    rows: [
      [
        {kind: "label", text: words.tasks.do},
        {kind: "socket", name: "X", sort: "expression", aria: words.tasks.whatToDo},
        {kind: "label", text: words.tasks.andCallItsResult},
        {kind: "socket", name: "P", sort: "pattern", aria: words.tasks.nameOfTheResult},
      ],
    ],
    tooltip: words.tasks.doesSomethingAndNamesWhatComesOut,
    aria: words.tasks.doAndNameTheResult,
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
        {kind: "label", text: words.tasks.let},
        {kind: "stack", name: "D", sort: "definition", aria: words.tasks.definitionsForTheStepsBelow},
      ],
    ],
    tooltip: words.tasks.definesNamesForTheStepsBelow,
    aria: words.tasks.letForTheStepsBelow,
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

const ifStep: BlockSpec = {
  type: "step_if",
  shape: () => ({
    family: "choice",
    connects: {as: "step"},
    rows: [
      [
        {kind: "label", text: words.tasks.if},
        {
          kind: "socket",
          name: "C",
          sort: "expression",
          aria: words.tasks.condition,
          hint: words.tasks.condition,
        },
        {kind: "label", text: words.tasks.do},
      ],
      [{kind: "stack", name: "T", sort: "step", aria: words.tasks.stepsIfSo}],
      [{kind: "label", text: words.tasks.else}],
      [{kind: "stack", name: "F", sort: "step", aria: words.tasks.stepsIfNot}],
    ],
    tooltip: words.tasks.doesOneOrTheOther,
    aria: words.tasks.ifDoElse,
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
        ? {
            extra: doStacks({T: s.expr.yes, F: s.expr.no}),
            sockets: {C: s.expr.condition},
            stacks: {T: steps(s.expr.yes), F: steps(s.expr.no)},
          }
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
        {kind: "label", text: words.tasks.do},
        {kind: "socket", name: "X", sort: "expression", aria: words.tasks.whatToDo, hint: words.tasks.task},
      ],
    ],
    tooltip: words.tasks.doesSomethingThenGoesOnBelow,
    aria: words.tasks.do,
  }),
  press: noButtons,
  meaning: {
    as: "step",
    read: r => ({kind: "statement", expr: r.expr("X"), from: r.from}),
    write: s => (s.kind === "statement" ? {extra: {}, sockets: {X: s.expr}} : undefined),
  },
}

export const tasks: readonly BlockSpec[] = [doBlock, bind, letStep, ...librarySteps, ifStep, run]
