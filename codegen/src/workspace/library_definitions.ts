/// Definitions of the library's ready-made tasks, to be inserted into a program that wants to look inside.
///
/// Input: a workspace and a block that calls a ready-made task. Output: the definition of the task and of its helper functions as
/// blocks, read from the library's source by a build step (`scripts/definitions.ts`).

import {socketKey} from "../api.ts"
import {readTree, readWorkspace} from "../blocks/block_reader.ts"
import {blockView} from "../blocks/block_registry.ts"
import {printDeclarationAlone} from "../haskell/printer.ts"
import {freeInDeclaration, usesInExpr, usesInProgram} from "../model/name_resolution.ts"
import type {Declaration} from "../model/syntax_tree.ts"
import {uniqueName} from "../model/unique_name.ts"
import type {BlockId, Extra, SavedBlock, SavedInput, SavedWorkspace} from "../serialized_blocks.ts"
import {everyBlock, infer} from "./inference/workspace_inference.ts"
import {find} from "./moves/block_moves.ts"
import {generated} from "./toolbox/library_definitions.generated.ts"

export interface LibraryDefinition {
  readonly name: string
  readonly block: SavedBlock
  /// The definition of one input has no signature: it is written for the types of the call.
  readonly typedByCall?: boolean
}

/// What to insert so that a name of the library is defined in the program itself.
export interface LookInside {
  readonly name: string
  /// The definition of the name first, then its helper functions that the program does not have yet. Without ids.
  readonly definitions: readonly SavedBlock[]
}

const generatedDefinitions = generated as readonly LibraryDefinition[]
const definitions: ReadonlyMap<string, SavedBlock> = new Map(
  generatedDefinitions.map(({name, block}) => [name, block]),
)
const typedByCall: ReadonlySet<string> = new Set(
  generatedDefinitions.flatMap(one => (one.typedByCall === true ? one.name : [])),
)

/// The definitions behind a block, if the block calls a ready-made task and the program does not define that name itself. `undefined` as well
/// for a task whose type depends on its call, while that type is not known or another call has another.
export function lookInside(workspace: SavedWorkspace, id: BlockId): LookInside | undefined {
  const block = find(workspace, id)
  const name = block === undefined ? undefined : calledBy(block)
  if (name === undefined || !definitions.has(name)) return undefined
  const {program, loose} = readWorkspace(workspace)
  const uses = [
    ...usesInProgram(program.declarations),
    ...loose.flatMap(l => (l.kind === "expression" ? usesInExpr(l.expr) : [])),
  ]
  const isOwn = uses.some(use => use.name === name && use.node.from?.block === id && use.binder !== undefined)
  if (isOwn) return undefined
  const inserted = missing(name, program.declarations)
  if (!typedByCall.has(name)) return {name, definitions: inserted}
  const signature = signatureOfCalls(workspace, name)
  return signature === undefined
    ? undefined
    : {name, definitions: inserted.map(one => withSignature(one, name, signature))}
}

/// The program's own definition of the task that a block calls; `undefined` for a block that calls none, or one of the library.
export function ownDefinition(workspace: SavedWorkspace, id: BlockId): BlockId | undefined {
  const block = find(workspace, id)
  const name = block === undefined ? undefined : (calledBy(block) ?? block.extraState?.name)
  const {program} = readWorkspace(workspace)
  return program.declarations.find(d => d.kind === "function" && d.name === name)?.from?.block
}

/// The type of a function of one input, from its calls; `undefined` if it is not known or not the same in all of them.
function signatureOfCalls(workspace: SavedWorkspace, name: string): string | undefined {
  const {blocks, sockets} = infer(workspace)
  const types = [...everyBlock(workspace)].flatMap(block => {
    if (block.id === undefined || calledBy(block) !== name) return []
    const result = blocks.get(block.id)?.type
    const input = Object.keys(block.inputs ?? {})[0]
    if (block.type === "name" && block.extraState?.args === 0) return [result]
    const argument = input === undefined ? undefined : sockets.get(socketKey(block.id, input))?.type
    if (argument === undefined || result === undefined) return [undefined]
    return [`${argument.includes("->") ? `(${argument})` : argument} -> ${result}`]
  })
  const [type] = types
  const hasVariable = type === undefined || /\b[a-z]/.test(type)
  return hasVariable || types.some(other => other !== type) ? undefined : type
}

function withSignature(block: SavedBlock, name: string, signature: string): SavedBlock {
  return block.extraState?.name === name ? {...block, extraState: {...block.extraState, signature}} : block
}

function calledBy(block: SavedBlock): string | undefined {
  const {name} = block.extraState ?? {}
  if (block.type === "name") return typeof name === "string" ? name : undefined
  return name === undefined ? blockView(block.type)?.calls : undefined
}

/// A definition and its helper functions, without those that the program has in the same words. A helper gets another name
/// where the program uses its name for something else.
function missing(name: string, program: readonly Declaration[]): SavedBlock[] {
  const own = new Map(program.flatMap(d => (d.kind === "function" ? [[d.name, d] as const] : [])))
  const names = [name, ...helpers(name)]
  const renamed = new Map<string, string>()
  const wanted = names.filter(one => {
    const there = own.get(one)
    const block = definitions.get(one)
    if (there === undefined || block === undefined) return true
    if (printed(there) === declarationsOf(block).map(printed).join("\n")) return false
    renamed.set(one, uniqueName(one, new Set([...own.keys(), ...names])))
    return true
  })
  return wanted.flatMap(one => {
    const block = definitions.get(one)
    return block === undefined ? [] : [withNames(block, renamed)]
  })
}

/// The names of the library's source that a definition needs, directly or not. A function whose type depends on its call stays the library's.
function helpers(name: string, found: Set<string> = new Set()): Set<string> {
  const block = definitions.get(name)
  for (const needed of block === undefined
    ? []
    : declarationsOf(block).flatMap(d => [...freeInDeclaration(d)])) {
    if (needed === name || found.has(needed) || !definitions.has(needed) || typedByCall.has(needed)) continue
    found.add(needed)
    helpers(needed, found)
  }
  return found
}

function declarationsOf(block: SavedBlock): readonly Declaration[] {
  return readTree(block).declarations
}

function printed(declaration: Declaration): string {
  return printDeclarationAlone({...declaration, comment: undefined})
}

function withNames(block: SavedBlock, renamed: ReadonlyMap<string, string>): SavedBlock {
  if (renamed.size === 0) return block
  const {extraState, inputs, next} = block
  const name = typeof extraState?.name === "string" ? renamed.get(extraState.name) : undefined
  const extra: Extra | undefined =
    name !== undefined && (block.type === "define" || block.type === "name")
      ? {...extraState, name}
      : extraState
  const input = (one: SavedInput): SavedInput =>
    one.block === undefined ? one : {...one, block: withNames(one.block, renamed)}
  return {
    ...block,
    ...(extra === undefined ? {} : {extraState: extra}),
    ...(inputs === undefined
      ? {}
      : {inputs: Object.fromEntries(Object.entries(inputs).map(([key, one]) => [key, input(one)]))}),
    ...(next === undefined ? {} : {next: input(next)}),
  }
}
