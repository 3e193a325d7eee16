/// Unique names for definitions that are inserted twice: from the toolbox, duplicated or pasted. Two definitions of one name side by side would be read as one function
/// with several clauses.

import {type Extra, type Json, uniqueName} from "@rosy/codegen"
import type * as Blockly from "blockly/core"
import {change, extraOf, shapeOf} from "./block_definitions.ts"

/// `extra` of a definition or a type with names that are not taken: its own and those of its constructors and their parts. Pure.
export function withUniqueNames(extra: Extra, taken: ReadonlySet<string>): Extra {
  const renamed = parts(extra.constructors)?.map((one): Json => {
    const fields = parts(one.fields)?.map(field => named(field, taken))
    return {...named(one, taken), ...(fields === undefined ? {} : {fields})}
  })
  return {
    ...extra,
    ...(typeof extra.name === "string" ? {name: uniqueName(extra.name, taken)} : {}),
    ...(renamed === undefined ? {} : {constructors: renamed}),
  }
}

function named(one: Extra, taken: ReadonlySet<string>): Extra {
  return typeof one.name === "string" ? {...one, name: uniqueName(one.name, taken)} : one
}

/// The constructors of a type, or the parts of a constructor.
function parts(all: Json | undefined): readonly Extra[] | undefined {
  const isOne = (one: Json) => typeof one === "object" && one !== null && !Array.isArray(one)
  return Array.isArray(all) && all.every(isOne) ? (all as readonly Extra[]) : undefined
}

/// Gives the definitions among `made` names of their own.
export function giveUniqueNames(workspace: Blockly.WorkspaceSvg, made: ReadonlySet<string>): void {
  for (const id of made) {
    const block = workspace.getBlockById(id)
    if (block === null || !isDefinition(block) || block.isInsertionMarker()) continue
    const extra = extraOf(block)
    const wanted = withUniqueNames(extra, new Set(siblings(workspace, block).flatMap(namesOf)))
    if (JSON.stringify(wanted) !== JSON.stringify(extra)) change(block, wanted)
  }
}

function isDefinition(block: Blockly.Block): boolean {
  const as = shapeOf(block)?.connects.as
  return as === "definition" || as === "top"
}

/// The definitions that a block stands among: those of its `where` or `let`, or those of the program.
function siblings(workspace: Blockly.Workspace, block: Blockly.Block): readonly Blockly.Block[] {
  const parent = block.getSurroundParent()
  const all =
    parent === null
      ? workspace.getTopBlocks(false)
      : parent.getDescendants(false).filter(one => one.getSurroundParent() === parent)
  return all.filter(one => one !== block && isDefinition(one))
}

function namesOf(block: Blockly.Block): string[] {
  const extra = extraOf(block)
  const constructors = parts(extra.constructors) ?? []
  const fields = constructors.flatMap(one => parts(one.fields) ?? [])
  return [extra, ...constructors, ...fields].flatMap(({name}) => (typeof name === "string" ? [name] : []))
}
