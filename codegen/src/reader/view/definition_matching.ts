/// Matching of a new text's definitions with those that a view shows.

import type {Piece} from "../module/module_pieces.ts"
import {buildBlocks} from "./block_tree.ts"
import {treeSimilarity} from "./tree_matching.ts"
import type {Shown, View} from "./view.ts"

interface Partner {
  readonly shown: Shown
  /// Its text is what it was.
  readonly same: boolean
}

/// For each definition of the new text the one that it was: by its text, then by its name, then by its place among the others. Of several with one
/// text, where the view was saved beside this very text (`isInOrder`), the one at the same place.
export function partnersOf(
  pieces: readonly Piece[],
  view: View,
  unchanged: (shown: Shown, piece: Piece) => boolean,
  isInOrder: boolean,
): {partners: readonly (Partner | undefined)[]; left: readonly Shown[]} {
  const free = new Set([...view.declarations, ...view.gone])
  const partners: (Partner | undefined)[] = pieces.map(() => undefined)
  const byName = new Map<string, Shown[]>()
  for (const s of free) byName.set(s.name, [...(byName.get(s.name) ?? []), s])
  const take = (i: number, shown: Shown, same: boolean): void => {
    free.delete(shown)
    partners[i] = {shown, same}
  }
  const named = (piece: Piece): Shown[] => byName.get(piece.names[0] ?? "_")?.filter(s => free.has(s)) ?? []
  if (isInOrder)
    pieces.forEach((piece, i) => {
      const found = view.declarations[i]
      if (found !== undefined && unchanged(found, piece)) take(i, found, true)
    })
  pieces.forEach((piece, i) => {
    if (partners[i] !== undefined) return
    const found = named(piece).find(s => unchanged(s, piece))
    if (found !== undefined) take(i, found, true)
  })
  pieces.forEach((piece, i) => {
    const [found] = partners[i] === undefined && piece.names.length > 0 ? named(piece) : []
    if (found !== undefined) take(i, found, false)
  })
  // A definition whose name was edited stands between the same neighbours.
  const current = view.declarations
  pieces.forEach((piece, i) => {
    if (partners[i] !== undefined) return
    const above = i === 0 ? -1 : current.indexOf(partners[i - 1]?.shown as Shown)
    if (i > 0 && above === -1) return
    const candidate = current[above + 1]
    if (candidate === undefined || !free.has(candidate)) return
    if (piece.broken || isLike(piece, candidate)) take(i, candidate, false)
  })
  return {partners, left: [...free]}
}

function isLike(piece: Piece, shown: Shown): boolean {
  let n = 0
  const built = buildBlocks(piece, () => `n${n++}`)
  return built !== undefined && treeSimilarity(shown.block, built.block) >= 0.4
}
