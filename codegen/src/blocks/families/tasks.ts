/// Tasks: steps one after the other, in stacks; what is repeated or done on a condition is a stack inside a step.

import type {Row} from "../../block_shape.ts"
import type {Expr, Statement} from "../../model/syntax_tree.ts"
import {perLanguage, words} from "../../words/index.ts"
import type {BlockSpec, Reader, WrittenBlock} from "../spec/block_spec.ts"
import {noButtons, stringsIn, textIn} from "../spec/block_spec.ts"

/// A stack of steps as one expression: a single plain step needs no `do`. One that has it in the text keeps it: its stack is named in `doStacks`.
function body(r: Reader, stack: string): Expr {
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
function steps(e: Expr): Statement[] {
  return e.kind === "do" && e.statements.length > 0
    ? [...e.statements]
    : e.kind === "hole"
      ? []
      : [{kind: "statement", expr: e}]
}

/// The stacks whose one plain step has a `do` of its own in the text.
function doStacks(stacks: Readonly<Record<string, Expr>>): {readonly doStacks?: readonly string[]} {
  const found = Object.entries(stacks).flatMap(([name, e]) => {
    const [only, ...more] = e.kind === "do" ? e.statements : []
    return only?.kind === "statement" && more.length === 0 && only.comment === undefined ? [name] : []
  })
  return found.length === 0 ? {} : {doStacks: found}
}

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

interface CallParts {
  readonly sockets: readonly {
    readonly name: string
    readonly words: string
    /// The label behind the socket: a unit or the end of the phrase.
    readonly unit?: string
    readonly aria: string
    readonly hint?: string
  }[]
  /// The label of a call without sockets.
  readonly words?: string
  readonly stack?: {readonly name: string; readonly words: string; readonly aria: string}
  readonly tooltip: string
  /// The library's source has its definition, for a learner who wants to look inside.
  readonly hasDefinition?: boolean
}

/// A step that is a call of one function of the library: sockets first, then a stack or nothing. `name` in its `extraState` is
/// the new name of the program's own function that took the place of the library's, after it was renamed.
function call(type: string, fn: string, parts: () => CallParts): BlockSpec {
  const currentParts = perLanguage(parts)
  const row = ({sockets, stack, words: alone, hasDefinition}: CallParts): Row => [
    ...(alone === undefined ? [] : [{kind: "label", text: alone} as const]),
    ...sockets.flatMap(
      (s): Row => [
        ...(s.words === "" ? [] : [{kind: "label", text: s.words} as const]),
        {
          kind: "socket",
          name: s.name,
          sort: "expression",
          aria: s.aria,
          ...(s.hint === undefined ? {} : {hint: s.hint}),
        } as const,
        ...(s.unit === undefined ? [] : [{kind: "label", text: s.unit} as const]),
      ],
    ),
    ...(stack === undefined || stack.words === "" ? [] : [{kind: "label", text: stack.words} as const]),
    ...(hasDefinition === true
      ? [{kind: "button", action: "look-inside", text: "⌕", aria: words.tasks.lookInside(fn)} as const]
      : []),
  ]
  return {
    type,
    calls: fn,
    shape() {
      const {sockets, stack, tooltip, words: alone} = currentParts()
      return {
        family: "task",
        connects: {as: "step"},
        rows: [
          row(currentParts()),
          ...(stack === undefined
            ? []
            : [[{kind: "stack", name: stack.name, sort: "step", aria: stack.aria} as const]]),
        ],
        tooltip,
        aria: alone ?? sockets[0]?.words ?? stack?.words ?? fn,
        help: `v:${fn}`,
      }
    },
    press: noButtons,
    meaning: {
      as: "step",
      read(r) {
        const {sockets, stack} = currentParts()
        const head: Expr = {kind: "variable", name: textIn(r.extra, "name", fn), from: r.from}
        const args = sockets.map(s => r.expr(s.name))
        if (stack === undefined) {
          const expr: Expr = args.length === 0 ? head : {kind: "apply", fn: head, args, from: r.from}
          return {kind: "statement", expr, from: r.from}
        }
        const inner = body(r, stack.name)
        // `replicateM_ 4 $ do …` reads better than brackets around many lines.
        const expr: Expr =
          inner.kind === "do" && r.extra.applied !== true
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
      write(s): WrittenBlock | undefined {
        const {sockets, stack} = currentParts()
        if (s.kind !== "statement") return undefined
        const all = callParts(s.expr, fn)
        if (all === undefined || all.length !== sockets.length + (stack === undefined ? 0 : 1))
          return undefined
        const last = all[all.length - 1]
        // Text that gives the steps without `$` (BlockArguments, or in brackets) stays so.
        const isApplied = stack !== undefined && s.expr.kind === "apply" && last?.kind === "do"
        return {
          extra: {
            ...(isApplied ? {applied: true} : {}),
            ...(stack === undefined || last === undefined ? {} : doStacks({[stack.name]: last})),
          },
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
  if (e.kind === "variable") return e.name === fn ? [] : undefined
  if (e.kind === "apply") return e.fn.kind === "variable" && e.fn.name === fn ? [...e.args] : undefined
  if (e.kind === "infix" && e.op === "$" && e.right.kind === "do") {
    const before = callParts(e.left, fn)
    return before === undefined ? undefined : [...before, e.right]
  }
  return undefined
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

export const tasks: readonly BlockSpec[] = [
  doBlock,
  bind,
  letStep,
  call("step_repeat", "replicateM_", () => ({
    sockets: [
      {name: "N", words: words.tasks.repeat, aria: words.tasks.howManyTimes, hint: words.tasks.number},
    ],
    stack: {name: "S", words: words.tasks.times, aria: words.tasks.stepsToRepeat},
    tooltip: words.tasks.doesItsStepsANumberOfTimes,
  })),
  call("step_forever", "forever", () => ({
    sockets: [],
    stack: {name: "S", words: words.tasks.forever, aria: words.tasks.stepsToRepeatForEver},
    tooltip: words.tasks.doesItsStepsAgainAndAgain,
  })),
  call("step_when", "when", () => ({
    sockets: [
      {name: "C", words: words.tasks.onlyIf, aria: words.tasks.condition, hint: words.tasks.condition},
    ],
    stack: {name: "S", words: words.tasks.do, aria: words.tasks.stepsIfTheConditionHolds},
    tooltip: words.tasks.doesItsStepsIfTheConditionHolds,
  })),
  call("step_unless", "unless", () => ({
    sockets: [
      {name: "C", words: words.tasks.unless, aria: words.tasks.condition, hint: words.tasks.condition},
    ],
    stack: {name: "S", words: words.tasks.do, aria: words.tasks.stepsIfTheConditionDoesNotHold},
    tooltip: words.tasks.doesItsStepsIfTheConditionDoes,
  })),
  call("step_say", "say", () => ({
    sockets: [{name: "X", words: words.tasks.say, aria: words.tasks.text, hint: words.tasks.text}],
    tooltip: words.tasks.theRobotSaysSomething,
  })),
  call("step_wait", "wait", () => ({
    sockets: [
      {
        name: "X",
        words: words.tasks.wait,
        // A symbol agrees with 1 as well as with 2.
        unit: "s",
        aria: words.tasks.seconds,
        hint: words.tasks.number,
      },
    ],
    tooltip: words.tasks.waits,
  })),
  call("step_drive", "drive", () => ({
    sockets: [
      {
        name: "X",
        words: words.tasks.drive,
        unit: "cm",
        aria: words.tasks.centimetres,
        hint: words.tasks.number,
      },
    ],
    tooltip: words.tasks.drives,
    hasDefinition: true,
  })),
  call("step_turn", "turn", () => ({
    sockets: [
      {
        name: "X",
        words: words.tasks.turn,
        unit: words.tasks.degreesUnit,
        aria: words.tasks.degrees,
        hint: words.tasks.number,
      },
    ],
    tooltip: words.tasks.turns,
    hasDefinition: true,
  })),
  call("step_drive_until_bump", "driveUntilBump", () => ({
    words: words.tasks.driveUntilABump,
    sockets: [],
    tooltip: words.tasks.drivesUntilABump,
    hasDefinition: true,
  })),
  call("step_drive_until", "driveUntil", () => ({
    sockets: [
      {
        name: "X",
        words: words.tasks.driveUntil,
        aria: words.tasks.functionThatGivesDone,
        hint: words.tasks.functionThatGivesDone,
      },
    ],
    tooltip: words.tasks.drivesUntil,
    hasDefinition: true,
  })),
  call("step_drive_back", "driveBack", () => ({
    sockets: [
      {
        name: "X",
        words: words.tasks.driveBack,
        unit: "s",
        aria: words.tasks.seconds,
        hint: words.tasks.number,
      },
    ],
    tooltip: words.tasks.drivesBack,
    hasDefinition: true,
  })),
  call("step_turn_between", "turnBetween", () => ({
    sockets: [
      {name: "X", words: words.tasks.turnBetween, aria: words.tasks.leastDegrees, hint: words.tasks.number},
      {
        name: "Y",
        words: words.tasks.upTo,
        unit: words.tasks.degreesUnit,
        aria: words.tasks.mostDegrees,
        hint: words.tasks.number,
      },
    ],
    tooltip: words.tasks.turnsBetween,
    hasDefinition: true,
  })),
  call("step_go_to", "goTo", () => ({
    sockets: [
      {
        name: "X",
        words: words.tasks.goTo,
        unit: words.tasks.metresAhead,
        aria: words.tasks.metresAhead,
        hint: words.tasks.number,
      },
      {
        name: "Y",
        words: "",
        unit: words.tasks.metresLeft,
        aria: words.tasks.metresLeft,
        hint: words.tasks.number,
      },
    ],
    tooltip: words.tasks.goesTo,
    hasDefinition: true,
  })),
  call("step_curve_until_obstacle", "curveUntilObstacle", () => ({
    sockets: [
      {
        name: "X",
        words: words.tasks.curve,
        unit: words.tasks.untilAnObstacle,
        aria: words.tasks.degreesASecond,
        hint: words.tasks.number,
      },
    ],
    tooltip: words.tasks.curves,
    hasDefinition: true,
  })),
  call("step_dock", "dock", () => ({
    sockets: [],
    words: words.tasks.dock,
    tooltip: words.tasks.docks,
  })),
  call("step_undock", "undock", () => ({
    sockets: [],
    words: words.tasks.undock,
    tooltip: words.tasks.undocks,
  })),
  call("step_navigate_to", "navigateTo", () => ({
    sockets: [
      {
        name: "X",
        words: words.tasks.navigateTo,
        unit: words.tasks.metresAhead,
        aria: words.tasks.metresAhead,
        hint: words.tasks.number,
      },
      {
        name: "Y",
        words: "",
        unit: words.tasks.metresLeft,
        aria: words.tasks.metresLeft,
        hint: words.tasks.number,
      },
      {
        name: "Z",
        words: words.tasks.facing,
        unit: words.tasks.degreesUnit,
        aria: words.tasks.facing,
        hint: words.tasks.number,
      },
    ],
    tooltip: words.tasks.navigates,
  })),
  call("step_either_or", "eitherOr", () => ({
    sockets: [
      {name: "X", words: words.tasks.either, aria: words.tasks.oneStep, hint: words.tasks.task},
      {name: "Y", words: words.tasks.or, aria: words.tasks.otherStep, hint: words.tasks.task},
    ],
    tooltip: words.tasks.eitherByChance,
    hasDefinition: true,
  })),
  call("step_blink", "blink", () => ({
    sockets: [{name: "X", words: words.tasks.blink, aria: words.tasks.colour, hint: words.tasks.colour}],
    tooltip: words.tasks.blinks,
    hasDefinition: true,
  })),
  call("step_beep", "beep", () => ({
    words: words.tasks.beep,
    sockets: [],
    tooltip: words.tasks.beeps,
    hasDefinition: true,
  })),
  call("step_pen_down", "penDown", () => ({
    words: words.tasks.penDown,
    sockets: [],
    tooltip: words.tasks.pensDown,
    hasDefinition: true,
  })),
  call("step_pen_up", "penUp", () => ({
    words: words.tasks.penUp,
    sockets: [],
    tooltip: words.tasks.pensUp,
    hasDefinition: true,
  })),
  call("step_pen_color", "penColor", () => ({
    sockets: [{name: "X", words: words.tasks.penColor, aria: words.tasks.colour, hint: words.tasks.colour}],
    tooltip: words.tasks.pensColor,
    hasDefinition: true,
  })),
  call("step_pen_width", "penWidth", () => ({
    sockets: [
      {
        name: "X",
        words: words.tasks.penWidth,
        unit: "cm",
        aria: words.tasks.centimetres,
        hint: words.tasks.number,
      },
    ],
    tooltip: words.tasks.pensWidth,
    hasDefinition: true,
  })),
  ifStep,
  run,
]
