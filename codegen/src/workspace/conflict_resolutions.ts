/// Ways out of a command conflict: definitions that wrap the two functions, and what `simulate` runs instead of them.
///
/// The functions of the program stay as they are. Input: the workspace and the names of the two functions. Output: Haskell, which the caller puts
/// into the text. A way that does not apply (several outputs, an expression in place of a name, a memory that is already used) is left out.

import type {ConflictNames} from "../api.ts"
import {nameOf, namesDefinedBy} from "../model/bound_names.ts"
import type {SavedWorkspace} from "../serialized_blocks.ts"
import {asFunction, showType, spine, type Type} from "../types/type.ts"
import {
  type CommandConflict,
  commandConflicts,
  conflictBetween,
  type InferredProgram,
  memoriesOf,
  problemsOfConflict,
  type Sender,
} from "./command_conflicts.ts"
import {inferWorkspace} from "./workspace_inference.ts"

export interface ConflictResolution {
  readonly kind: "memory" | "either" | "mux"
  /// New definitions, to stand before `main`, without an empty line at the end.
  readonly definitions: string
  /// The argument of `simulate` after the change, given the one before.
  readonly rewrite: (argument: string) => string
}

/// What a run has shown, as warnings for the blocks; none when the functions are not in conflict.
export function conflictShown(workspace: SavedWorkspace, names: ConflictNames) {
  const conflict = conflictBetween(inferWorkspace(workspace), names)
  return conflict === undefined ? [] : problemsOfConflict(conflict)
}

/// Every way out that applies, the one that keeps most of the program first.
export function conflictResolutions(workspace: SavedWorkspace, names: ConflictNames): ConflictResolution[] {
  const inferred = inferWorkspace(workspace)
  const conflict =
    commandConflicts(inferred).find(
      c => c.command === names.command && c.winner.name === names.winner && c.loser.name === names.loser,
    ) ?? conflictBetween(inferred, names)
  if (conflict === undefined) return []
  const pair = pairOf(inferred, conflict)
  if (pair === undefined) return []
  const ways = [byMemory(pair), byEither(pair), byMux(pair)]
  return ways.filter(way => way !== undefined)
}

/// The two functions of a conflict, with the names that are free in their program.
interface Pair {
  /// The type of the command.
  readonly command: string
  readonly winner: Wrapped
  readonly loser: Wrapped
  /// Types of memory that are in use.
  readonly memories: ReadonlySet<string>
  /// A name that the program does not have yet.
  readonly free: (wanted: string) => string
}

/// A function that sends one command, always or sometimes.
interface Wrapped {
  readonly name: string
  readonly inputs: readonly {readonly type: string; readonly pattern: string; readonly value: string}[]
  readonly isMaybe: boolean
}

function pairOf(inferred: InferredProgram, {command, winner, loser}: CommandConflict): Pair | undefined {
  const taken = new Set(
    inferred.read.program.declarations.flatMap(d =>
      d.kind === "data"
        ? [d.name, ...d.constructors.map(c => c.name), ...namesDefinedBy(d)]
        : [nameOf(d), ...namesDefinedBy(d)],
    ),
  )
  const free = (wanted: string): string => {
    let name = wanted
    for (let n = 2; taken.has(name); n++) name = `${wanted}${n}`
    taken.add(name)
    return name
  }
  const [one, other] = [wrapped(winner, command, taken), wrapped(loser, command, taken)]
  if (one === undefined || other === undefined) return undefined
  return {command, winner: one, loser: other, memories: memoriesOf(inferred), free}
}

function wrapped({name, type}: Sender, command: string, taken: ReadonlySet<string>): Wrapped | undefined {
  if (type === undefined) return undefined
  const inputs: Wrapped["inputs"][number][] = []
  const used = new Set(taken)
  let output: Type = type
  for (let f = asFunction(output); f !== undefined; f = asFunction(output)) {
    inputs.push(inputOf(f.from, used))
    output = f.to
  }
  const {head, args} = spine(output)
  const inner = args[0] === undefined ? undefined : spine(args[0]).head
  const isNamed = (t: typeof head | undefined, wanted: string) => t?.kind === "con" && t.name === wanted
  if (isNamed(head, command)) return {name, inputs, isMaybe: false}
  return isNamed(head, "Maybe") && isNamed(inner, command) ? {name, inputs, isMaybe: true} : undefined
}

function inputOf(type: Type, used: Set<string>): Wrapped["inputs"][number] {
  const {head, args} = spine(type)
  const shown = showType(type)
  const arrow = asFunction(type) === undefined ? shown : `(${shown})`
  if (head.kind === "con" && head.name === "()") return {type: arrow, pattern: "()", value: "()"}
  const named = head.kind === "con" && args.length === 0 && /^[A-Z]\w*$/.test(head.name)
  const wanted = named ? `${head.name.charAt(0).toLowerCase()}${head.name.slice(1)}` : "input"
  let name = wanted
  for (let n = 2; used.has(name); n++) name = `${wanted}${n}`
  used.add(name)
  return {type: arrow, pattern: name, value: name}
}

/// What the loser sent last is remembered, and the winner sends it from then on.
function byMemory({command, winner, loser, memories, free}: Pair): ConflictResolution | undefined {
  if (memories.has(memoryKey(command))) return undefined
  const remember = free(`remember${capital(loser.name)}`)
  const unless = free(`${winner.name}Unless${capital(loser.name)}`)
  const memory = `Memory (Maybe ${command})`
  const definitions = [
    signature(remember, loser, memory),
    `${applied(remember, loser, "pattern")} = Memory (${asMaybe(loser)})`,
    "",
    signature(unless, winner, winner.isMaybe ? `Maybe ${command}` : command, [memory]),
    `${[unless, "(Memory (Just answer))", ...winner.inputs.map(() => "_")].join(" ")} = ${winner.isMaybe ? "Just answer" : "answer"}`,
    `${[unless, "(Memory Nothing)", ...winner.inputs.map(input => input.pattern)].join(" ")} = ${call(winner)}`,
  ]
  return {
    kind: "memory",
    definitions: definitions.join("\n"),
    rewrite: argument => replaceName(replaceName(argument, winner.name, unless), loser.name, remember),
  }
}

/// One function takes what the loser takes, or a tick, and decides for both.
function byEither({command, winner, loser, memories, free}: Pair): ConflictResolution | undefined {
  const [event] = loser.inputs
  const isTick = winner.inputs.every(input => input.value === "()")
  if (memories.has(memoryKey(command)) || event === undefined || loser.inputs.length > 1 || !isTick)
    return undefined
  if (winner.isMaybe) return undefined
  const name = free(`${winner.name}Or${capital(loser.name)}`)
  const memory = `Memory (Maybe ${command})`
  const answer = `(maybe ${call(winner, true)} id answer, Memory answer)`
  const definitions = [
    `${name} :: Either ${argument(event.type)} () -> ${memory} -> (${command}, ${memory})`,
    `${name} (Left ${event.pattern}) _ = ${answer}`,
    "  where",
    `    answer = ${asMaybe(loser)}`,
    `${name} (Right ()) (Memory answer) = ${answer}`,
  ]
  return {
    kind: "either",
    definitions: definitions.join("\n"),
    rewrite: text => combined(text, winner.name, loser.name, name),
  }
}

/// The loser's commands are more important: for a second after one of them, the winner's do not pass.
function byMux({command, winner, loser, free}: Pair): ConflictResolution {
  const [important, usual, until, mux] = [free("Important"), free("Usual"), free("Until"), free("mux")]
  const first = free(`${loser.name}First`)
  const second = free(`${winner.name}Second`)
  const sends = (one: Wrapped, kind: string) =>
    one.isMaybe ? `fmap ${kind} (${call(one)})` : `${kind} ${call(one, true)}`
  const output = (one: Wrapped, kind: string) => (one.isMaybe ? `Maybe ${kind}` : kind)
  const variable = `${command.charAt(0).toLowerCase()}${command.slice(1)}`
  const definitions = [
    `data ${important} = ${important} ${command}`,
    "",
    `data ${usual} = ${usual} ${command}`,
    "",
    `data ${until} = ${until} Seconds`,
    "",
    signature(first, loser, output(loser, important)),
    `${applied(first, loser, "pattern")} = ${sends(loser, important)}`,
    "",
    signature(second, winner, output(winner, usual)),
    `${applied(second, winner, "pattern")} = ${sends(winner, usual)}`,
    "",
    `${mux} :: Either ${important} ${usual} -> Seconds -> Memory ${until} -> Maybe (${command}, Memory ${until})`,
    `${mux} (Left (${important} ${variable})) now _ = Just (${variable}, Memory (${until} (now + 1)))`,
    `${mux} (Right (${usual} ${variable})) now (Memory (${until} end))`,
    `  | now > end = Just (${variable}, Memory (${until} end))`,
    "  | otherwise = Nothing",
  ]
  return {
    kind: "mux",
    definitions: definitions.join("\n"),
    // A group of its own when a tuple would have more than nine parts.
    rewrite: text => {
      const both = text.split(",").length < 9 ? `${second}, ${mux}` : `(${second}, ${mux})`
      return replaceName(replaceName(text, winner.name, both), loser.name, first)
    },
  }
}

const memoryKey = (command: string) => `Memory (Maybe (${command}))`
const capital = (name: string) => name.charAt(0).toUpperCase() + name.slice(1)
const argument = (type: string) => (/^[\w.]+$|^[([].*[)\]]$/.test(type) ? type : `(${type})`)

function signature(name: string, {inputs}: Wrapped, output: string, before: readonly string[] = []): string {
  return `${name} :: ${[...before, ...inputs.map(input => input.type), output].join(" -> ")}`
}

function applied(name: string, {inputs}: Wrapped, as: "pattern" | "value"): string {
  return [name, ...inputs.map(input => input[as])].join(" ")
}

/// The function with its inputs; as an argument in brackets where it needs them.
function call(one: Wrapped, isArgument = false): string {
  const text = applied(one.name, one, "value")
  return isArgument && one.inputs.length > 0 ? `(${text})` : text
}

function asMaybe(one: Wrapped): string {
  return one.isMaybe ? call(one) : `Just ${call(one, true)}`
}

/// A name of the program in a text, not as a part of another name.
const occurrences = (name: string) => new RegExp(`(?<![\\w'.])${name.replace(/[$]/g, "\\$&")}(?![\\w'])`, "g")

function replaceName(text: string, name: string, by: string): string {
  return text.replace(occurrences(name), () => by)
}

/// One function in the place of two.
function combined(text: string, winner: string, loser: string, by: string): string {
  const names = text
    .replace(/^\(|\)$/g, "")
    .split(",")
    .map(item => item.trim())
  if (/^\(.*\)$/s.test(text) && names.length === 2) return by
  const rest = text.replace(
    new RegExp(`\\s*,\\s*${occurrences(loser).source}|${occurrences(loser).source}\\s*,\\s*`),
    "",
  )
  return replaceName(rest, winner, by)
}
