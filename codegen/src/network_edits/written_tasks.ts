/// The tasks of a program as its blocks say them: chains of steps, loops, and what runs side by side.
///
/// The chart is that of the compiler's report (`protocol/README.md` §3, *Graph*), with the block of each step in place of its extent, and of programs that
/// do not compile yet, too. The functions of `task start controller` are left to the compiler.

import type {Clause, Expr, FunctionDeclaration, Program, Statement} from "../model/syntax_tree.ts"
import type {BlockId} from "../serialized_blocks.ts"
import {allTypes} from "../types/inference.ts"
import {prune, spine, type Type} from "../types/syntax/type.ts"
import type {InferredWorkspace} from "../workspace/inference/workspace_inference.ts"

export interface WrittenTask {
  /// `task`: `task start controller`. `step`: a task that is not composed further.
  readonly kind: "step" | "task" | "sequence" | "repeat" | "parallel" | "race" | "choice"
  /// The block of the expression, where it is used.
  readonly block: BlockId
  /// Of a step the function that it calls; else the definition of the program that it is, or nothing.
  readonly name: string
  /// How often it is repeated, where that is written as a number.
  readonly turns: number | null
  readonly steps: readonly WrittenTask[]
  /// What the next steps call its result.
  readonly result: string | null
}

/// Steps of a program from which on no more are opened.
const mostSteps = 500

/// Names of the library that have the meaning of others.
const aliases: {readonly [name: string]: string} = {
  parallel_: "parallel",
  race_: "race",
  replicateM: "replicateM_",
  mapM: "mapM_",
  traverse_: "mapM_",
  forM: "forM_",
  for_: "forM_",
  unless: "when",
}

export const isTaskType = (type: Type | undefined): boolean => {
  if (type === undefined) return false
  const {head} = spine(prune(type))
  return head.kind === "con" && head.name === "Task"
}

/// The tasks that `simulate` runs, in the order of the text; `null` where what it runs is computed, or a program has no `simulate`.
export function writtenTasks(inferred: InferredWorkspace): readonly WrittenTask[] | null {
  const {program} = inferred.read
  const main = program.declarations.find(d => d.kind === "function" && d.name === "main")
  const simulated = main?.kind === "function" ? argumentOfSimulate(main) : undefined
  if (simulated === undefined) return null
  const types = allTypes(inferred.inference)
  const reader = new TaskReader(program)
  let isKnown = true
  const controllers = (e: Expr): readonly WrittenTask[] => {
    if (e.kind === "tuple" || e.kind === "list") return e.items.flatMap(controllers)
    const type = types.get(e)
    if (isTaskType(type)) return reader.tasks(e)
    const {name, args} = called(e)
    if (name === "priority" && args.length === 3) return args.slice(1).flatMap(controllers)
    // What has tasks somewhere in it is opened by the compiler alone.
    if (type !== undefined && mentionsTask(type)) isKnown = false
    return []
  }
  const found = controllers(simulated)
  return isKnown ? found : null
}

function mentionsTask(type: Type): boolean {
  const {head, args} = spine(prune(type))
  const isController = head.kind === "con" && /^(?:Task|\[\]|\(,+\)|Plan|Controller)$/.test(head.name)
  return isController && (args.length === 0 || args.some(arg => mentionsTask(arg) || isTaskType(arg)))
}

function argumentOfSimulate({clauses}: FunctionDeclaration): Expr | undefined {
  const body = clauses[0]?.right.body
  if (clauses.length !== 1 || body === undefined || isGuarded(body)) return undefined
  const {name, args} = called(body)
  return name === "simulate" && args.length === 1 ? args[0] : undefined
}

const isGuarded = (body: Clause["right"]["body"]): body is Exclude<Clause["right"]["body"], Expr> =>
  Array.isArray(body)

/// The name that an expression calls, with its arguments.
function called(e: Expr): {readonly name: string | undefined; readonly args: readonly Expr[]} {
  if (e.kind === "variable") return {name: e.name, args: []}
  if (e.kind === "apply") {
    const {name, args} = called(e.fn)
    return {name, args: [...args, ...e.args]}
  }
  if (e.kind === "infix" && e.op === "$") {
    const {name, args} = called(e.left)
    return {name, args: [...args, e.right]}
  }
  return {name: undefined, args: []}
}

class TaskReader {
  readonly #functions: ReadonlyMap<string, FunctionDeclaration>
  /// Definitions that are open around an expression: a recursion ends there.
  readonly #open = new Set<string>()
  #left = mostSteps

  constructor({declarations}: Program) {
    this.#functions = new Map(
      declarations.flatMap(d => (d.kind === "function" ? [[d.name, d] as const] : [])),
    )
  }

  /// The parts of a task: one, or none where nothing is written yet.
  tasks(e: Expr): readonly WrittenTask[] {
    if (this.#left-- <= 0) return []
    switch (e.kind) {
      case "do":
        return composed(
          e,
          "sequence",
          null,
          e.statements.flatMap(s => this.#statement(s)),
        )
      case "if":
        return this.#choice(e, [e.yes, e.no])
      case "branches":
        return this.#choice(
          e,
          e.branches.map(({body}) => body),
        )
      case "case":
        return this.#choice(
          e,
          e.alternatives.flatMap(({right: {body}}) => (isGuarded(body) ? body.map(g => g.body) : [body])),
        )
      case "let":
        return this.tasks(e.body)
      case "typed":
        return this.tasks(e.expr)
      case "hole":
        return []
      case "infix":
        if (e.op === "$") break
        if (/^(?:>>|\*>|<\*)$/.test(e.op))
          return composed(e, "sequence", null, [...this.tasks(e.left), ...this.tasks(e.right)])
        if (e.op === ">>=")
          return composed(e, "sequence", null, [...this.tasks(e.left), ...this.#resultOf(e.right)])
        if (e.op === "<$>" || e.op === "<$") return this.tasks(e.right)
        if (e.op === "$>" || e.op === "<&>") return this.tasks(e.left)
        return [step(e, "")]
      default:
    }
    const {name, args} = called(e)
    if (name === undefined) return [step(e, "")]
    return this.#definition(e, name, args) ?? this.#library(e, aliases[name] ?? name, args) ?? [step(e, name)]
  }

  #statement(s: Statement): readonly WrittenTask[] {
    if (s.kind === "let-statement") return []
    const found = this.tasks(s.expr)
    const [only] = found
    if (s.kind !== "bind" || s.pattern.kind !== "name-pattern" || only === undefined || found.length > 1)
      return found
    return [{...only, result: s.pattern.name}]
  }

  /// What a function gives: its body, or its call.
  #resultOf(e: Expr): readonly WrittenTask[] {
    return e.kind === "lambda" ? this.tasks(e.body) : this.tasks(e)
  }

  #choice(e: Expr, all: readonly Expr[]): readonly WrittenTask[] {
    const found = all.map(one => this.tasks(one))
    // Alternatives that are the same definition are one.
    const distinct = new Map(found.map(tasks => [tasks.map(keyOf).join(), tasks]))
    return distinct.size < 2 ? (found[0] ?? []) : composed(e, "choice", null, [...distinct.values()].flat())
  }

  /// A definition of the program is opened where it is used, with its name.
  #definition(e: Expr, name: string, args: readonly Expr[]): readonly WrittenTask[] | undefined {
    const definition = this.#functions.get(name)
    if (definition === undefined) return undefined
    if (this.#open.has(name) || definition.clauses.some(({patterns}) => patterns.length !== args.length))
      return [step(e, name)]
    this.#open.add(name)
    const bodies = definition.clauses.flatMap(({right: {body}}) =>
      isGuarded(body) ? body.map(g => g.body) : [body],
    )
    const found = this.#choice(e, bodies)
    this.#open.delete(name)
    const block = e.from?.block ?? ""
    const [only] = found
    return only === undefined || found.length > 1 ? found : [{...only, name, block, result: null}]
  }

  #library(e: Expr, name: string, args: readonly Expr[]): readonly WrittenTask[] | undefined {
    const [first, second] = args
    const block = e.from?.block ?? ""
    if (second !== undefined && args.length === 2)
      switch (name) {
        case "task":
        case "taskWith":
          return [{...step(e, ""), kind: "task"}]
        case "parallel":
        case "race": {
          const steps = args.flatMap(arg => this.tasks(arg))
          return [{kind: name, block, name: "", turns: null, steps, result: null}]
        }
        case "replicateM_":
          return composed(
            e,
            "repeat",
            first?.kind === "number" ? Number(first.text) : null,
            this.tasks(second),
          )
        case "mapM_":
          return composed(e, "repeat", null, first === undefined ? [] : this.#resultOf(first))
        case "forM_":
          return composed(e, "repeat", null, this.#resultOf(second))
        case "when":
          return composed(e, "choice", null, this.tasks(second))
        case "fmap":
          return this.tasks(second)
        default:
      }
    if (first === undefined || args.length > 1) return undefined
    switch (name) {
      case "once":
        return [{...step(e, ""), kind: "task"}]
      case "forever":
        return composed(e, "repeat", null, this.tasks(first))
      case "void":
        return this.tasks(first)
      default:
        return undefined
    }
  }
}

const keyOf = ({kind, name, block}: WrittenTask) =>
  kind === "step" || name === "" ? `${kind} ${block}` : `${kind} ${name}`

const step = ({from}: Expr, name: string): WrittenTask => ({
  kind: "step",
  block: from?.block ?? "",
  name,
  turns: null,
  steps: [],
  result: null,
})

/// One part of several, unless it is a sequence of one.
function composed(
  {from}: Expr,
  kind: WrittenTask["kind"],
  turns: number | null,
  found: readonly WrittenTask[],
): readonly WrittenTask[] {
  if (found.length === 0 || (kind === "sequence" && found.length === 1)) return found
  // The steps of a sequence without a name are those of the sequence, or of the loop, that it is in.
  const isFlat = kind === "sequence" || (kind === "repeat" && found.length === 1)
  const steps = isFlat
    ? found.flatMap(one =>
        one.kind === "sequence" && one.name === "" && one.result === null ? one.steps : [one],
      )
    : found
  return [{kind, block: from?.block ?? "", name: "", turns, steps, result: null}]
}
