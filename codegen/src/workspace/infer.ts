/// Types for a workspace: what each block is, what each socket wants, what is wrong.

import type {BlockProblem, Inference, TypeInfo} from "../api.ts"
import {socketKey} from "../api.ts"
import {blockView} from "../blocks/language.ts"
import type {ReadWorkspace} from "../blocks/read.ts"
import {chain, readWorkspace} from "../blocks/read.ts"
import {printDeclarationAlone} from "../haskell/print.ts"
import type {Declaration, InstanceDeclaration, Node, Origin, RawDeclaration} from "../model/tree.ts"
import type {SavedBlock, SavedWorkspace} from "../saved.ts"
import {withTexts} from "../types/brought.ts"
import type {Environment} from "../types/environment.ts"
import {Inferrer} from "../types/infer.ts"
import {library} from "../types/library.ts"
import type {Memo, Part} from "../types/memo.ts"
import {withTypes} from "../types/own.ts"
import type {TypeProblem} from "../types/problems.ts"
import type {Scope} from "../types/scope.ts"
import {readTexts} from "../types/texts.ts"
import type {Meta, Type} from "../types/type.ts"
import {showScheme, showType} from "../types/type.ts"
import {familyOfType, problemWords} from "../types/words.ts"
import {words} from "../words/index.ts"

export interface Solved {
  readonly read: ReadWorkspace
  readonly inferrer: Inferrer
  readonly globals: Scope
}

/// Reads and infers everything on the workspace, loose blocks too.
export function solve(workspace: SavedWorkspace): Solved {
  return solveRead(readWorkspace(workspace))
}

export function solveRead(read: ReadWorkspace, watch?: Origin, memo?: Memo): Solved {
  const declarations = read.program.declarations
  const types = declarations.filter(d => d.kind === "data" || d.kind === "synonym")
  const raw = declarations.filter(d => d.kind === "raw-declaration" || d.kind === "instance")
  const world = [...types, ...raw].map(d => memo?.numberOf(d)).join(" ") + (read.header ?? "")
  const known = memo?.worlds.get(world)
  // What a program's types must derive is found anew each time.
  const env =
    known === undefined
      ? withTypes(inText(read.header ?? "", raw), types)
      : {...known.env, needs: new Set<string>()}
  const inferrer = new Inferrer(env, memo, world)
  inferrer.watch = watch
  if (known === undefined) for (const d of types) inferrer.declaredTypes(d)
  else inferrer.problems.push(...known.problems)
  memo?.worlds.set(world, {env, problems: [...inferrer.problems]})
  const globals = inferrer.program(declarations)
  for (const l of read.loose)
    if (l.kind === "expression") inferrer.loose(l.expr, globals)
    else if (l.kind === "pattern") inferrer.loosePattern(l.pattern)
    else inferrer.looseStatements(l.steps, globals)
  return {read, inferrer, globals}
}

/// The library with what text brings into scope; most programs have no such text.
function inText(header: string, raw: readonly (RawDeclaration | InstanceDeclaration)[]): Environment {
  return header === "" && raw.length === 0
    ? library
    : withTexts(
        library,
        readTexts(
          header,
          raw.map(d => (d.kind === "raw-declaration" ? d.text : printDeclarationAlone(d))),
        ),
      )
}

export function infer(workspace: SavedWorkspace): Inference {
  return inferenceOf(workspace, solve(workspace))
}

/// What is shown of the types in a group of definitions, or in loose blocks.
interface Shown {
  readonly blocks: ReadonlyMap<string, TypeInfo>
  readonly sockets: ReadonlyMap<string, TypeInfo>
}

/// What was shown of groups that inference remembers; theirs does not change.
export type KnownParts = WeakMap<Part, Shown>

export function inferenceOf(
  workspace: SavedWorkspace,
  solved: Solved,
  known: KnownParts = new WeakMap(),
): Inference {
  const {inferrer} = solved
  const byId = new Map<string, SavedBlock>()
  for (const block of definitionsIn(workspace)) if (block.id !== undefined) byId.set(block.id, block)
  const shown = inferrer.parts.map(part => {
    const before = known.get(part)
    if (before !== undefined) return before
    const made = shownOf(
      part.types,
      part.members.flatMap(d => [...partsOf(d.from === undefined ? undefined : byId.get(d.from.block))]),
    )
    known.set(part, made)
    return made
  })
  const grouped = new Set(inferrer.parts.flatMap(part => part.members.flatMap(d => d.from?.block ?? [])))
  const rest = definitionsIn(workspace).filter(b => b.id === undefined || !grouped.has(b.id))
  shown.push(
    shownOf(
      inferrer.others,
      rest.flatMap(b => [...partsOf(b)]),
    ),
  )
  const blocks = new Map<string, TypeInfo>()
  const sockets = new Map<string, TypeInfo>()
  for (const part of shown) {
    for (const [block, info] of part.blocks) blocks.set(block, info)
    for (const [socket, info] of part.sockets) sockets.set(socket, info)
  }
  const definitions = new Map<string, {name: string; type: string; family: TypeInfo["family"]}>()
  for (const [d, scheme] of inferrer.schemes) {
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
    inferrer.parts.flatMap((part, i) =>
      part.members.flatMap(d => (d.from === undefined ? [] : [[d.from.block, shown[i] as Shown] as const])),
    ),
  )
  return {blocks, sockets, definitions, problems: problemsOf(solved), stamps}
}

function shownOf(types: ReadonlyMap<Node, Type>, within: readonly SavedBlock[]): Shown {
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
  return blockView(block.type)?.shape(block.extraState ?? {}).family
}

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
export function problemsOf({read, inferrer}: Solved): BlockProblem[] {
  return [
    ...read.problems,
    ...inferrer.problems.map(problemOf),
    ...duplicates(read.program.declarations),
    ...entry(read),
  ]
}

function problemOf(problem: TypeProblem): BlockProblem {
  const from = originOf(problem.node)
  const said = problemWords(problem, whatIs(problem.node))
  return {severity: "error", ...said, block: from?.block, input: from?.input}
}

/// A node's own word, for messages.
export function whatIs(node: Node): string {
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
      return whatIs(node.fn)
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
function duplicates(declarations: readonly Declaration[]): BlockProblem[] {
  const seen = new Set<string>()
  return declarations.flatMap((d): BlockProblem[] => {
    if (d.kind !== "data" && d.kind !== "synonym") return []
    // Cases of one type may share a part.
    const names =
      d.kind === "data"
        ? [
            `type ${d.name}`,
            ...d.constructors.map(c => c.name),
            ...new Set(d.constructors.flatMap(c => c.fields.flatMap(f => f.name ?? []))),
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
