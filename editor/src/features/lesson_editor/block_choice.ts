/// Choice of the toolbox's blocks that a lesson offers, kept as the words that these blocks say. Pure.

import type {ToolboxCategory, ToolboxItem} from "@rosy/codegen"
import {toolboxOf, wordsOf} from "../../lesson_files/toolbox_words.ts"

export interface OfferedItem {
  readonly item: ToolboxItem
  readonly isOffered: boolean
  /// Why the choice cannot be changed: all of its words are words of other offered blocks, or it is a pattern and no function can be
  /// defined. `null` when it can be changed.
  readonly fixed: "said-by-others" | "needs-function" | null
}

export interface OfferedCategory {
  readonly name: string
  readonly items: readonly OfferedItem[]
}

/// The whole toolbox, with what is offered of it.
export function offeredItems(
  categories: readonly ToolboxCategory[],
  words: readonly string[],
): readonly OfferedCategory[] {
  const offered = new Set(toolboxOf(categories, words).flatMap(category => category.items))
  const speakers = new Map<string, number>()
  for (const item of offered) for (const word of own(item)) speakers.set(word, (speakers.get(word) ?? 0) + 1)
  const isSaidByOthers = (item: ToolboxItem) => own(item).every(word => (speakers.get(word) ?? 0) > 1)
  const hasFunctions = words.some(word => word.startsWith("define "))
  const fixed = (item: ToolboxItem) => {
    if (offered.has(item)) return isSaidByOthers(item) ? "said-by-others" : null
    return item.block.type.startsWith("pattern_") && !hasFunctions ? "needs-function" : null
  }
  return categories.map(({name, items}) => ({
    name,
    items: items.map(item => ({item, isOffered: offered.has(item), fixed: fixed(item)})),
  }))
}

const own = (item: ToolboxItem): readonly string[] => [...new Set(wordsOf(item.block))]

/// The words when an item is offered from now on, or no more.
export function withItem(
  categories: readonly ToolboxCategory[],
  words: readonly string[],
  item: ToolboxItem,
  isOffered: boolean,
): readonly string[] {
  if (isOffered) return [...new Set([...words, ...own(item)])].sort()
  const others = toolboxOf(categories, words)
    .flatMap(category => category.items)
    .filter(one => one !== item)
  const needed = new Set(others.flatMap(own))
  const removed = new Set(own(item).filter(word => !needed.has(word)))
  return words.filter(word => !removed.has(word))
}
