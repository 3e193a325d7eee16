/// The functions of a program with what they take and send, as inference knows them: also of a program with empty places, which the compiler does not report.
///
/// Functions of other types than those of the robot, of memories and of the program's own events are left out.

import {chain} from "../blocks/block_reader.ts"
import {objectsIn} from "../blocks/spec/block_spec.ts"
import {commands, events, states} from "../robot/roles.ts"
import type {SavedBlock, SavedWorkspace} from "../serialized_blocks.ts"
import {type Environment, expand} from "../types/environment/environment.ts"
import {asFunction, metasIn, showType, spine, type Type} from "../types/syntax/type.ts"
import {parseSignature} from "../types/syntax/type_parser.ts"
import {InferenceSession} from "../workspace/inference/inference_session.ts"
import {everyBlockIn} from "../workspace/inference/workspace_inference.ts"
import {isPlaced} from "./simulated_places.ts"
import {isTaskType, type WrittenTask, writtenTasks} from "./written_tasks.ts"

/// As in the compiler's report (`protocol/README.md` §3, *Graph*).
export type WrittenShape =
  | {readonly kind: "all"; readonly of: readonly WrittenShape[]}
  | {readonly kind: "either"; readonly of: readonly WrittenShape[]}
  | {readonly kind: "maybe"; readonly of: WrittenShape}
  | {readonly kind: "each"; readonly of: WrittenShape}
  | {
      readonly kind: "type"
      readonly written: string
      readonly spelled: string
      readonly own: boolean
      readonly topic: null
    }

export interface WrittenFunction {
  readonly name: string
  /// Whether `simulate` runs it by its name.
  readonly runs: boolean
  readonly inputs: readonly WrittenShape[]
  readonly output: WrittenShape
}

export interface WrittenNetwork {
  readonly functions: readonly WrittenFunction[]
  /// The program's own types that tell something apart or hold something: what a memory can be of.
  readonly types: readonly string[]
  /// The tasks that `simulate` runs; `null` where only the compiler knows them.
  readonly tasks: readonly WrittenTask[] | null
  /// The definitions that can be a step of a task as they are.
  readonly steps: readonly string[]
  /// Whether the places of `simulate` are known; else it is unknown what runs.
  readonly hasSimulate: boolean
}

export function writtenNetwork(workspace: SavedWorkspace, session = new InferenceSession()): WrittenNetwork {
  const inferred = session.inferWorkspace(workspace)
  const {inference, globals} = inferred
  const tops = workspace.blocks.blocks.flatMap(chain)
  const main = tops.find(({type}) => type === "main")
  const own = new Set(tops.flatMap(({type, extraState}) => (type === "data" ? String(extraState?.name) : [])))
  const used = usesIn(tops)
  const functions = tops.flatMap((block): WrittenFunction[] => {
    const {name, signature} = block.extraState ?? {}
    if (block.type !== "define" || typeof name !== "string" || name === "main") return []
    const written = typeof signature === "string" ? parseSignature(signature)?.type : undefined
    const type = written ?? globals.get(name)?.type
    if (type === undefined || metasIn(type).size > 0) return []
    const inputs: WrittenShape[] = []
    let output = type
    for (let f = asFunction(output); f !== undefined; f = asFunction(output)) {
      const input = shapeOf(f.from, inference.env, own)
      if (input === undefined) return []
      inputs.push(input)
      output = f.to
    }
    const sent = shapeOf(output, inference.env, own)
    const runs = main !== undefined && isPlaced(main, name)
    if (sent === undefined || (!runs && used.has(name))) return []
    return [{name, runs, inputs, output: sent}]
  })
  const steps = [...globals.all()].flatMap(([name, {type}]) => (isTaskType(type) ? [name] : []))
  return {
    functions,
    types: tops.flatMap(rememberable),
    tasks: writtenTasks(inferred),
    steps,
    hasSimulate: main !== undefined,
  }
}

/// The name of a type without parameters that is another name of a type, or not only an event.
function rememberable({type, extraState = {}}: SavedBlock): readonly string[] {
  const constructors = objectsIn(extraState, "constructors")
  const [only, ...others] = constructors
  const hasContent = others.length > 0 || (only !== undefined && objectsIn(only, "fields").length > 0)
  const isPlain = !(Array.isArray(extraState.parameters) && extraState.parameters.length > 0)
  const isValue = type === "synonym" || (type === "data" && hasContent)
  return isPlain && isValue && typeof extraState.name === "string" ? [extraState.name] : []
}

/// The names in each definition but its own, which distinguish a helper from what could run.
function usesIn(tops: readonly SavedBlock[]): ReadonlySet<string> {
  const used = new Set<string>()
  for (const top of tops) {
    const own = top.extraState?.name
    for (const {type, extraState} of everyBlockIn({...top, next: {}})) {
      if (type === "name" && typeof extraState?.name === "string" && extraState.name !== own)
        used.add(extraState.name)
      if (type.startsWith("raw"))
        for (const word of String(extraState?.text).match(/[\p{L}_][\p{L}\p{N}_']*/gu) ?? []) used.add(word)
    }
  }
  return used
}

const values = new Set(["Seconds", "Clock", "StdGen", "()"])
const holders = new Set(["Memory", "Param", "Done"])

/// Undefined for a type that is no shape of a reactive function (rules R14 and R15).
function shapeOf(type: Type, env: Environment, own: ReadonlySet<string>): WrittenShape | undefined {
  const written = showType(type)
  const meaning = expand(type, env)
  const {head, args: expanded} = spine(meaning)
  if (head.kind !== "con") return undefined
  // Synonyms inside of a shape are as they are written.
  const asWritten = spine(type)
  const isWritten = asWritten.head.kind === "con" && asWritten.head.name === head.name
  const args = isWritten ? asWritten.args : expanded
  const parts = args.map(arg => shapeOf(arg, env, own))
  const all = parts.flatMap(part => part ?? [])
  const {name} = head
  if (name === "Either" || /^\(,+\)$/.test(name))
    return all.length < args.length ? undefined : {kind: name === "Either" ? "either" : "all", of: all}
  if (name === "Maybe" || name === "[]") {
    const [of] = all
    return of === undefined ? undefined : {kind: name === "Maybe" ? "maybe" : "each", of}
  }
  const isKnown = events.has(name) || states.has(name) || commands.has(name) || values.has(name)
  if (!own.has(name) && !holders.has(name) && !isKnown) return undefined
  return {kind: "type", written, spelled: showType(meaning), own: own.has(name), topic: null}
}
