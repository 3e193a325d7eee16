/// Renaming of types, constructors and fields.

import type {Renaming} from "../../api.ts"
import {setIn} from "../../block_shape.ts"
import {readWorkspace} from "../../blocks/block_reader.ts"
import {isConstructorName, isVariableName} from "../../haskell/lexemes.ts"
import type {BlockId, Extra, Json, SavedBlock, SavedWorkspace} from "../../serialized_blocks.ts"
import {words} from "../../words/index.ts"
import {everyBlock} from "../inference/workspace_inference.ts"
import {mapExtras, moved, replaceWord, textAt, unlessWrong, usesIn} from "./renaming_changes.ts"

/// A constructor of a data type, or a field of one, and every block that says its name.
export function renamePart(workspace: SavedWorkspace, data: SavedBlock, key: string, name: string): Renaming {
  const old = textAt(data.extraState ?? {}, key)
  const isConstructor = /^constructors\.\d+\.name$/.test(key)
  if (isConstructor && !isConstructorName(name))
    return {ok: false, why: words.renaming.thisNameIsOneWordThatStarts}
  if (!isConstructor && !isVariableName(name))
    return {ok: false, why: words.renaming.aNameIsOneWordThatStarts}
  const {program} = readWorkspace(workspace)
  const taken = program.declarations.some(
    d =>
      (d.kind === "function" && d.name === name) ||
      (d.kind === "data" && d.constructors.some(c => c.name === name || c.fields.some(f => f.name === name))),
  )
  if (taken && name !== old) return {ok: false, why: words.renaming.thereIsAnotherAlready(name)}
  const changes = new Map<BlockId, Extra>()
  const before = usesIn(workspace)
  // Blocks whose name is bound nearer by, and only reads like the field's.
  const others = new Set(
    before.filter(u => u.name === old && u.binder !== undefined).map(u => u.node.from?.block),
  )
  for (const b of everyBlock(workspace)) {
    if (b.id === undefined) continue
    const extra = b.extraState ?? {}
    const next =
      b.id === data.id
        ? setIn(extra, key, name)
        : b.type === "name" && others.has(b.id)
          ? extra
          : renamedPart(b, extra, String(old), name, isConstructor)
    if (JSON.stringify(next) !== JSON.stringify(extra)) changes.set(b.id, next)
  }
  const renamed = mapExtras(workspace, changes)
  return moved(before, usesIn(renamed))
    ? {ok: false, why: words.renaming.alreadyMeansSomethingElseWhereThisName(name)}
    : unlessWrong(workspace, renamed, changes, name)
}

function renamedPart(b: SavedBlock, extra: Extra, old: string, name: string, isConstructor: boolean): Extra {
  const {fields, text} = extra
  return {
    ...extra,
    ...(isConstructor && extra.con === old ? {con: name} : {}),
    ...(b.type === "name" && extra.name === old ? {name} : {}),
    ...(!isConstructor && Array.isArray(fields) ? {fields: fields.map(f => (f === old ? name : f))} : {}),
    ...(b.type.startsWith("raw_") && typeof text === "string" ? {text: replaceWord(text, old, name)} : {}),
  }
}

/// A type, and every type that is written somewhere and says its name.
export function renameType(workspace: SavedWorkspace, block: SavedBlock, name: string): Renaming {
  const old = textAt(block.extraState ?? {}, "name")
  if (!isConstructorName(name)) return {ok: false, why: words.renaming.thisNameIsOneWordThatStarts}
  const {declarations} = readWorkspace(workspace).program
  const taken = declarations.some(d => (d.kind === "data" || d.kind === "synonym") && d.name === name)
  if (taken && name !== old) return {ok: false, why: words.renaming.thereIsAnotherAlready(name)}
  // Haskell of the program's own says types and constructors alike.
  const alike = declarations.some(d => d.kind === "data" && d.constructors.some(c => c.name === old))
  const changes = new Map<BlockId, Extra>()
  for (const b of everyBlock(workspace)) {
    if (b.id === undefined) continue
    const extra = b.extraState ?? {}
    const next = b.id === block.id ? setIn(extra, "name", name) : extra
    const renamed = renamedTypes(b.type, next, String(old), name, alike) as Extra
    if (JSON.stringify(renamed) !== JSON.stringify(extra)) changes.set(b.id, renamed)
  }
  return unlessWrong(workspace, mapExtras(workspace, changes), changes, name)
}

/// What a block says about itself, with a type's new name wherever a type is written.
function renamedTypes(kind: string, json: Json, old: string, name: string, alike: boolean): Json {
  if (Array.isArray(json)) return json.map(one => renamedTypes(kind, one, old, name, alike))
  if (typeof json !== "object" || json === null) return json
  return Object.fromEntries(
    Object.entries(json).map(([key, value]) => {
      const isType =
        key === "type" ||
        key === "signature" ||
        key === "head" ||
        (key === "text" && (kind === "raw_type" || (kind.startsWith("raw_") && !alike)))
      if (isType && typeof value === "string") return [key, replaceWord(value, old, name)]
      return [key, value === undefined ? value : renamedTypes(kind, value, old, name, alike)]
    }),
  ) as Extra
}
