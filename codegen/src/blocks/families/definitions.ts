/// Definitions: functions from what the robot senses to what it should do, constants, and the program's entry.

import type {Family, Item, Row} from "../../block_shape.ts"
import {isOperator, isVariableName} from "../../haskell/lexemes.ts"
import type {Clause, Declaration, Expr, Pattern, Statement} from "../../model/syntax_tree.ts"
import {commands, events, states, typeOfConstructor} from "../../robot/roles.ts"
import type {Extra} from "../../serialized_blocks.ts"
import {perLanguage, words} from "../../words/index.ts"
import type {BlockSpec, Reader} from "../spec/block_spec.ts"
import {countIn, counting, foldLabel, isFolded, objectsIn, shownParts, textIn} from "../spec/block_spec.ts"
import {partMenu, partOf, pressPart, readRight, rightRows, savedPart, writeRight} from "./right_hand_side.ts"

/// How a definition reads aloud; says nothing about its meaning.
interface ReadAloud {
  readonly family: Family
  readonly input: string
  /// Says in an empty place what the first input is.
  readonly hint?: string
  readonly answer: string
  readonly what: string
}

const readings = perLanguage((): {readonly [as: string]: ReadAloud} => ({
  event: {
    family: "event",
    input: words.definitions.when,
    hint: words.definitions.event,
    answer: words.definitions.send,
    what: words.definitions.whatToSend,
  },
  state: {
    family: "state",
    input: words.definitions.whenItHas,
    answer: words.definitions.send,
    what: words.definitions.whatToSend,
  },
  command: {
    family: "command",
    input: words.definitions.with,
    answer: words.definitions.send,
    what: words.definitions.whatToSend,
  },
  memory: {
    family: "memory",
    input: words.definitions.whenItRemembers,
    answer: words.definitions.send,
    what: words.definitions.whatToSend,
  },
  task: {
    family: "task",
    input: words.definitions.with,
    answer: words.definitions.do,
    what: words.definitions.whatToDo,
  },
  plain: {
    family: "own",
    input: words.definitions.with,
    answer: words.definitions.is,
    what: words.definitions.whatIt,
  },
}))

const define: BlockSpec = {
  type: "define",
  shape(extra) {
    const name = textIn(extra, "name", "f")
    const reading = readings()[textIn(extra, "as", "plain")] ?? readings().plain!
    const arity = countIn(extra, "arity", 0)
    const equations = equationsOf(extra)
    const rows: Row[] = [
      [
        {kind: "binder", key: "name", value: name, aria: words.definitions.nameOfTheDefinition},
        {
          kind: "signature",
          key: "signature",
          value: textIn(extra, "signature"),
          aria: words.definitions.typeOf(name),
        },
      ],
    ]
    for (const [i, equation] of equations.slice(0, shownParts).entries()) {
      const inputs: Item[] = []
      for (let j = 0; j < Math.min(arity, shownParts); j++) {
        inputs.push({kind: "label", text: j === 0 ? reading.input : words.definitions.and})
        inputs.push({
          kind: "socket",
          name: `P${i}_${j}`,
          sort: "pattern",
          aria: inputLabel(i, j, equations.length),
          ...(reading.hint === undefined || j > 0 ? {} : {hint: reading.hint}),
        })
      }
      inputs.push(...foldLabel(arity))
      if (i === 0 && !isFolded(arity, true)) {
        inputs.push({kind: "button", action: "more-inputs", text: "+", aria: words.definitions.oneMoreInput})
        if (arity > 0)
          inputs.push({
            kind: "button",
            action: "fewer-inputs",
            text: "−",
            aria: words.definitions.oneInputLess,
          })
      }
      if (inputs.length > 0) rows.push(inputs)
      const which = equations.length > 1 ? words.definitions.case(i + 1) : ""
      rows.push(...rightRows(i, partOf(equation), reading.answer, reading.what, which))
    }
    if (equations.length > shownParts) rows.push(foldLabel(equations.length))
    if (arity > 0 && !isFolded(equations.length, false)) {
      const last: Item[] = isFolded(equations.length, true)
        ? []
        : [{kind: "button", action: "more-cases", text: "+", aria: words.definitions.oneMoreCase}]
      if (equations.length > 1)
        last.push({
          kind: "button",
          action: "fewer-cases",
          text: "−",
          aria: words.definitions.removeTheLastCase,
        })
      rows.push(last)
    }
    return {
      family: reading.family,
      connects: {as: "definition"},
      rows,
      tooltip: words.definitions.givesANameToWhatTheRobot,
      aria: words.definitions.definitionOf(name),
      menu: equations
        .slice(0, shownParts)
        .flatMap((e, i) => partMenu(i, partOf(e), equations.length > 1 ? words.definitions.case(i + 1) : "")),
    }
  },
  press(extra, action) {
    const arity = countIn(extra, "arity", 0)
    const equations = equationsOf(extra)
    const [what = "", index = "0"] = action.split(".")
    switch (what) {
      case "more-inputs":
        return {...extra, arity: Math.max(arity, Math.min(9, arity + 1))}
      case "fewer-inputs":
        return isFolded(arity, false) ? extra : {...extra, arity: Math.max(0, arity - 1)}
      case "more-cases":
        return isFolded(equations.length, true) ? extra : {...extra, equations: [...equations, {}]}
      case "fewer-cases":
        return isFolded(equations.length, false)
          ? extra
          : {...extra, equations: equations.slice(0, Math.max(1, equations.length - 1))}
      default:
        return {
          ...extra,
          equations: equations.map((e, i) =>
            i === Number(index) ? savedPart(pressPart(partOf(e), what)) : e,
          ),
        }
    }
  },
  meaning: {
    as: "definition",
    read(r) {
      const name = checkedName(r, "name", "f")
      const arity = countIn(r.extra, "arity", 0)
      const clauses = equationsOf(r.extra).map((equation, i): Clause => {
        const patterns: Pattern[] = []
        for (let j = 0; j < arity; j++) patterns.push(r.pattern(`P${i}_${j}`))
        return {kind: "clause", patterns, right: readRight(r, i, partOf(equation)), from: r.from}
      })
      const signature = textIn(r.extra, "signature")
      return {
        kind: "function",
        name,
        clauses,
        from: r.from,
        ...(signature.trim() === "" ? {} : {signature: {kind: "type", text: signature, from: r.from}}),
      }
    },
    write(d) {
      if (d.kind !== "function") return undefined
      if (d.clauses.length === 0)
        return d.signature === undefined
          ? undefined
          : {extra: {name: d.name, as: "plain", arity: 0, typeOnly: true, signature: d.signature.text}}
      const arity = d.clauses[0]?.patterns.length ?? 0
      if (d.clauses.some(c => c.patterns.length !== arity || c.comment !== undefined)) return undefined
      const sockets: {[input: string]: Expr | Pattern} = {}
      const stacks: {[input: string]: readonly (Declaration | Statement)[]} = {}
      const equations: Extra[] = []
      for (const [i, c] of d.clauses.entries()) {
        c.patterns.forEach((p, j) => {
          sockets[`P${i}_${j}`] = p
        })
        const right = writeRight(i, c.right)
        if (right === undefined) return undefined
        equations.push(savedPart(right.part))
        Object.assign(sockets, right.sockets)
        Object.assign(stacks, right.stacks)
      }
      const extra: Extra = {
        name: d.name,
        as: readingOf(d),
        arity,
        equations,
        ...(d.signature === undefined ? {} : {signature: d.signature.text}),
      }
      return {extra, sockets, stacks}
    },
  },
}

function inputLabel(i: number, j: number, equations: number): string {
  return equations > 1 ? words.definitions.inputOfCase(j + 1, i + 1) : words.definitions.input(j + 1)
}

/// A method of a class with a type and no equations has none to show.
function equationsOf(extra: Extra): readonly Extra[] {
  if (extra.typeOnly === true) return []
  const equations = objectsIn(extra, "equations")
  return equations.length === 0 ? [{}] : equations
}

/// The words that suit a definition read from text: by its first input or its answer.
function readingOf(d: Declaration & {kind: "function"}): string {
  const text = d.signature?.text ?? ""
  const [input] = d.clauses.flatMap(c => c.patterns.slice(0, 1))
  const body = d.clauses[0]?.right.body
  if (input === undefined) {
    if (/\bTask\b/.test(text)) return "task"
    const head = body === undefined || Array.isArray(body) ? undefined : headOf(body as Expr)
    return head !== undefined && commands.has(typeOfConstructor(head) ?? "") ? "command" : "plain"
  }
  const first = /^\s*(?:\(\s*)?([A-Z]\w*)/.exec(text.replace(/^.*=>/, ""))?.[1] ?? ""
  const word = input.kind === "constructor-pattern" ? input.name : first
  const type = typeOfConstructor(word) ?? word
  if (events.has(type)) return "event"
  if (states.has(type) || type === "Seconds" || type === "Clock") return "state"
  return word === "Memory" || word === "Param" ? "memory" : /Task\b/.test(text) ? "task" : "plain"
}

function headOf(e: Expr): string | undefined {
  return e.kind === "apply" ? headOf(e.fn) : e.kind === "constructor-name" ? e.name : undefined
}

/// A binder's name; one that Haskell would not accept is a problem, and the printer finds the nearest that it does.
export function checkedName(r: Reader, key: string, otherwise: string): string {
  const name = textIn(r.extra, key, otherwise)
  if (!isVariableName(name) && !isOperator(name))
    r.problem(
      "name",
      name.trim() === "" ? words.definitions.thisHasNoNameYet : words.definitions.cannotBeAName(name),
      words.definitions.aNameIsOneWordThatStarts,
    )
  return name
}

const main: BlockSpec = {
  type: "main",
  shape(extra) {
    const controllers = countIn(extra, "controllers", 1, 1)
    const items: Item[] = [{kind: "label", text: words.definitions.simulate, strong: true}]
    for (let i = 0; i < Math.min(controllers, shownParts); i++) {
      if (i > 0) items.push({kind: "label", text: words.definitions.and})
      items.push({
        kind: "socket",
        name: `R${i}`,
        sort: "expression",
        aria: controllers > 1 ? words.definitions.whatToRun(i + 1) : words.definitions.whatToRun2,
        hint: words.definitions.function,
      })
    }
    items.push(...foldLabel(controllers))
    if (!isFolded(controllers, true))
      items.push({kind: "button", action: "more", text: "+", aria: words.definitions.runOneMore})
    if (controllers > 1 && !isFolded(controllers, false))
      items.push({kind: "button", action: "fewer", text: "−", aria: words.definitions.runOneLess})
    return {
      family: "task",
      connects: {as: "top"},
      rows: [items],
      tooltip: words.definitions.whatTheProgramRunsFunctionsThatReact,
      aria: words.definitions.theProgramSimulate,
      help: "v:simulate",
    }
  },
  press: counting("controllers", 1, 1),
  meaning: {
    as: "definition",
    read(r) {
      const count = countIn(r.extra, "controllers", 1, 1)
      const items: Expr[] = []
      for (let i = 0; i < count; i++) items.push(r.expr(`R${i}`))
      const [only] = items
      const what: Expr =
        items.length === 1 && only !== undefined ? only : {kind: "tuple", items, from: r.from}
      const fn: Expr = {kind: "variable", name: "simulate", from: r.from}
      // `simulate $ do …` reads better than brackets around many lines.
      const body: Expr =
        what.kind === "do"
          ? {kind: "infix", op: "$", left: fn, right: what, from: r.from}
          : {kind: "apply", fn, args: [what], from: r.from}
      return {
        kind: "function",
        name: "main",
        signature: {kind: "type", text: "IO ()", from: r.from},
        clauses: [{kind: "clause", patterns: [], right: {kind: "right", body, where: []}, from: r.from}],
        from: r.from,
      }
    },
    write(d) {
      if (
        d.kind !== "function" ||
        d.name !== "main" ||
        (d.signature !== undefined && d.signature.text.trim() !== "IO ()")
      )
        return undefined
      const [clause, ...others] = d.clauses
      if (
        clause === undefined ||
        others.length > 0 ||
        clause.patterns.length > 0 ||
        clause.right.where.length > 0
      )
        return undefined
      const body = clause.right.body
      if (Array.isArray(body)) return undefined
      const argument = simulated(body as Expr)
      if (argument === undefined) return undefined
      const items = argument.kind === "tuple" && argument.items.length > 1 ? argument.items : [argument]
      return {
        extra: {controllers: items.length},
        sockets: Object.fromEntries(items.map((item, i) => [`R${i}`, item])),
      }
    },
  },
}

/// What `simulate` is given, also after `$`.
function simulated(body: Expr): Expr | undefined {
  const isSimulate = (fn: Expr) => fn.kind === "variable" && fn.name === "simulate"
  if (body.kind === "infix" && body.op === "$" && body.right.kind === "do")
    return isSimulate(body.left) ? body.right : undefined
  return body.kind === "apply" && body.args.length === 1 && isSimulate(body.fn) ? body.args[0] : undefined
}

const definePattern: BlockSpec = {
  type: "define_pattern",
  shape() {
    return {
      family: "own",
      connects: {as: "definition"},
      rows: [
        [
          {kind: "label", text: words.definitions.let},
          {kind: "socket", name: "P", sort: "pattern", aria: words.definitions.names},
          {kind: "label", text: words.definitions.be},
          {kind: "socket", name: "E0_0", sort: "expression", aria: words.definitions.whatIsTakenApart},
        ],
      ],
      tooltip: words.definitions.takesAValueApartAndNames,
      aria: words.definitions.definitionOfSeveralNames,
    }
  },
  press: extra => extra,
  meaning: {
    as: "definition",
    read: r => ({
      kind: "binding",
      pattern: r.pattern("P"),
      right: {kind: "right", body: r.expr("E0_0"), where: []},
      from: r.from,
    }),
    write: d =>
      d.kind === "binding" && !Array.isArray(d.right.body) && d.right.where.length === 0
        ? {extra: {}, sockets: {P: d.pattern, E0_0: d.right.body as Expr}}
        : undefined,
  },
}

/// A class, or how a type belongs to one. What stands before `where` is text; the definitions are blocks.
const instance: BlockSpec = {
  type: "instance",
  shape: extra => ({
    family: "own",
    connects: {as: "top"},
    rows: [
      [
        {
          kind: "text",
          key: "head",
          value: textIn(extra, "head", words.definitions.exampleInstance),
          aria: words.definitions.classAndType,
        },
        {kind: "label", text: words.answers.where},
      ],
      [{kind: "stack", name: "D", sort: "definition", aria: words.definitions.whatTheTypeCanDo}],
    ],
    tooltip: words.definitions.saysHowATypeBelongsToAClass,
    aria: words.definitions.classAndType,
  }),
  press: extra => extra,
  meaning: {
    as: "definition",
    read: r => ({
      kind: "instance",
      head: textIn(r.extra, "head", words.definitions.exampleInstance).trim(),
      declarations: r.definitions("D"),
      from: r.from,
    }),
    write: d =>
      d.kind === "instance" ? {extra: {head: d.head}, sockets: {}, stacks: {D: d.declarations}} : undefined,
  },
}

export const definitions: readonly BlockSpec[] = [main, define, definePattern, instance]
