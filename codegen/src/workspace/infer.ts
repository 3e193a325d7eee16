/// Types for a workspace: what each block is, what each socket wants, what is wrong.

import type {BlockProblem, Inference, TypeInfo} from "../api.ts"
import {socketKey} from "../api.ts"
import {blockView} from "../blocks/language.ts"
import type {ReadWorkspace} from "../blocks/read.ts"
import {readWorkspace} from "../blocks/read.ts"
import type {Declaration, Node, Origin, RawDeclaration} from "../model/tree.ts"
import type {SavedBlock, SavedWorkspace} from "../saved.ts"
import {withTexts} from "../types/brought.ts"
import type {Environment} from "../types/environment.ts"
import {Inferrer} from "../types/infer.ts"
import {library} from "../types/library.ts"
import type {Memo} from "../types/memo.ts"
import {withTypes} from "../types/own.ts"
import type {TypeProblem} from "../types/problems.ts"
import type {Scope} from "../types/scope.ts"
import {readTexts} from "../types/texts.ts"
import type {Meta} from "../types/type.ts"
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
  const raw = declarations.flatMap(d => (d.kind === "raw-declaration" ? [d] : []))
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
function inText(header: string, raw: readonly RawDeclaration[]): Environment {
  return header === "" && raw.length === 0
    ? library
    : withTexts(
        library,
        readTexts(
          header,
          raw.map(d => d.text),
        ),
      )
}

export function infer(workspace: SavedWorkspace): Inference {
  return inferenceOf(workspace, solve(workspace))
}

export function inferenceOf(workspace: SavedWorkspace, solved: Solved): Inference {
  const {inferrer} = solved
  const byId = new Map<string, SavedBlock>()
  for (const block of everyBlock(workspace)) if (block.id !== undefined) byId.set(block.id, block)
  const letters = new Map<Meta, string>()
  const blocks = new Map<string, TypeInfo>()
  const sockets = new Map<string, TypeInfo>()
  for (const [node, type] of inferrer.types) {
    const from = originOf(node)
    if (from === undefined) continue
    const as = node.kind === "wildcard" || node.kind.endsWith("-pattern") ? "pattern" : "value"
    const key = from.input === undefined ? undefined : socketKey(from.block, from.input)
    const known = key === undefined ? blocks.has(from.block) : sockets.has(key)
    if (known) continue
    const look = byId.get(from.block)
    const otherwise =
      key === undefined && look !== undefined
        ? blockView(look.type)?.shape(look.extraState ?? {}).family
        : undefined
    const info: TypeInfo = {
      type: showType(type, letters),
      family: familyOfType(type, as) ?? otherwise ?? "own",
    }
    if (key === undefined) blocks.set(from.block, info)
    else sockets.set(key, info)
  }
  for (const block of byId.values())
    for (const [input, child] of Object.entries(block.inputs ?? {})) {
      const inner = child.block?.id === undefined ? undefined : blocks.get(child.block.id)
      if (inner !== undefined && block.id !== undefined) sockets.set(socketKey(block.id, input), inner)
    }
  const definitions = new Map<string, {name: string; type: string; family: TypeInfo["family"]}>()
  for (const [d, scheme] of inferrer.schemes) {
    if (d.kind !== "function" || d.from === undefined) continue
    const look = byId.get(d.from.block)
    const shown = look === undefined ? undefined : blockView(look.type)?.shape(look.extraState ?? {}).family
    definitions.set(d.from.block, {
      name: d.name,
      type: d.signature?.text ?? showScheme(scheme),
      family:
        d.name === "main"
          ? "task"
          : shown !== undefined && shown !== "own"
            ? shown
            : (familyOfType(scheme.type, "value") ?? "own"),
    })
  }
  return {blocks, sockets, definitions, problems: problemsOf(solved)}
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
