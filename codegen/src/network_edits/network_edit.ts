/// Applies an edit of the dataflow network to a program: its blocks are changed, and the text follows as with any edit of blocks, so that comments and all
/// that is not meant keep every character. An edit after which inference would find a mistake that was not there is refused.

import {chain} from "../blocks/block_reader.ts"
import {objectsIn} from "../blocks/spec/block_spec.ts"
import {isConstructorName, isVariableName, reservedWords} from "../haskell/lexemes.ts"
import type {Reader} from "../reader/module/module_reader.ts"
import {syncBlocks} from "../reader/view/block_synchronization.ts"
import type {View} from "../reader/view/view.ts"
import {workspaceOf} from "../reader/view/view.ts"
import {events, states} from "../robot/roles.ts"
import type {SavedBlock, SavedWorkspace} from "../serialized_blocks.ts"
import {expand} from "../types/environment/environment.ts"
import {allTypes} from "../types/inference.ts"
import {metasIn, showScheme, showType, spine, type Type} from "../types/syntax/type.ts"
import {parseSignature, parseType} from "../types/syntax/type_parser.ts"
import {InferenceSession} from "../workspace/inference/inference_session.ts"
import {everyBlock, type InferredWorkspace, problemsOf} from "../workspace/inference/workspace_inference.ts"
import {referenceTo} from "../workspace/moves/definition_references.ts"
import {isRefusal} from "../workspace/moves/refusal_messages.ts"
import {rename} from "../workspace/renaming/renaming.ts"
import {mapExtras} from "../workspace/renaming/renaming_changes.ts"
import {con, make, reaction, ref} from "../workspace/toolbox/block_builders.ts"
import {withOutput} from "./added_output.ts"
import {type TypedDefinition, type TypeMeanings, withoutInput, withoutOutput} from "./cuts.ts"
import {
  arityOf,
  mostArguments,
  namesUsed,
  type OwnTypes,
  patternFor,
  patternsOf,
  withEquation,
  withPatterns,
  withSignature,
} from "./definition_edits.ts"
import type {DeclaredType, NetworkAction, NetworkEdit} from "./network_action.ts"
import {readyFunction} from "./ready_functions.ts"
import {Refused, refuse} from "./refused.ts"
import {signatureParts, textOf, withAlternative, withArgument} from "./signature_text.ts"
import {isPlaced, withoutPlaces, withPlace} from "./simulated_places.ts"
import {isTaskAction, type TaskAction, taskEdit} from "./task_edits.ts"
import {isTaskType} from "./written_tasks.ts"

/// The text of the program after an edit of its network. A session remembers the types of definitions that stay the same. `declares` is a type that
/// the edit needs.
export function networkEdit(
  reader: Reader,
  view: View,
  action: NetworkAction,
  session = new InferenceSession(),
  declares?: DeclaredType,
): NetworkEdit {
  try {
    const before = workspaceOf(view)
    const change = new NetworkChange(before, session)
    if (declares !== undefined) change.declare(declares)
    const selects = change.apply(action)
    const after = change.workspace
    const why = newMistake(change.inferred, session.inferWorkspace(after))
    if (why !== undefined) return {ok: false, refusal: {kind: "does-not-fit", why}}
    const synchronized = syncBlocks(reader, view, after)
    return synchronized.refused === undefined
      ? {ok: true, text: synchronized.text, selects}
      : {ok: false, refusal: {kind: "unfinished", names: synchronized.refused}}
  } catch (thrown) {
    if (thrown instanceof Refused) return {ok: false, refusal: thrown.refusal}
    throw thrown
  }
}

/// A mistake that inference finds after an edit and did not find before it.
function newMistake(before: InferredWorkspace, inferred: InferredWorkspace): string | undefined {
  const mistakes = ({inference}: InferredWorkspace) => inference.problems.filter(isRefusal).length
  if (mistakes(inferred) <= mistakes(before)) return undefined
  const known = new Set(problemsOf(before).map(problem => problem.message))
  const all = problemsOf(inferred).filter(({kind, severity}) => severity === "error" && kind !== "hole")
  return (all.find(problem => !known.has(problem.message)) ?? all[0])?.message ?? ""
}

class NetworkChange {
  workspace: SavedWorkspace
  readonly inferred: InferredWorkspace
  readonly #session: InferenceSession
  #newId = 0

  constructor(workspace: SavedWorkspace, session: InferenceSession) {
    this.workspace = workspace
    this.inferred = session.inferWorkspace(workspace)
    this.#session = session
  }

  /// Changes the workspace; returns the name of the definition to look at next.
  apply(action: NetworkAction): string | undefined {
    if (isTaskAction(action)) {
      this.#editTask(action)
      return undefined
    }
    switch (action.kind) {
      case "connect-sensor-to-actuator":
        this.#connect(action.sensor, action.actuator, action.name)
        return action.name
      case "add-input":
        this.#addInput(action.function, action.type, action.as)
        return action.function
      case "add-output":
        this.#addOutput(action.function, action.type, undefined)
        return action.function
      case "connect-functions":
        this.#connectFunctions(action)
        return action.to
      case "cut-input":
        this.#cutInput(action.function, action.type)
        return action.function
      case "cut-output":
        this.#cutOutput(action.function, action.type)
        return action.function
      case "delete":
        this.#delete(action.function)
        return undefined
      case "rename":
        this.#rename(action.function, action.name)
        return action.name
      case "duplicate":
        this.#duplicate(action.function, action.name)
        return action.name
      case "join":
        if (this.#runs(action.function)) refuse({kind: "already-runs", function: action.function})
        this.#join(this.#definition(action.function))
        return action.function
      default:
        this.#leave(action.function)
        return action.function
    }
  }

  /// Two tasks side by side have a pair of results, which is thrown away where the program wants another one.
  #editTask(action: TaskAction): void {
    const tasks = new Set(
      [...allTypes(this.inferred.inference)].flatMap(([node, type]) =>
        "from" in node && node.from?.input === undefined && isTaskType(type) ? [node.from?.block] : [],
      ),
    )
    const edited = (asUnit: boolean) => taskEdit(this.workspace, action, block => tasks.has(block), asUnit)
    const plain = edited(false)
    const fits = action.kind !== "put-beside" || this.#isWithoutNewMistake(plain)
    this.workspace = fits ? plain : edited(true)
  }

  #isWithoutNewMistake(workspace: SavedWorkspace): boolean {
    return newMistake(this.inferred, this.#session.inferWorkspace(workspace)) === undefined
  }

  #connect(sensor: string, actuator: string, name: string): void {
    this.#checkName(name)
    const pattern = () => patternFor(sensor, this.#ownTypes(), this.#names())
    const ready = readyFunction(
      {sensor, actuator},
      {expanded: type => this.#expanded(type), values: type => this.#valuesOf(type), pattern},
    )
    if (ready !== undefined) {
      const {block, signature} = ready
      const called = {...block, extraState: {...block.extraState, name}}
      this.#join(this.#add(withSignature(called, signature)))
      return
    }
    const block = reaction(name, readingOf(sensor), sensor === "()" ? [] : [pattern()])
    const signature = sensor === "()" ? actuator : `${sensor} -> ${actuator}`
    this.#join(this.#add(withSignature(block, signature)))
  }

  /// The values of a type of the program, where none of them holds anything.
  #valuesOf(type: string): readonly string[] {
    const data = this.#tops().find(top => top.type === "data" && top.extraState?.name === type)
    const constructors = objectsIn(data?.extraState ?? {}, "constructors")
    const isPlain = constructors.every(one => !Array.isArray(one.fields) || one.fields.length === 0)
    return isPlain ? constructors.flatMap(one => (typeof one.name === "string" ? [one.name] : [])) : []
  }

  #addInput(name: string, type: string, as: "all" | "either"): void {
    const {block, signature, parts} = this.#typed(name)
    if (this.#leaves(parts.arguments.map(range => textOf(signature, range))).includes(this.#expanded(type)))
      refuse({kind: "already-takes", function: name, type})
    const arity = arityOf(block)
    const own = this.#ownTypes()
    if (as === "all") {
      if (parts.arguments.length >= mostArguments) refuse({kind: "takes-too-much", function: name})
      // A function with fewer patterns than arguments gives a function: what it takes first is still the first pattern.
      const first = arity < parts.arguments.length
      const changed = withPatterns(block, i => {
        const patterns = patternsOf(block, i)
        const added = patternFor(type, own, this.#names(block))
        return first ? [added, ...patterns] : [...patterns, added]
      })
      this.#change(block, () => withSignature(changed, withArgument(signature, parts, type, first)))
      return
    }
    const at = parts.arguments.findIndex(range => this.#isEvent(textOf(signature, range)))
    const argument = parts.arguments[at] ?? refuse({kind: "takes-no-event", function: name})
    if (arity <= at) refuse({kind: "takes-no-event", function: name})
    const left = withPatterns(block, i =>
      patternsOf(block, i).map((pattern, j) => (j === at ? side("Left", pattern) : pattern)),
    )
    const taken = this.#names()
    const patterns = Array.from({length: arity}, (_, j) => {
      const range = parts.arguments[j]
      const taking = j === at || range === undefined ? type : textOf(signature, range)
      const pattern = patternFor(taking, own, taken)
      return j === at ? side("Right", pattern) : pattern
    })
    const changed = withEquation(left, patterns)
    this.#change(block, () => withSignature(changed, withAlternative(signature, argument, type)))
  }

  /// `value` is what each answer sends; undefined leaves a place for it.
  #addOutput(name: string, type: string, value: SavedBlock | undefined): void {
    const {block, signature, parts} = this.#typed(name)
    if (arityOf(block) < parts.arguments.length) refuse({kind: "type-unknown", function: name})
    if (this.#leaves([textOf(signature, parts.result)]).includes(this.#expanded(type)))
      refuse({kind: "already-sends", function: name, type})
    this.#change(block, () => withOutput({block, signature, parts}, type, value))
  }

  #connectFunctions({from, to, event, as}: Extract<NetworkAction, {kind: "connect-functions"}>): void {
    const {signature, parts} = this.#typed(from)
    const sends = this.#leaves([textOf(signature, parts.result)]).includes(this.#expanded(event))
    if (!sends) {
      if (!this.#ownTypes().has(event)) this.declare({name: event, values: [event]})
      const only = this.#ownTypes().get(event)
      this.#addOutput(from, event, only === undefined ? undefined : con(only))
    }
    this.#addInput(to, event, as)
  }

  declare({name, values}: DeclaredType): void {
    const {types, constructors} = this.inferred.inference.env
    for (const one of [name, ...values])
      if (!isConstructorName(one)) refuse({kind: "not-a-type-name", name: one})
    if (types.has(name)) refuse({kind: "name-taken", name})
    const taken = values.find((value, i) => constructors.has(value) || values.indexOf(value) < i)
    if (taken !== undefined) refuse({kind: "name-taken", name: taken})
    const declared = values.map(value => ({name: value, fields: []}))
    this.#add(make("data", {name, parameters: [], constructors: declared, deriving: []}))
  }

  #cutInput(name: string, type: string): void {
    const typed = this.#typed(name)
    this.#change(typed.block, () => withoutInput(typed, type, this.#meanings))
  }

  #cutOutput(name: string, type: string): void {
    const typed = this.#typed(name)
    const changed = withoutOutput(typed, type, this.#meanings)
    if (changed === undefined) this.#leave(name)
    else this.#change(typed.block, () => changed)
  }

  #delete(name: string): void {
    const block = this.#definition(name)
    if (this.#runs(name)) this.#change(this.#main(), main => withoutPlaces(main, name))
    this.#change(block, () => undefined)
    const isUsed = [...everyBlock(this.workspace)].some(
      ({type, extraState}) =>
        (type === "name" && extraState?.name === name) ||
        (type.startsWith("raw") &&
          new RegExp(`(?<![\\w'.])${name}(?![\\w'])`).test(String(extraState?.text))),
    )
    if (isUsed) refuse({kind: "used-elsewhere", function: name})
  }

  #rename(old: string, name: string): void {
    const block = this.#definition(old)
    const answer = rename(this.workspace, block.id ?? "", "name", name)
    if (!answer.ok) throw new Refused({kind: "does-not-fit", why: answer.why})
    this.workspace = mapExtras(this.workspace, new Map(answer.changes.map(c => [c.block, c.extra])))
  }

  #duplicate(old: string, name: string): void {
    this.#checkName(name)
    const alone = {...this.workspace, blocks: {languageVersion: 0, blocks: [this.#definition(old)]}}
    const answer = rename(alone, this.#definition(old).id ?? "", "name", name)
    if (!answer.ok) throw new Refused({kind: "does-not-fit", why: answer.why})
    const [copy] = mapExtras(alone, new Map(answer.changes.map(c => [c.block, c.extra]))).blocks.blocks
    if (copy !== undefined) this.#add(withoutIds(copy))
  }

  #join(block: SavedBlock): void {
    const main = this.#main()
    const reference = referenceTo(
      this.workspace,
      {block: main.id ?? "", input: "R0"},
      block.id ?? "",
      this.#session,
    )
    if (!reference.fits) throw new Refused({kind: "does-not-fit", why: reference.why})
    this.#change(main, before => withPlace(before, ref(String(block.extraState?.name))))
  }

  #leave(name: string): void {
    if (!this.#runs(name)) refuse({kind: "does-not-run", function: name})
    this.#change(this.#main(), main => withoutPlaces(main, name))
  }

  #runs(name: string): boolean {
    const main = this.#tops().find(({type}) => type === "main")
    return main !== undefined && isPlaced(main, name)
  }

  #checkName(name: string): void {
    if (!isVariableName(name) || reservedWords.has(name)) refuse({kind: "not-a-name", name})
    const defined = this.#tops().some(({extraState}) => extraState?.name === name)
    if (defined || name === "main") refuse({kind: "name-taken", name})
  }

  #tops(): readonly SavedBlock[] {
    return this.workspace.blocks.blocks.flatMap(chain)
  }

  #main(): SavedBlock {
    return this.#tops().find(({type}) => type === "main") ?? refuse({kind: "no-simulate"})
  }

  #definition(name: string): SavedBlock {
    const found = this.#tops().find(({type, extraState}) => type === "define" && extraState?.name === name)
    return found === undefined || found.extraState?.folded !== undefined
      ? refuse({kind: "no-such-function", function: name})
      : found
  }

  /// A function with the type that the program writes for it, or else the inferred one.
  #typed(name: string): TypedDefinition {
    const block = this.#definition(name)
    const written = block.extraState?.signature
    const scheme = this.inferred.globals.get(name)
    const isKnown = scheme !== undefined && metasIn(scheme.type).size === 0
    const signature =
      typeof written === "string" && written.trim() !== ""
        ? written
        : isKnown
          ? showScheme(scheme)
          : refuse({kind: "type-unknown", function: name})
    const parts = parseSignature(signature) === undefined ? undefined : signatureParts(signature)
    return {name, block, signature, parts: parts ?? refuse({kind: "type-unknown", function: name})}
  }

  #ownTypes(): OwnTypes {
    return new Map(
      this.#tops().flatMap(({type, extraState = {}}): [string, string | undefined][] => {
        if (type !== "data" || typeof extraState.name !== "string") return []
        const constructors = (extraState.constructors ?? []) as readonly {
          name: string
          fields?: readonly unknown[]
        }[]
        const [only, ...others] = constructors
        const isAlone = others.length === 0 && only !== undefined && (only.fields ?? []).length === 0
        return [[extraState.name, isAlone ? only.name : undefined]]
      }),
    )
  }

  /// The names that a new pattern of a function may not have.
  #names(block?: SavedBlock): Set<string> {
    const tops = this.#tops().map(
      ({type, extraState}): SavedBlock => ({type, ...(extraState && {extraState})}),
    )
    return namesUsed(block === undefined ? tops : [...tops, block])
  }

  readonly #meanings: TypeMeanings = {
    expanded: type => this.#expanded(type),
    leaves: type => this.#leaves([type]),
  }

  #expanded(type: string): string {
    const parsed = parseType(type)
    return parsed === undefined ? type.trim() : showType(expand(parsed, this.inferred.inference.env))
  }

  /// The types that some types are made of, without synonyms: the sides of `Either`, the parts of tuples, what `Maybe` and lists hold.
  #leaves(types: readonly string[]): readonly string[] {
    const inside = (type: Type): readonly Type[] => {
      const {head, args} = spine(type)
      const isShape = head.kind === "con" && /^(?:Either|Maybe|\[\]|\(,+\))$/.test(head.name)
      return isShape ? args.flatMap(inside) : [type]
    }
    return types
      .flatMap(type => parseType(type) ?? [])
      .flatMap(type => inside(expand(type, this.inferred.inference.env)))
      .map(type => showType(type))
  }

  /// Whether a type triggers a function, as an event of the robot or of the program (rule R1).
  #isEvent(type: string): boolean {
    const own = this.#ownTypes()
    const leaves = this.#leaves([type])
    return leaves.length > 0 && leaves.every(leaf => events.has(leaf) || own.has(leaf))
  }

  #add(block: SavedBlock): SavedBlock {
    const added = {...block, id: `network-edit-${this.#newId++}`}
    const {blocks} = this.workspace
    this.workspace = {...this.workspace, blocks: {...blocks, blocks: [...blocks.blocks, added]}}
    return added
  }

  /// Changes a definition where it stands, also below another one in a stack.
  #change(block: SavedBlock, change: (before: SavedBlock) => SavedBlock | undefined): void {
    const within = (top: SavedBlock): SavedBlock[] => {
      const below = top.next?.block
      const rest = below === undefined ? [] : within(below)
      const {next: _, ...alone} = top
      const now = top.id === block.id ? change(alone) : alone
      if (now === undefined) return rest
      const [first, ...others] = rest
      return [first === undefined ? now : {...now, next: {block: first}}, ...others]
    }
    const {blocks} = this.workspace
    this.workspace = {...this.workspace, blocks: {...blocks, blocks: blocks.blocks.flatMap(within)}}
  }
}

const side = (name: "Left" | "Right", pattern: SavedBlock | undefined): SavedBlock =>
  make("pattern_construct", {con: name, args: 1}, pattern === undefined ? {} : {A0: pattern})

/// How a new function reads in blocks.
function readingOf(sensor: string): string {
  if (sensor === "()") return "command"
  return events.has(sensor) ? "event" : states.has(sensor) ? "state" : "plain"
}

function withoutIds(block: SavedBlock): SavedBlock {
  return JSON.parse(JSON.stringify(block, (key, value) => (key === "id" ? undefined : value)))
}
