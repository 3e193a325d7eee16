/// Blocks of the toolbox for paper: by category, in words and in Haskell.

import type {Family, Item} from "../../../codegen/src/block_shape.ts"
import {blockView} from "../../../codegen/src/blocks/block_registry.ts"
import type {SavedBlock} from "../../../codegen/src/serialized_blocks.ts"
import {speak, type Words, words} from "../../../codegen/src/words/index.ts"
import {codeOf} from "../../../codegen/src/workspace/inference/code_generation.ts"
import {toolbox} from "../../../codegen/src/workspace/toolbox/toolbox.ts"
import {tablesOf} from "./language_tables.ts"

export interface PaperBlock {
  readonly family: Family
  /// What the toolbox calls it.
  readonly label: string
  /// The block with those inside of it, in the notation of `card_block.ts`.
  readonly drawn: string
  readonly haskell: string
}

export interface PaperCategory {
  readonly name: string
  readonly family: Family
  readonly blocks: readonly PaperBlock[]
}

/// Larger blocks are examples of programs and do not fit on a card.
const blocksOnCard = 7

/// Each block once, in the order in which a beginner meets them. Patterns stand inside other blocks, and blocks that hold any text have no Haskell
/// of their own.
export function paperBlocks(language: string): readonly PaperCategory[] {
  return inLanguage(tablesOf(language).blocks, () => {
    const taken = new Set<string>()
    const categories = new Map<string, {readonly family: Family; readonly blocks: PaperBlock[]}>()
    for (const {name, family, items} of [...toolbox("tasks"), ...toolbox("haskell")]) {
      const category = categories.get(name) ?? {family, blocks: []}
      categories.set(name, category)
      for (const {label, block} of items) {
        const haskell = codeOf(block)?.text ?? ""
        const skipped = /^(pattern|raw)/.test(block.type) || /^_?$/.test(haskell) || taken.has(haskell)
        if (skipped || size(block) > blocksOnCard) continue
        taken.add(haskell)
        category.blocks.push({family: familyOf(block), label, drawn: drawn(block), haskell})
      }
    }
    return [...categories].map(([name, category]) => ({name, ...category}))
  })
}

function inLanguage<Result>(table: Words, make: () => Result): Result {
  const before = words
  speak(table)
  try {
    return make()
  } finally {
    speak(before)
  }
}

const shapeOf = ({type, extraState = {}}: SavedBlock) => {
  const view = blockView(type)
  if (view === undefined) throw new Error(`expected a kind of block, found "${type}"`)
  return view.shape(extraState)
}

const familyOf = (block: SavedBlock): Family => shapeOf(block).family

const inside = ({inputs = {}, next}: SavedBlock): readonly SavedBlock[] =>
  [...Object.values(inputs), next].flatMap(input => (input?.block === undefined ? [] : [input.block]))

const size = (block: SavedBlock): number => inside(block).reduce((sum, one) => sum + size(one), 1)

function drawn(block: SavedBlock): string {
  const {family, rows} = shapeOf(block)
  const lines = rows.map(row =>
    row
      .map(item => drawnItem(item, block))
      .filter(text => text !== "")
      .join(" "),
  )
  return `⟦${family} ${lines.filter(line => line !== "").join("\n")}⟧`
}

function drawnItem(item: Item, {inputs = {}}: SavedBlock): string {
  switch (item.kind) {
    case "label":
      return item.text
    // A button has no words, and the type is part of the Haskell.
    case "button":
    case "signature":
      return ""
    case "menu":
      return `⟨${item.options.find(([, value]) => value === item.value)?.[0] ?? item.value}⟩`
    case "socket": {
      const block = inputs[item.name]?.block
      return block === undefined ? `⟨${item.hint ?? " "}⟩` : drawn(block)
    }
    case "stack": {
      const steps: string[] = []
      for (let step = inputs[item.name]?.block; step !== undefined; step = step.next?.block)
        steps.push(drawn(step))
      return steps.length === 0 ? "⟨ ⟩" : steps.join("\n")
    }
    default:
      return `⟨${item.value}⟩`
  }
}
