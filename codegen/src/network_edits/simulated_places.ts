/// What `simulate` runs: places of its block are filled, emptied and closed.

import {countIn} from "../blocks/spec/block_spec.ts"
import type {SavedBlock, SavedInput} from "../serialized_blocks.ts"

const placesOf = (main: SavedBlock): readonly (SavedBlock | undefined)[] =>
  Array.from(
    {length: countIn(main.extraState ?? {}, "controllers", 1, 1)},
    (_, i) => main.inputs?.[`R${i}`]?.block,
  )

function withPlaces(main: SavedBlock, places: readonly (SavedBlock | undefined)[]): SavedBlock {
  const inputs: {[name: string]: SavedInput} = {}
  for (const [i, block] of places.entries()) if (block !== undefined) inputs[`R${i}`] = {block}
  return {...main, extraState: {...main.extraState, controllers: Math.max(1, places.length)}, inputs}
}

/// With a reference in the first empty place, or in one more.
export function withPlace(main: SavedBlock, reference: SavedBlock): SavedBlock {
  const places = placesOf(main)
  const free = places.indexOf(undefined)
  return withPlaces(main, free < 0 ? [...places, reference] : places.with(free, reference))
}

const refersTo = (name: string) => (block: SavedBlock | undefined) =>
  block?.type === "name" && block.extraState?.name === name && block.inputs === undefined

/// Without the places of a definition; of two that have a priority between them the other one stays.
export function withoutPlaces(main: SavedBlock, name: string): SavedBlock {
  const isIt = refersTo(name)
  const without = (block: SavedBlock | undefined): SavedBlock | undefined => {
    if (isIt(block)) return undefined
    if (block?.type !== "priority") return block
    const [first, second] = [block.inputs?.A?.block, block.inputs?.B?.block]
    const [one, other] = [without(first), without(second)]
    if (one === first && other === second) return block
    if (one === undefined || other === undefined) return one ?? other
    return {...block, inputs: {...block.inputs, A: {block: one}, B: {block: other}}}
  }
  const places = placesOf(main)
  const kept = places.flatMap(place => {
    const left = without(place)
    return place !== undefined && left === undefined ? [] : [left]
  })
  return withPlaces(main, kept)
}

/// Whether one of the places is for a definition, alone or with a priority.
export function isPlaced(main: SavedBlock, name: string): boolean {
  const isIt = refersTo(name)
  const holds = (block: SavedBlock | undefined): boolean =>
    isIt(block) ||
    (block?.type === "priority" && (holds(block.inputs?.A?.block) || holds(block.inputs?.B?.block)))
  return placesOf(main).some(holds)
}
