/// One item of the toolbox: a label, a block, and other words by which the search finds it.

import type {ToolboxItem} from "../../api.ts"
import {choices, valueLabel} from "../../blocks/spec/constructor_labels.ts"
import type {SavedBlock} from "../../serialized_blocks.ts"
import {words} from "../../words/index.ts"

export function item(label: string, block: SavedBlock): ToolboxItem {
  const also = alsoFor(block)
  const names = namesOf(block)
  return {label, block, ...(also === "" ? {} : {also}), ...(names === undefined ? {} : {names})}
}

/// Other names of the thing that a command is about; none for the command as a function.
function namesOf({type, extraState}: SavedBlock): string | undefined {
  const known: {readonly [command: string]: string} = words.toolbox.names
  const command = extraState?.con
  const isValue = type === "construct" && extraState?.args !== 0
  return isValue && typeof command === "string" && Object.hasOwn(known, command) ? known[command] : undefined
}

/// Other words for what a block and those in it are about, and all that their menus offer, in Haskell and in words.
function alsoFor(block: SavedBlock): string {
  const known: {readonly [about: string]: string} = words.toolbox.also
  const {con, of, name} = block.extraState ?? {}
  const own = [block.type, con, of, name].flatMap(about =>
    typeof about === "string" && Object.hasOwn(known, about) ? [known[about]] : [],
  )
  const names = namesOf(block) ?? ""
  const inMenu =
    typeof of === "string"
      ? (choices[of]?.options ?? []).flatMap(value => [value, valueLabel(of, value)])
      : []
  const inside = [...Object.values(block.inputs ?? {}), block.next].flatMap(input =>
    input?.block === undefined ? [] : [alsoFor(input.block)],
  )
  return [names, ...own, ...inMenu, ...inside].filter(found => found !== "").join(" ")
}
