/// Types and problems of a workspace: of each block, socket and definition.

import type {BlockProblem, Inference, InferredTypes, TypeInfo} from "../../api.ts"
import {socketKey} from "../../api.ts"
import type {ReadWorkspace} from "../../blocks/block_reader.ts"
import {chain, readWorkspace} from "../../blocks/block_reader.ts"
import {blockView} from "../../blocks/block_registry.ts"
import {printDeclarationAlone} from "../../haskell/printer.ts"
import type {
  DataDeclaration,
  Declaration,
  InstanceDeclaration,
  Node,
  Origin,
  RawDeclaration,
  SynonymDeclaration,
} from "../../model/syntax_tree.ts"
import type {BlockId, SavedBlock, SavedWorkspace} from "../../serialized_blocks.ts"
import {scanDeclarations} from "../../types/environment/declaration_scanner.ts"
import {withDeclaredTypes} from "../../types/environment/declared_types.ts"
import type {Environment} from "../../types/environment/environment.ts"
import {withImportedNames} from "../../types/environment/import_environment.ts"
import {library} from "../../types/environment/standard_library.ts"
import {
  checkDeclaredTypes,
  createInference,
  inferLooseExpression,
  inferLoosePattern,
  inferLooseStatements,
  inferProgram,
} from "../../types/inference.ts"
import type {InferenceCache, InferredGroup} from "../../types/inference_cache.ts"
import type {InferenceState} from "../../types/inference_state.ts"
import {inferWithinBounds} from "../../types/inference_state.ts"
import type {Scope} from "../../types/syntax/scope.ts"
import type {Meta, Type} from "../../types/syntax/type.ts"
import {showScheme, showType} from "../../types/syntax/type.ts"
import type {TypeProblem} from "../../types/syntax/type_problems.ts"
import {words} from "../../words/index.ts"
import {conflictProblems} from "./command_conflicts.ts"
import {LayeredMap} from "./layered_map.ts"
import {familyOfType, problemMessage} from "./type_messages.ts"

export interface InferredWorkspace {
  readonly read: ReadWorkspace
  readonly inference: InferenceState
  readonly globals: Scope
}

/// What is asked of an inference besides types and problems.
export interface InferenceQuestion {
  /// An empty socket whose scope and type are wanted.
  readonly watch?: Origin | undefined
  /// A block whose own type is kept apart from the one that its place wants.
  readonly apart?: BlockId | undefined
}

/// Reads and infers everything on the workspace, loose blocks too.
export function inferWorkspace(workspace: SavedWorkspace): InferredWorkspace {
  return inferModel(readWorkspace(workspace))
}

export function inferModel(
  read: ReadWorkspace,
  {watch, apart, cache}: InferenceQuestion & {readonly cache?: InferenceCache} = {},
): InferredWorkspace {
  const declarations = read.program.declarations
  const types = declarations.filter(d => d.kind === "data" || d.kind === "synonym")
  const raw = declarations.filter(d => d.kind === "raw-declaration" || d.kind === "instance")
  const typesKey = [...types, ...raw].map(d => cache?.numberOf(d)).join(" ") + (read.header ?? "")
  const known = cache?.ownTypes.get(typesKey)
  // What a program's types must derive is found anew each time.
  const env =
    known === undefined
      ? withDeclaredTypes(inText(read.header ?? "", raw, types), types)
      : {...known.env, needs: new Set<string>(), assumed: []}
  const inference = createInference(env, {...(cache === undefined ? {} : {cache}), typesKey, watch, apart})
  if (known === undefined)
    for (const d of types) inferWithinBounds(inference, () => checkDeclaredTypes(inference, d))
  else inference.problems.push(...known.problems)
  cache?.ownTypes.set(typesKey, {env, problems: [...inference.problems]})
  const globals = inferProgram(inference, declarations)
  for (const l of read.loose)
    inferWithinBounds(inference, () => {
      if (l.kind === "expression") inferLooseExpression(inference, l.expr, globals)
      else if (l.kind === "pattern") inferLoosePattern(inference, l.pattern)
      else inferLooseStatements(inference, l.steps, globals)
    })
  return {read, inference, globals}
}

/// The library with what text brings into scope; most programs have no such text.
function inText(
  header: string,
  raw: readonly (RawDeclaration | InstanceDeclaration)[],
  types: readonly (DataDeclaration | SynonymDeclaration)[],
): Environment {
  return header === "" && raw.length === 0
    ? library
    : withImportedNames(
        library,
        scanDeclarations(
          header,
          raw.map(d => (d.kind === "raw-declaration" ? d.text : printDeclarationAlone(d))),
        ),
        types.map(d => d.name),
      )
}

export function infer(workspace: SavedWorkspace): Inference {
  return inferenceOf(workspace, inferWorkspace(workspace))
}

/// What was shown of groups that inference remembers; theirs does not change.
export type KnownGroups = WeakMap<InferredGroup, InferredTypes>

export function inferenceOf(
  workspace: SavedWorkspace,
  solved: InferredWorkspace,
  known: KnownGroups = new WeakMap(),
): Inference {
  const {inference} = solved
  const byId = new Map<string, SavedBlock>()
  for (const block of definitionsIn(workspace)) if (block.id !== undefined) byId.set(block.id, block)
  const shown = inference.groups.map(part => {
    const before = known.get(part)
    if (before !== undefined) return before
    const made = shownOf(
      part.types,
      part.members.flatMap(d => [...partsOf(d.from === undefined ? undefined : byId.get(d.from.block))]),
    )
    known.set(part, made)
    return made
  })
  const grouped = new Set(inference.groups.flatMap(part => part.members.flatMap(d => d.from?.block ?? [])))
  const rest = definitionsIn(workspace).filter(b => b.id === undefined || !grouped.has(b.id))
  shown.push(
    shownOf(
      inference.found,
      rest.flatMap(b => [...partsOf(b)]),
    ),
  )
  const blocks = new LayeredMap(shown.map(part => part.blocks))
  const sockets = new LayeredMap(shown.map(part => part.sockets))
  const definitions = new Map<string, {name: string; type: string; family: TypeInfo["family"]}>()
  for (const [d, scheme] of inference.schemes) {
    if (d.kind !== "function" || d.from === undefined) continue
    const look = byId.get(d.from.block)
    const family = look === undefined ? undefined : familyOfBlock(look)
    definitions.set(d.from.block, {
      name: d.name,
      type: d.signature?.text ?? showScheme(scheme),
      family:
        d.name === "main"
          ? "task"
          : family !== undefined && family !== "own"
            ? family
            : (familyOfType(scheme.type, "value") ?? "own"),
    })
  }
  const stamps = new Map(
    inference.groups.flatMap((part, i) =>
      part.members.flatMap(d =>
        d.from === undefined ? [] : [[d.from.block, shown[i] as InferredTypes] as const],
      ),
    ),
  )
  return {blocks, sockets, definitions, problems: problemsOf(solved), stamps}
}

function shownOf(types: ReadonlyMap<Node, Type>, within: readonly SavedBlock[]): InferredTypes {
  const byId = new Map(within.map(block => [block.id, block]))
  const letters = new Map<Meta, string>()
  const blocks = new Map<string, TypeInfo>()
  const sockets = new Map<string, TypeInfo>()
  for (const [node, type] of types) {
    const from = originOf(node)
    if (from === undefined) continue
    const as = node.kind === "wildcard" || node.kind.endsWith("-pattern") ? "pattern" : "value"
    const key = from.input === undefined ? undefined : socketKey(from.block, from.input)
    if (key === undefined ? blocks.has(from.block) : sockets.has(key)) continue
    const look = byId.get(from.block)
    const otherwise = key === undefined && look !== undefined ? familyOfBlock(look) : undefined
    const info: TypeInfo = {
      type: showType(type, letters),
      family: familyOfType(type, as) ?? otherwise ?? "own",
    }
    if (key === undefined) blocks.set(from.block, info)
    else sockets.set(key, info)
  }
  for (const block of within)
    for (const [input, child] of Object.entries(block.inputs ?? {})) {
      const inner = child.block?.id === undefined ? undefined : blocks.get(child.block.id)
      if (inner !== undefined && block.id !== undefined) sockets.set(socketKey(block.id, input), inner)
    }
  return {blocks, sockets}
}

function familyOfBlock(block: SavedBlock): TypeInfo["family"] | undefined {
  if (!families.has(block)) families.set(block, blockView(block.type)?.shape(block.extraState ?? {}).family)
  return families.get(block)
}

/// A saved block does not change.
const families = new WeakMap<SavedBlock, TypeInfo["family"] | undefined>()

/// The blocks of a workspace that stand for themselves: the top-level ones, and those below them in a stack.
function definitionsIn(workspace: SavedWorkspace): readonly SavedBlock[] {
  return workspace.blocks.blocks.flatMap(chain)
}

/// A block and all in it, without what stands below it.
function* partsOf(block: SavedBlock | undefined): Generator<SavedBlock> {
  if (block === undefined) return
  yield block
  for (const {block: inside, shadow} of Object.values(block.inputs ?? {}))
    for (const child of [inside, shadow]) if (child !== undefined) yield* everyBlockIn(child)
}

/// Everything a learner must know about a workspace.
export function problemsOf(solved: InferredWorkspace): BlockProblem[] {
  const {read, inference} = solved
  return [
    ...read.problems,
    ...inference.problems.map(problemOf),
    ...duplicates(read.program.declarations, inference.env),
    ...entry(read),
    ...conflictProblems(solved),
  ]
}

function problemOf(problem: TypeProblem): BlockProblem {
  const known = messages.get(problem)
  if (known?.of === words) return known.as
  const from = originOf(problem.node)
  const message = problemMessage(problem, describeNode(problem.node))
  const as: BlockProblem = {severity: "error", ...message, block: from?.block, input: from?.input}
  messages.set(problem, {of: words, as})
  return as
}

/// Messages of problems, and in which language: inference remembers those of definitions that stay the same.
const messages = new WeakMap<TypeProblem, {readonly of: typeof words; readonly as: BlockProblem}>()

/// A node's own word, for messages.
export function describeNode(node: Node): string {
  switch (node.kind) {
    case "variable":
    case "constructor-name":
    case "name-pattern":
    case "constructor-pattern":
      return `\`${node.name}\``
    case "number":
    case "number-pattern":
      return `\`${node.text}\``
    case "string":
      return words.program.thisText
    case "apply":
      return describeNode(node.fn)
    case "infix":
    case "section":
      return `\`${node.op}\``
    default:
      return words.program.this
  }
}

function originOf(node: Node): Origin | undefined {
  return node.kind === "program" ? undefined : node.from
}

/// Types that are declared twice; definitions of values are inference's to compare.
function duplicates(declarations: readonly Declaration[], env: Environment): BlockProblem[] {
  const seen = new Set<string>()
  const mayShareFields = env.extensions?.has("DuplicateRecordFields") === true
  return declarations.flatMap((d): BlockProblem[] => {
    if (d.kind !== "data" && d.kind !== "synonym") return []
    // Cases of one type may share a part.
    const names =
      d.kind === "data"
        ? [
            `type ${d.name}`,
            ...d.constructors.map(c => c.name),
            ...new Set(
              mayShareFields ? [] : d.constructors.flatMap(c => c.fields.flatMap(f => f.name ?? [])),
            ),
          ]
        : [`type ${d.name}`]
    const twice = names.filter(n => seen.has(n))
    for (const n of names) seen.add(n)
    return twice.map(n => ({
      severity: "error",
      kind: "duplicate",
      block: d.from?.block,
      message: words.program.thereAreTwoDefinitions(n.replace("type ", "")),
      hint: words.program.giveOneOfThemAnotherName,
    }))
  })
}

function entry(read: ReadWorkspace): BlockProblem[] {
  const has = read.program.declarations.some(
    d =>
      (d.kind === "function" && d.name === "main") ||
      (d.kind === "raw-declaration" && /^main\b/m.test(d.text)),
  )
  return has
    ? []
    : [
        {
          severity: "error",
          kind: "no-main",
          block: undefined,
          message: words.program.theProgramDoesNotSayWhat,
          hint: words.program.addASimulateBlock,
        },
      ]
}

/// All blocks of a workspace, parents before children.
export function* everyBlock(workspace: SavedWorkspace): Generator<SavedBlock> {
  for (const block of workspace.blocks.blocks) yield* everyBlockIn(block)
}

export function* everyBlockIn(first: SavedBlock): Generator<SavedBlock> {
  const todo = [first]
  for (let block = todo.pop(); block !== undefined; block = todo.pop()) {
    yield block
    if (block.next?.block !== undefined) todo.push(block.next.block)
    for (const input of Object.values(block.inputs ?? {}).reverse())
      for (const child of [input.block, input.shadow]) if (child !== undefined) todo.push(child)
  }
}
