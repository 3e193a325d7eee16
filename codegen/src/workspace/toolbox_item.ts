/// One item of the toolbox: a label, a block, and other words by which the search finds it.

import type {ToolboxItem} from "../api.ts"
import {choices, valueLabel} from "../blocks/constructor_labels.ts"
import type {SavedBlock} from "../serialized_blocks.ts"
import {words} from "../words/index.ts"

export function item(label: string, block: SavedBlock): ToolboxItem {
  const also = alsoFor(block)
  return {label, block, ...(also === "" ? {} : {also})}
}

/// Other words for what a block and those in it are about, and all that their menus offer, in Haskell and in words.
function alsoFor(block: SavedBlock): string {
  const known: {readonly [about: string]: string} = words.toolbox.also
  const {con, of, name} = block.extraState ?? {}
  const own = [block.type, con, of, name].flatMap(about =>
    typeof about === "string" && Object.hasOwn(known, about) ? [known[about]] : [],
  )
  const inMenu =
    typeof of === "string"
      ? (choices[of]?.options ?? []).flatMap(value => [value, valueLabel(of, value)])
      : []
  const inside = [...Object.values(block.inputs ?? {}), block.next].flatMap(input =>
    input?.block === undefined ? [] : [alsoFor(input.block)],
  )
  return [...own, ...inMenu, ...inside].filter(found => found !== "").join(" ")
}
