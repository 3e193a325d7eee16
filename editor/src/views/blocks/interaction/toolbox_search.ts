/// The search of the toolbox: what it looks through, how well items match a query, and the order in which they are offered.

import type {BlockView, Level, SavedBlock, ToolboxItem} from "@rosy/codegen"
import type {Language} from "../construction/language.ts"

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
  /// It is a name of the program.
  readonly isOwn: boolean
}

/// A text as the search compares it: small letters without accents, so that "meme" finds "même"; spaces of any width are
/// alike, and so are ’, which French texts have, and ', which keyboards have.
function searchKey(text: string): string {
  return text.toLowerCase().normalize("NFD").replace(/\p{M}/gu, "").replace(/\s/g, " ").replaceAll("’", "'")
}

/// Items with their words, from the shapes of their blocks. `areOwn`: they are names of the program.
export function searchEntries(
  items: readonly ToolboxItem[],
  views: readonly BlockView[],
  areOwn = false,
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
    isOwn: areOwn,
  }))
}

/// How well the query as it stands fits an item. More than its words can count one by one. A name of the library comes after what people call by that word.
function phraseRank({item, label, words, isOwn}: SearchEntry, phrase: string): number {
  if (!isOwn && (isName(item) || isFunctionAlone(item)))
    return label === phrase ? 40 : label.startsWith(phrase) ? 20 : 0
  const begins = label.startsWith(phrase) ? 100 : label.includes(` ${phrase}`) ? 50 : 0
  const whole = (hasWords(label, phrase) ? 125 : 0) + (hasWords(words, phrase) ? 120 : 0)
  // The command for a thing comes before steps and reactions that use the thing.
  const isItsName = hasWords(item.names ?? "", phrase)
  return (isItsName ? 400 : 0) + (label === phrase ? 200 : 0) + begins + whole
}

/// How far a call of the library stands behind blocks that have the phrase as well; not if it is called so from the beginning.
const placesBehind = ({item, label, isOwn}: SearchEntry, phrase: string): number =>
  !isOwn && item.block.type === "name" && !label.startsWith(phrase) ? 200 : 0

/// Whether a phrase stands in a text as whole words.
function hasWords(text: string, phrase: string): boolean {
  const at = wordsOf(phrase).join(" ")
  return at !== "" && ` ${wordsOf(text).join(" ")} `.includes(` ${at} `)
}

/// Items whose words hold every word of the query, best first: the query as it stands, by whole words first; then each word at the start of
/// the label, of a word of the label, anywhere in it, on the blocks.
export function search(items: readonly SearchEntry[], query: string): readonly ToolboxItem[] {
  const words = searchKey(query)
    .split(/\s+/)
    .filter(word => word !== "")
  if (words.length === 0) return []
  const phrase = words.join(" ")
  const rank = (entry: SearchEntry) => {
    const {label, words: others} = entry
    return words.reduce(
      (sum, word) => {
        const at = label.indexOf(word)
        if (label === word) return sum + 6
        if (at >= 0) return sum + (at === 0 ? 4 : label[at - 1] === " " ? 3 : 2)
        return others.includes(word) ? sum + 1 : Number.NEGATIVE_INFINITY
      },
      phraseRank(entry, phrase),
    )
  }
  return items
    .map((found, order) => ({item: found.item, order, rank: rank(found), after: placesBehind(found, phrase)}))
    .filter(found => found.rank > 0)
    .sort((one, two) => two.rank - two.after - (one.rank - one.after) || one.order - two.order)
    .map(found => found.item)
}

/// A list to choose from at a glance.
const mostNear = 8

/// Items near a query that finds nothing, best first: those with some of its words, or with a word that differs by a slip of the fingers.
export function searchNear(items: readonly SearchEntry[], query: string): readonly ToolboxItem[] {
  const asked = wordsOf(query)
  const nearness = ({label, words}: SearchEntry) => {
    const known = wordsOf(`${label} ${words}`)
    return asked.reduce((sum, word) => sum + Math.max(0, ...known.map(one => wordNearness(word, one))), 0)
  }
  return items
    .map((found, order) => ({item: found.item, order, near: nearness(found)}))
    .filter(found => found.near > 0)
    .sort((one, two) => two.near - one.near || one.order - two.order)
    .slice(0, mostNear)
    .map(found => found.item)
}

/// Words of letters and digits, as the search compares them.
const wordsOf = (text: string): readonly string[] => searchKey(text).match(/[\p{L}\p{N}°]+/gu) ?? []

/// 3 for the same word, 2 for its beginning, 1 for one or, in a long word, two slips; words of less than four letters have to be the same.
function wordNearness(asked: string, known: string): number {
  if (asked === known) return 3
  if (Math.min(asked.length, known.length) < 4) return 0
  if (known.startsWith(asked) || asked.startsWith(known)) return 2
  const slips = asked.length < 8 ? 1 : 2
  if (Math.abs(asked.length - known.length) > slips) return 0
  return editDistance(asked, known) <= slips ? 1 : 0
}

/// The least number of letters to insert, leave out or replace, and of neighbours to swap, that makes one word the other: the optimal string alignment distance.
function editDistance(one: string, other: string): number {
  let twoAbove: readonly number[] = []
  let above: readonly number[] = Array.from({length: other.length + 1}, (_, at) => at)
  for (let i = 1; i <= one.length; i++) {
    const row = [i]
    for (let j = 1; j <= other.length; j++) {
      const replaced = (above[j - 1] ?? 0) + (one[i - 1] === other[j - 1] ? 0 : 1)
      const swaps = i > 1 && j > 1 && one[i - 1] === other[j - 2] && one[i - 2] === other[j - 1]
      const swapped = swaps ? (twoAbove[j - 2] ?? 0) + 1 : Number.POSITIVE_INFINITY
      row.push(Math.min((above[j] ?? 0) + 1, (row[j - 1] ?? 0) + 1, replaced, swapped))
    }
    twoAbove = above
    above = row
  }
  return above[other.length] ?? 0
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
    // An operator is the whole of a word, a name may be the beginning of one; nothing is called after a number in it.
    const called = /^\p{L}/u.test(asked)
      ? label.startsWith(asked)
      : label === asked || (!/\d/.test(asked) && label.split(" ").includes(asked))
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

/// Whether an item is a function of the library without its inputs.
const isFunctionAlone = ({block}: ToolboxItem): boolean =>
  block.type === "name" && block.extraState?.args === 0

/// Whether an item is nothing but a name.
function isName({label, block}: ToolboxItem): boolean {
  return block.type === "name" && block.extraState?.name === label
}
