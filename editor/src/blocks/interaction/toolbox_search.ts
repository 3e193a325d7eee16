/// The search of the toolbox: what it looks through, how well items match a query, and the order in which they are offered.

import type {BlockView, Level, SavedBlock, ToolboxItem} from "@rosy/codegen"
import type {Language} from "../language.ts"

/// The levels of the toolbox, easiest first.
export const levels: readonly Level[] = ["tasks", "reactions", "haskell"]

/// All that the search finds: what this level shows comes first, but a level hides nothing from it.
export function searchable(language: Language, level: Level): readonly ToolboxItem[] {
  const found = new Map<string, ToolboxItem>()
  for (const one of [level, ...levels]) {
    for (const item of language.toolbox(one).flatMap(category => category.items)) {
      const key = JSON.stringify(item.block)
      if (!found.has(key)) found.set(key, item)
    }
  }
  const shown = new Set([...found.values()].map(item => bareKey(item.block)))
  return [...found.values(), ...language.libraryItems().filter(item => !shown.has(bareKey(item.block)))]
}

/// A block without what fills it: a ready block of the toolbox stands for the name from the library.
function bareKey({type, extraState}: SavedBlock): string {
  const {name, con, op, args} = extraState ?? {}
  return JSON.stringify([type, name ?? con ?? op ?? extraState, args === 0])
}

/// Where an item fits: in the chosen place, in another place of the chosen block, on its own, or not at all.
export type Fit = "here" | "near" | "alone" | "nowhere"

/// An item with the words it can be found by.
export interface SearchEntry {
  readonly item: ToolboxItem
  readonly label: string
  /// What stands on its blocks: labels, names, constructors.
  readonly words: string
}

/// A text as the search compares it: small letters without accents, so that "meme" finds "même"; spaces of any width are alike.
function searchKey(text: string): string {
  return text.toLowerCase().normalize("NFD").replace(/\p{M}/gu, "").replace(/\s/g, " ")
}

/// Items with their words, from the shapes of their blocks.
export function searchEntries(
  items: readonly ToolboxItem[],
  views: readonly BlockView[],
): readonly SearchEntry[] {
  const byType = new Map(views.map(view => [view.type, view]))
  function* said(block: SavedBlock): Generator<string> {
    for (const part of byType
      .get(block.type)
      ?.shape(block.extraState ?? {})
      .rows.flat() ?? []) {
      if (part.kind === "label") yield part.text
      else if ("value" in part) yield part.value
    }
    for (const input of Object.values(block.inputs ?? {}))
      if (input.block !== undefined) yield* said(input.block)
    if (block.next?.block !== undefined) yield* said(block.next.block)
  }
  return items.map(item => ({
    item,
    label: searchKey(item.label),
    words: searchKey([...said(item.block), item.also ?? ""].join(" ")),
  }))
}

/// How well the query as it stands fits a label. More than its words can count one by one.
function phraseRank(label: string, phrase: string): number {
  if (label === phrase) return 200
  if (label.startsWith(phrase)) return 100
  return label.includes(` ${phrase}`) ? 50 : 0
}

/// Items whose words hold every word of the query, best first: the query as it stands; then each word at the start of
/// the label, of a word of the label, anywhere in it, on the blocks.
export function search(items: readonly SearchEntry[], query: string): readonly ToolboxItem[] {
  const words = searchKey(query)
    .split(/\s+/)
    .filter(word => word !== "")
  if (words.length === 0) return []
  const phrase = words.join(" ")
  const rank = ({label, words: others}: SearchEntry) =>
    words.reduce(
      (sum, word) => {
        const at = label.indexOf(word)
        if (label === word) return sum + 6
        if (at >= 0) return sum + (at === 0 ? 4 : label[at - 1] === " " ? 3 : 2)
        return others.includes(word) ? sum + 1 : Number.NEGATIVE_INFINITY
      },
      phraseRank(label, phrase),
    )
  return items
    .map((found, order) => ({item: found.item, order, rank: rank(found)}))
    .filter(found => found.rank > 0)
    .sort((one, two) => two.rank - one.rank || one.order - two.order)
    .map(found => found.item)
}

/// How many of the items found are asked whether they fit: those that a learner sees at once.
const askedAbout = 16

/// What is found, ordered by what the learner probably wants at the chosen place: what fits there and is called so, names of the library
/// after ready blocks and names of the program (`own`); what stands alone and is called so, what was typed itself (`typed`), then what only has the words somewhere.
export function bestFirst(
  found: readonly ToolboxItem[],
  typed: readonly ToolboxItem[],
  query: string,
  fits: ((item: ToolboxItem) => Fit) | undefined,
  own: ReadonlySet<string>,
): readonly ToolboxItem[] {
  if (fits === undefined) return [...found, ...typed]
  const asked = searchKey(query)
  const place = (item: ToolboxItem): number => {
    const label = searchKey(item.label)
    // An operator is the whole of a word, a name may be the beginning of one.
    const called = /^\p{L}/u.test(asked) ? label.startsWith(asked) : label.split(" ").includes(asked)
    switch (fits(item)) {
      case "here":
        if (typed.includes(item)) return 2
        return !called ? 3 : isName(item) && !own.has(item.label) ? 0.5 : 0
      case "near":
        return called && !typed.includes(item) ? 2.5 : 3.5
      case "alone":
        return called ? 1 : 4
      case "nowhere":
        return typed.includes(item) ? Number.POSITIVE_INFINITY : 5
    }
  }
  return [...found.slice(0, askedAbout), ...typed, ...found.slice(askedAbout)]
    .map((item, at) => ({item, place: at < askedAbout + typed.length ? place(item) : 5}))
    .filter(one => one.place < Number.POSITIVE_INFINITY)
    .sort((one, two) => one.place - two.place)
    .map(one => one.item)
}

/// Whether an item is nothing but a name.
function isName({label, block}: ToolboxItem): boolean {
  return block.type === "name" && block.extraState?.name === label
}
