/// Static detection of functions in `simulate` that set the same actuator and override each other.
///
/// Input: an inferred workspace. Output: pairs of functions and the command that both send. The firing rules are those of `rosy-hs/LANGUAGE.md`: states fire
/// at odometry rate (rule R2), samples and constants at every tick (rule R3), and of several commands in one instant the last one wins (rule R9).
/// A function that may send nothing, or that reads a memory that the other one's events write, is never reported.

import type {BlockProblem, ConflictNames, OverriddenReaction} from "../../api.ts"
import type {Clause, Expr, FunctionDeclaration, Pattern, Program} from "../../model/syntax_tree.ts"
import {heldCommands, records, states, viewedEvent} from "../../robot/roles.ts"
import type {BlockId} from "../../serialized_blocks.ts"
import {allTypes} from "../../types/inference.ts"
import type {InferenceState} from "../../types/inference_state.ts"
import type {Scope} from "../../types/syntax/scope.ts"
import {asFunction, spine, type Type} from "../../types/syntax/type.ts"
import {words} from "../../words/index.ts"
import {priorityForASecond, priorityForGood} from "../toolbox/toolbox_language_items.ts"
import {commandsInText, onlyStandsStill} from "./commands_in_text.ts"

/// What inference knows about a program.
export interface InferredProgram {
  readonly read: {readonly program: Program}
  readonly inference: InferenceState
  readonly globals: Scope
}

export interface CommandConflict {
  readonly command: string
  /// The function whose command stays in force, and the one whose command it replaces.
  readonly winner: Sender
  readonly loser: Sender
}

export interface Sender {
  readonly name: string
  /// The block of the definition, or of the value in `simulate`.
  readonly block: BlockId | undefined
  /// Of a function of the program.
  readonly type?: Type | undefined
  /// Whether it fires on events only.
  readonly reacts: boolean
}

const samples = new Set(["Seconds", "Clock", "StdGen", "Memory", "Param", "Maybe"])

/// How often a function fires without an event: with each odometry message (50 Hz), at each tick (10 Hz), or never.
type Rate = 50 | 10 | 0

/// A function or a constant that `simulate` runs.
interface Leaf {
  readonly sender: Sender
  /// By each `priority` around it, on which side it stands.
  readonly sides: Sides
  readonly rate: Rate
  /// Types whose values make it fire.
  readonly events: ReadonlySet<string>
  /// Types of memory that it reads and writes, and the program's own events that it sends.
  readonly reads: ReadonlySet<string>
  readonly writes: ReadonlySet<string>
  readonly sends: ReadonlySet<string>
  readonly commands: ReadonlyMap<string, "always" | "sometimes">
}

/// Every pair of functions that conflict, in the order in which the program lists them.
export function commandConflicts(inferred: InferredProgram): CommandConflict[] {
  const leaves = leavesOf(inferred)
  return leaves.flatMap((one, i) => leaves.slice(i + 1).flatMap(other => conflictsOf(one, other, leaves)))
}

/// What a definition is to go before, or what is to go before it: a reaction before what drives on, a task before what drives at every tick.
///
/// What stands still and what a task commands is not commanded again and again, so that it goes before the other for good: a second later the robot would
/// drive over the edge at which it has stopped.
export function overriddenReaction(
  inferred: InferredProgram,
  definition: BlockId,
): OverriddenReaction | undefined {
  const functions = functionsOf(inferred.read.program)
  const found = [
    ...commandConflicts(inferred).flatMap(({winner, loser}): Precedence[] =>
      loser.reacts && !winner.reacts ? [{first: loser, second: winner, isTask: false}] : [],
    ),
    ...overriddenBesideTasks(leavesOf(inferred), functions),
  ].find(({first, second}) => [first.block, second.block].includes(definition))
  if (found === undefined) return undefined
  const {first, second, isTask} = found
  const own = functions.get(first.name)
  const isForGood = isTask || (own !== undefined && onlyStandsStill(own))
  const priority = isForGood ? priorityForGood() : priorityForASecond()
  return {reaction: first.name, driver: second.name, priority}
}

/// What is to go first, and what it goes before.
interface Precedence {
  readonly first: Sender
  readonly second: Sender
  readonly isTask: boolean
}

/// Pairs of a task of the program and what commands the same actuator: a reaction, whose command the task's next one would replace, or what drives at
/// every tick, which would replace the task's.
function overriddenBesideTasks(
  leaves: readonly Leaf[],
  functions: ReadonlyMap<string, FunctionDeclaration>,
): Precedence[] {
  const tasks = leaves.flatMap(leaf => {
    const own = leaf.sends.has("Task") ? functions.get(leaf.sender.name) : undefined
    return own === undefined ? [] : [{leaf, commands: commandsInText(own, functions)}]
  })
  return tasks.flatMap(task =>
    leaves.flatMap((other): Precedence[] => {
      if (![...other.commands.keys()].some(command => task.commands.has(command))) return []
      if (isArbitrated(task.leaf, other)) return []
      const {sender} = task.leaf
      if (other.sender.reacts) return [{first: other.sender, second: sender, isTask: false}]
      return other.rate > 0 ? [{first: sender, second: other.sender, isTask: true}] : []
    }),
  )
}

/// Conflicts as warnings, on both blocks.
export function conflictProblems(inferred: InferredProgram): BlockProblem[] {
  return commandConflicts(inferred).flatMap(problemsOfConflict)
}

/// What a command sets, in the learner's words.
function actuatorOf(command: string): string {
  const actuators: {readonly [command: string]: string} = words.actuators
  return actuators[command] ?? command
}

/// One conflict as a warning for each of the two blocks.
export function problemsOfConflict({command, winner, loser}: CommandConflict): BlockProblem[] {
  const conflict = {command, winner: winner.name, loser: loser.name}
  return [winner, loser].map(({block}) => ({
    severity: "warning",
    kind: "conflict",
    block,
    message: words.conflicts.bothSet(loser.name, winner.name, actuatorOf(command)),
    hint: words.conflicts.waysOut,
    conflict,
  }))
}

/// A conflict that a run has shown, with the blocks of its functions. `undefined` when `simulate` does not run both, or when the
/// winner knows of the loser: then it overrides the other on purpose.
export function conflictBetween(
  inferred: InferredProgram,
  {command, winner, loser}: ConflictNames,
): CommandConflict | undefined {
  const leaves = leavesOf(inferred)
  const [one, other] = [winner, loser].map(name => leaves.find(leaf => leaf.sender.name === name))
  if (one === undefined || other === undefined || !heldCommands.has(command)) return undefined
  if (isArbitrated(one, other)) return undefined
  if (knowsOf(one, other, leaves) || knowsOf(other, one, leaves)) return undefined
  return {command, winner: one.sender, loser: other.sender}
}

/// `one` stands before `other` in `simulate`.
function conflictsOf(one: Leaf, other: Leaf, all: readonly Leaf[]): CommandConflict[] {
  if (isArbitrated(one, other)) return []
  return [...one.commands.keys()].flatMap((command): CommandConflict[] => {
    const winner = winnerOf(command, one, other)
    if (winner === undefined) return []
    const loser = winner === one ? other : one
    return knowsOf(winner, loser, all) ? [] : [{command, winner: winner.sender, loser: loser.sender}]
  })
}

/// Whether one goes before the other: they stand on different sides of a `priority` (rule R25).
function isArbitrated(one: Leaf, other: Leaf): boolean {
  return [...one.sides].some(([node, side]) => (other.sides.get(node) ?? side) !== side)
}

/// The function that overrides the other at every firing, if one does.
function winnerOf(command: string, one: Leaf, other: Leaf): Leaf | undefined {
  const [first, second] = [one.commands.get(command), other.commands.get(command)]
  if (first === undefined || second === undefined) return undefined
  const overrides = (winner: Leaf, loser: Leaf, isLater: boolean): boolean => {
    if (winner.commands.get(command) !== "always") return false
    if (loser.rate > 0) return winner.rate > loser.rate || (winner.rate === loser.rate && isLater)
    return winner.rate > 0 || (isLater && sameEvents(winner.events, loser.events))
  }
  return overrides(other, one, true) ? other : overrides(one, other, false) ? one : undefined
}

function sameEvents(one: ReadonlySet<string>, other: ReadonlySet<string>): boolean {
  return one.size > 0 && one.size === other.size && [...one].every(event => other.has(event))
}

/// Whether the winner's command can take what the loser reacts to into account: it reads a memory that is written when
/// the loser fires, directly or by events that the program sends itself.
function knowsOf(winner: Leaf, loser: Leaf, all: readonly Leaf[]): boolean {
  if (winner.reads.size === 0) return false
  const happened = new Set(loser.events)
  const written = new Set<string>()
  let before = -1
  while (before < happened.size + written.size) {
    before = happened.size + written.size
    for (const leaf of all) {
      if (leaf !== loser && ![...leaf.events].some(event => related(event, happened))) continue
      for (const type of leaf.writes) written.add(type)
      for (const type of leaf.sends) happened.add(type)
    }
  }
  return [...winner.reads].some(type => written.has(type))
}

/// An event and those that happened with it: `BumperLeft` is a view of `Bumper`.
function related(event: string, happened: ReadonlySet<string>): boolean {
  return [...happened].some(
    other => other === event || viewedEvent(other) === event || viewedEvent(event) === other,
  )
}

const functionsOf = (program: Program): ReadonlyMap<string, FunctionDeclaration> =>
  new Map(program.declarations.flatMap(d => (d.kind === "function" ? [[d.name, d] as const] : [])))

function leavesOf(inferred: InferredProgram): Leaf[] {
  const {read, globals, inference} = inferred
  const functions = functionsOf(read.program)
  const argument = simulated(functions.get("main"))
  if (argument === undefined) return []
  let types: ReturnType<typeof allTypes> | undefined
  const hasOwnPriority = functions.has("priority")
  return parts(argument, hasOwnPriority).flatMap(([expr, sides]): Leaf[] => {
    const named = expr.kind === "variable" ? functions.get(expr.name) : undefined
    if (named === undefined) types ??= allTypes(inference)
    const type = named === undefined ? types?.get(expr) : globals.get(named.name)?.type
    const name = nameOf(expr)
    if (type === undefined || name === undefined) return []
    const block = named?.from?.block ?? expr.from?.block
    const own = named === undefined ? {} : {type}
    return [{...leafOf({name, block, ...own}, type, named === undefined || isTotal(named)), sides}]
  })
}

/// What `main` gives to `simulate`.
function simulated(main: FunctionDeclaration | undefined): Expr | undefined {
  const body = main?.clauses[0]?.right.body
  if (body === undefined || Array.isArray(body)) return undefined
  const call = body as Expr
  const isSimulate = (fn: Expr) => fn.kind === "variable" && fn.name === "simulate"
  if (call.kind === "apply" && isSimulate(call.fn)) return call.args[0]
  return call.kind === "infix" && call.op === "$" && isSimulate(call.left) ? call.right : undefined
}

type Sides = ReadonlyMap<Expr, "first" | "second">

function parts(expr: Expr, hasOwnPriority: boolean, sides: Sides = new Map()): [Expr, Sides][] {
  const inside = (part: Expr, side?: "first" | "second") =>
    parts(part, hasOwnPriority, side === undefined ? sides : new Map([...sides, [expr, side]]))
  if (expr.kind === "tuple") return expr.items.flatMap(item => inside(item))
  if (expr.kind !== "apply" || expr.fn.kind !== "variable" || expr.fn.name !== "priority" || hasOwnPriority)
    return [[expr, sides]]
  const [, first, second] = expr.args
  return first === undefined || second === undefined
    ? []
    : [...inside(first, "first"), ...inside(second, "second")]
}

function nameOf(expr: Expr): string | undefined {
  if (expr.kind === "variable" || expr.kind === "constructor-name") return expr.name
  return expr.kind === "apply" ? nameOf(expr.fn) : undefined
}

function leafOf(named: Omit<Sender, "reacts">, type: Type, isTotal: boolean): Omit<Leaf, "sides"> {
  const reads = new Set<string>()
  const inputs: Input[] = []
  let output = type
  for (let f = asFunction(output); f !== undefined; f = asFunction(output)) {
    inputs.push(...inputsOf(f.from, reads))
    output = f.to
  }
  const out: Outputs = {writes: new Set(), sends: new Set(), commands: new Map()}
  readOutput(output, isTotal, out)
  const triggers = inputs.map(input => input.triggers).filter(sources => sources.length > 0)
  // It waits for every input that triggers; an input with several sources has a value whenever one of them has.
  const rate =
    triggers.length > 0
      ? (Math.min(...triggers.map(sources => Math.max(...sources.map(rateOf)))) as Rate)
      : inputs.some(input => input.isState)
        ? 50
        : 10
  const happening = new Set(triggers.flat().filter(source => rateOf(source) === 0))
  const sender = {...named, reacts: rate === 0 && happening.size > 0}
  return {sender, rate, events: happening, reads, ...out}
}

/// One input of a function.
interface Input {
  /// The types whose values make it new; empty for states and samples.
  readonly triggers: readonly string[]
  readonly isState: boolean
}

/// The tick `()` as an event, and a state inside an `Either`, which triggers like an event (rule R4), have a rate.
function rateOf(trigger: string): Rate {
  return trigger === "()" ? 10 : states.has(trigger) ? 50 : 0
}

function inputsOf(type: Type, reads: Set<string>): Input[] {
  const {head, args} = spine(type)
  if (head.kind !== "con") return []
  const {name} = head
  if (name === "Memory" || name === "Param") reads.add(`${name} ${typeKey(args[0])}`)
  if (samples.has(name)) return []
  if (states.has(name)) return [{triggers: [], isState: true}]
  if (/^\(,+\)$/.test(name)) return args.flatMap(item => inputsOf(item, reads))
  if (name !== "Either") return [{triggers: [name], isState: false}]
  const sides = args.map(side => spine(side).head).flatMap(side => (side.kind === "con" ? side.name : []))
  const inner = args.flatMap(side => inputsOf(side, reads)).flatMap(input => input.triggers)
  return [{triggers: [...inner, ...sides.filter(side => states.has(side))], isState: false}]
}

interface Outputs {
  readonly writes: Set<string>
  readonly sends: Set<string>
  readonly commands: Map<string, "always" | "sometimes">
}

function readOutput(type: Type, isSure: boolean, out: Outputs): void {
  const {head, args} = spine(type)
  if (head.kind !== "con") return
  const {name} = head
  if (heldCommands.has(name)) {
    out.commands.set(name, isSure || out.commands.get(name) === "always" ? "always" : "sometimes")
  } else if (name === "Memory" || name === "Param") out.writes.add(`${name} ${typeKey(args[0])}`)
  else if (/^\(,+\)$/.test(name)) for (const item of args) readOutput(item, isSure, out)
  else if (name === "Maybe" || name === "Either" || name === "[]")
    for (const item of args) readOutput(item, false, out)
  else out.sends.add(name)
}

function typeKey(type: Type | undefined): string {
  if (type === undefined) return "_"
  const {head, args} = spine(type)
  return `(${head.kind === "con" ? head.name : "_"}${args.map(arg => ` ${typeKey(arg)}`).join("")})`
}

/// Whether some clause takes every input and has an answer for it. Cases that cover a type together are not recognized.
function isTotal({clauses}: FunctionDeclaration): boolean {
  return clauses.some(clause => clause.patterns.every(isIrrefutable) && alwaysAnswers(clause))
}

function alwaysAnswers({right: {body}}: Clause): boolean {
  if (!Array.isArray(body)) return true
  const last = body[body.length - 1]?.guards
  const [only] = last ?? []
  return (
    last?.length === 1 &&
    only?.kind === "statement" &&
    (only.expr.kind === "variable" || only.expr.kind === "constructor-name") &&
    (only.expr.name === "otherwise" || only.expr.name === "True")
  )
}

/// Types of the language with one constructor, which has the type's name or stands for it.
const single = new Set(["Seconds", "Clock", "Memory", "Param", "()"])

function isIrrefutable(pattern: Pattern): boolean {
  switch (pattern.kind) {
    case "wildcard":
    case "name-pattern":
      return true
    case "as-pattern":
    case "typed-pattern":
      return isIrrefutable(pattern.pattern)
    case "strictness-pattern":
      return pattern.mark === "~" || isIrrefutable(pattern.pattern)
    case "tuple-pattern":
      return pattern.items.every(isIrrefutable)
    case "constructor-pattern":
      return (single.has(pattern.name) || records.has(pattern.name)) && pattern.args.every(isIrrefutable)
    default:
      return false
  }
}
