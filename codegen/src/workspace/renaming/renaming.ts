/// Renaming of a name with all its references.

import type {Renaming} from "../../api.ts"
import {setIn} from "../../block_shape.ts"
import {chain, readWorkspace} from "../../blocks/block_reader.ts"
import {blockView} from "../../blocks/block_registry.ts"
import {declarationTextOf, withDeclarationText} from "../../blocks/families/text_declarations.ts"
import {fold, unfold} from "../../blocks/folding.ts"
import {isOperator, isVariableName, reservedWords} from "../../haskell/lexemes.ts"
import {nameOf} from "../../model/bound_names.ts"
import type {Use} from "../../model/name_resolution.ts"
import type {Declaration} from "../../model/syntax_tree.ts"
import type {BlockId, Extra, SavedWorkspace} from "../../serialized_blocks.ts"
import {renamedInDirective} from "../../source/directives.ts"
import {words} from "../../words/index.ts"
import {everyBlock, everyBlockIn} from "../inference/workspace_inference.ts"
import {find} from "../moves/block_moves.ts"
import {binderBlock, mapExtras, moved, replaceWord, textAt, unlessWrong, usesIn} from "./renaming_changes.ts"
import {renamePart, renameType} from "./type_renaming.ts"

/// Renames what a block defines or names, at `key` of its `extraState`, and every block that refers to it.
export function rename(workspace: SavedWorkspace, block: BlockId, key: string, name: string): Renaming {
  return overFolds(workspace, open => renameDrawn(open, block, key, name))
}

/// A renaming in a workspace without folds, as changes of the blocks that hold the folded ones.
function overFolds(workspace: SavedWorkspace, renaming: (open: SavedWorkspace) => Renaming): Renaming {
  if (![...everyBlock(workspace)].some(b => b.extraState?.folded !== undefined)) return renaming(workspace)
  const open = {...workspace, blocks: {...workspace.blocks, blocks: workspace.blocks.blocks.map(unfold)}}
  const result = renaming(open)
  if (!result.ok) return result
  const renamed = mapExtras(open, new Map(result.changes.map(c => [c.block, c.extra])))
  const after = new Map<BlockId, Extra>()
  for (const top of renamed.blocks.blocks)
    for (const b of everyBlockIn(fold(top, blockView)))
      if (b.id !== undefined && b.extraState !== undefined) after.set(b.id, b.extraState)
  const changes: {block: BlockId; extra: Extra}[] = []
  for (const b of everyBlock(workspace)) {
    const extra = b.id === undefined ? undefined : after.get(b.id)
    if (b.id !== undefined && extra !== undefined && JSON.stringify(extra) !== JSON.stringify(b.extraState))
      changes.push({block: b.id, extra})
  }
  return {ok: true, changes}
}

function renameDrawn(workspace: SavedWorkspace, block: BlockId, key: string, name: string): Renaming {
  const binder = find(workspace, block)
  if (binder === undefined) return {ok: false, why: words.renaming.thisBlockIsGone}
  if (key === "name" && (binder.type === "data" || binder.type === "synonym"))
    return renameType(workspace, binder, name)
  if (binder.type === "data") return renamePart(workspace, binder, key, name)
  if (reservedWords.has(name)) return {ok: false, why: words.renaming.isOneOfHaskellsOwnWords(name)}
  // Only what is defined may be an operator; a pattern gives names.
  if (!isVariableName(name) && !(isOperator(name) && binder.type === "define"))
    return {ok: false, why: words.renaming.aNameIsOneWordThatStarts}
  const old = textAt(binder.extraState ?? {}, key)
  const changes = new Map<BlockId, Extra>([[block, setIn(binder.extraState ?? {}, key, name)]])
  const before = usesIn(workspace)
  for (const use of before) {
    const user = use.node.from?.block
    if (user === undefined || use.name !== old || binderBlock(use) !== block) continue
    const node = find(workspace, user)
    if (node !== undefined)
      changes.set(user, renameUse(changes.get(user) ?? node.extraState ?? {}, use, name))
  }
  // Signatures, fixity declarations and pragmas that are kept as text stand beside the definition at the top level.
  if (workspace.blocks.blocks.some(top => chain(top).some(b => b.id === block)))
    for (const directive of workspace.blocks.blocks.flatMap(chain)) {
      const {id, type, extraState = {}} = directive
      const text = declarationTextOf(type, extraState)
      const next = text === undefined ? undefined : renamedInDirective(text, String(old), name)
      if (id === undefined || next === undefined || next === text) continue
      const extra = withDeclarationText(type, extraState, next)
      if (extra !== undefined) changes.set(id, extra)
    }
  const renamed = mapExtras(workspace, changes)
  if (moved(before, usesIn(renamed)))
    return {ok: false, why: words.renaming.alreadyMeansSomethingElseWhereThisName(name)}
  if (definedTwice(renamed, name))
    return {ok: false, why: words.renaming.thereIsAnotherDefinitionCalled(name)}
  return unlessWrong(workspace, renamed, changes, name)
}

/// Renames what a block names or defines, wherever it says so: what F2 does in the text. Answers like `rename`.
export function renameNamed(workspace: SavedWorkspace, block: BlockId, old: string, name: string): Renaming {
  return overFolds(workspace, open => renameNamedDrawn(open, block, old, name))
}

function renameNamedDrawn(workspace: SavedWorkspace, block: BlockId, old: string, name: string): Renaming {
  const use = usesIn(workspace).find(u => u.node.from?.block === block && u.name === old)
  const binder = use === undefined ? block : binderBlock(use)
  if (binder === undefined) return {ok: false, why: words.renaming.isNotOfThisProgramSo(old)}
  const found = find(workspace, binder)
  const key = keyOf(found?.extraState ?? {}, old)
  if (found?.type === "data" && key === "name")
    return {ok: false, why: words.renaming.aTypeIsRenamedInItsBlock}
  if (key === undefined) {
    const made = [...everyBlock(workspace)].find(
      b => b.type === "data" && b.id !== undefined && keyOf(b.extraState ?? {}, old) !== undefined,
    )
    const part = made === undefined ? undefined : keyOf(made.extraState ?? {}, old)
    if (made?.id === undefined || part === undefined || part === "name")
      return {ok: false, why: words.renaming.cannotBeRenamedFrom(old)}
    return renameDrawn(workspace, made.id, part, name)
  }
  return renameDrawn(workspace, binder, key, name)
}

/// The path in `extraState` at which a name stands that the block brings into scope.
function keyOf(extra: Extra, name: string, path = ""): string | undefined {
  for (const [key, value] of Object.entries(extra)) {
    const here = `${path}${key}`
    if (value === name && (key === "name" || /^(?:\d+|as)$/.test(key))) return here
    if (typeof value === "object" && value !== null) {
      const inner = keyOf(value as Extra, name, `${here}.`)
      if (inner !== undefined) return inner
    }
  }
  return undefined
}

function renameUse(extra: Extra, use: Use, name: string): Extra {
  if (use.node.kind === "raw") return setIn(extra, "text", replaceWord(use.node.text, use.name, name))
  return setIn(extra, use.node.kind === "infix" || use.node.kind === "section" ? "op" : "name", name)
}

function definedTwice(workspace: SavedWorkspace, name: string): boolean {
  const {program} = readWorkspace(workspace)
  const defines = (d: Declaration) => d.kind === "function" && nameOf(d) === name
  return program.declarations.filter(defines).length > 1
}
