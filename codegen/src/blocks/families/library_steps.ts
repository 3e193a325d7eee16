/// Steps that are calls of functions of the library: motion, actions of the robot, lights, sounds, the pen, and what repeats steps.

import type {Row} from "../../block_shape.ts"
import type {Expr} from "../../model/syntax_tree.ts"
import {perLanguage, words} from "../../words/index.ts"
import {type BlockSpec, noButtons, textIn, type WrittenBlock} from "../spec/block_spec.ts"
import {body, doStacks, steps} from "./step_stacks.ts"

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

export const librarySteps: readonly BlockSpec[] = [
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
]
