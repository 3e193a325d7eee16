/// Uses of names and changes of blocks in a renaming, and the check that the changes keep every meaning.

import type {Renaming} from "../../api.ts"
import {readWorkspace} from "../../blocks/block_reader.ts"
import type {Use} from "../../model/name_resolution.ts"
import {usesInExpr, usesInProgram} from "../../model/name_resolution.ts"
import type {BlockId, Extra, Json, SavedWorkspace} from "../../serialized_blocks.ts"
import {words} from "../../words/index.ts"
import {foreignMethodMessage} from "../inference/type_messages.ts"
import {everyBlock, inferWorkspace} from "../inference/workspace_inference.ts"

/// Whether a use means another binder than before.
export function moved(before: readonly Use[], after: readonly Use[]): boolean {
  return (
    before.length !== after.length ||
    after.some(
      (use, i) => binderBlock(use) !== (before[i] === undefined ? undefined : binderBlock(before[i])),
    )
  )
}

/// The changes, unless the program would have a problem that it does not have now.
export function unlessWrong(
  before: SavedWorkspace,
  after: SavedWorkspace,
  changes: ReadonlyMap<BlockId, Extra>,
  name: string,
): Renaming {
  const problems = inferWorkspace(after).inference.problems
  if (problems.length > inferWorkspace(before).inference.problems.length) {
    if (problems.some(p => p.kind === "taken" && p.name === name))
      return {ok: false, why: words.renaming.haskellItselfHasAAlready(name)}
    const foreign = problems.find(p => p.kind === "no-method" && p.name === name)
    if (foreign?.kind === "no-method") return {ok: false, why: foreignMethodMessage(foreign)}
    return {ok: false, why: words.renaming.thereIsAnotherAlready(name)}
  }
  return {ok: true, changes: [...changes].map(([block, extra]) => ({block, extra}))}
}

export function replaceWord(text: string, old: string, name: string): string {
  return text.replace(/(?<![\p{L}\p{N}_'])[\p{L}_][\p{L}\p{N}_']*/gu, word => (word === old ? name : word))
}

export function binderBlock(use: Use): BlockId | undefined {
  return use.binder?.from?.block
}

export function mapExtras(workspace: SavedWorkspace, changes: ReadonlyMap<BlockId, Extra>): SavedWorkspace {
  const copy = structuredClone(workspace)
  for (const b of everyBlock(copy)) {
    const extra = b.id === undefined ? undefined : changes.get(b.id)
    if (extra !== undefined) b.extraState = extra
  }
  return copy
}

export function textAt(extra: Extra, key: string): Json | undefined {
  let at: Json | undefined = extra
  for (const step of key.split(".")) at = (at as Extra | undefined)?.[step]
  return at
}

export function usesIn(workspace: SavedWorkspace): Use[] {
  const {program, loose} = readWorkspace(workspace)
  return [
    ...usesInProgram(program.declarations),
    ...loose.flatMap(l => (l.kind === "expression" ? usesInExpr(l.expr) : [])),
  ]
}
