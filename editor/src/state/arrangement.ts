/// Layout of the page's regions: a tree of splits with a region at each leaf. A hidden region keeps its place in the tree. Pure; positions and sizes are shares of the whole,
/// from 0 to 1, counted from the side on which reading begins.

export const regions = ["blocks", "haskell", "diagram", "room"] as const
export type Region = (typeof regions)[number]

export type Side = "left" | "right" | "top" | "bottom"

export type Tree =
  | Region
  | {
      /// Beside each other, or one below the other.
      readonly split: "beside" | "below"
      readonly first: Tree
      readonly second: Tree
      /// How much of it the first has.
      readonly share: number
    }

export interface Arrangement {
  readonly tree: Tree
  readonly hidden: readonly Region[]
}

export interface Box {
  readonly x: number
  readonly y: number
  readonly w: number
  readonly h: number
}

/// A border that can be moved: the split it belongs to (a step `0` or `1` for each branch from the root), the box of that split, and the
/// regions on its two sides.
export interface Divider {
  readonly path: string
  readonly split: "beside" | "below"
  readonly share: number
  readonly box: Box
  readonly between: readonly [readonly Region[], readonly Region[]]
}

/// The smallest and the largest share, and how far a key moves a border.
export const leastShare = 0.12
export const mostShare = 0.88
export const shareStep = 0.02

const beside = (first: Tree, second: Tree, share: number): Tree => ({split: "beside", first, second, share})
const below = (first: Tree, second: Tree, share: number): Tree => ({split: "below", first, second, share})

/// How much the blocks have of their height where the diagram is below them.
const shareAboveDiagram = 0.6

/// The diagram below the blocks, in a tree without it.
export function withDiagramBelowBlocks(tree: Tree): Tree {
  if (typeof tree === "string") return tree === "blocks" ? below(tree, "diagram", shareAboveDiagram) : tree
  return {...tree, first: withDiagramBelowBlocks(tree.first), second: withDiagramBelowBlocks(tree.second)}
}

/// From left to right the way a program travels. On a page 1440 pixels wide the shares leave the Haskell of the first examples unwrapped.
export const firstArrangement: Arrangement = {
  tree: withDiagramBelowBlocks(beside(beside("blocks", "haskell", 0.599), "room", 0.757)),
  hidden: ["diagram"],
}

/// Arrangements to choose from at once; the first is the default.
export const presetTrees: readonly Tree[] = [
  beside(beside("blocks", "haskell", 0.599), "room", 0.757),
  beside("blocks", below("room", "haskell", 0.6), 0.55),
  beside(below("blocks", "haskell", 0.6), "room", 0.6),
  beside("haskell", beside("blocks", "room", 0.6), 0.3),
  below(beside("blocks", "haskell", 0.6), "room", 0.5),
  beside("room", beside("blocks", "haskell", 0.6), 0.4),
].map(withDiagramBelowBlocks)

/// Of a lesson on a page that is not wide: its panel takes a part of the width, so the blocks have that of the Haskell, which is below them.
export const lessonArrangement: Arrangement = {
  tree: withDiagramBelowBlocks(beside(below("blocks", "haskell", 0.62), "room", 0.62)),
  hidden: firstArrangement.hidden,
}

/// A page of fewer pixels in width has no room for a lesson beside blocks, Haskell and room.
const roomForLesson = 1400

/// The arrangement while a lesson is open; one that the learner has chosen stays.
export const duringLesson = (arrangement: Arrangement, pageWidth: number): Arrangement =>
  pageWidth < roomForLesson && isSame(arrangement, firstArrangement) ? lessonArrangement : arrangement

/// The arrangement after a lesson.
export const afterLesson = (arrangement: Arrangement): Arrangement =>
  isSame(arrangement, lessonArrangement) ? firstArrangement : arrangement

const isSame = (one: Arrangement, other: Arrangement): boolean =>
  one.hidden.length === other.hidden.length &&
  one.hidden.every(region => other.hidden.includes(region)) &&
  sameTree(one.tree, other.tree)

function sameTree(one: Tree, other: Tree): boolean {
  if (typeof one === "string" || typeof other === "string") return one === other
  const {split, share, first, second} = one
  return (
    split === other.split &&
    share === other.share &&
    sameTree(first, other.first) &&
    sameTree(second, other.second)
  )
}

export function regionsIn(tree: Tree): readonly Region[] {
  return typeof tree === "string" ? [tree] : [...regionsIn(tree.first), ...regionsIn(tree.second)]
}

/// The tree of what is to be seen; `null` when nothing is.
export function visibleTree(tree: Tree, hidden: readonly Region[]): Tree | null {
  if (typeof tree === "string") return hidden.includes(tree) ? null : tree
  const first = visibleTree(tree.first, hidden)
  const second = visibleTree(tree.second, hidden)
  if (first === null || second === null) return first ?? second
  return {...tree, first, second}
}

/// The box of each region that is seen.
export function boxes(tree: Tree, box: Box = {x: 0, y: 0, w: 1, h: 1}): ReadonlyMap<Region, Box> {
  if (typeof tree === "string") return new Map([[tree, box]])
  const [one, other] = halves(tree.split, tree.share, box)
  return new Map([...boxes(tree.first, one), ...boxes(tree.second, other)])
}

export function dividers(tree: Tree, box: Box = {x: 0, y: 0, w: 1, h: 1}, path = ""): readonly Divider[] {
  if (typeof tree === "string") return []
  const [one, other] = halves(tree.split, tree.share, box)
  const {split, share, first, second} = tree
  return [
    {path, split, share, box, between: [regionsIn(first), regionsIn(second)]},
    ...dividers(first, one, `${path}0`),
    ...dividers(second, other, `${path}1`),
  ]
}

function halves(split: "beside" | "below", share: number, {x, y, w, h}: Box): readonly [Box, Box] {
  return split === "beside"
    ? [
        {x, y, w: w * share, h},
        {x: x + w * share, y, w: w * (1 - share), h},
      ]
    : [
        {x, y, w, h: h * share},
        {x, y: y + h * share, w, h: h * (1 - share)},
      ]
}

/// The arrangement with the border between these two sides elsewhere. A divider is told by what is seen on its sides, for
/// hidden regions stand in the tree too.
export function resizeSplit(arrangement: Arrangement, divider: Divider, share: number): Arrangement {
  const [one, other] = divider.between
  const kept = Math.min(mostShare, Math.max(leastShare, share))
  const walk = (tree: Tree): Tree => {
    if (typeof tree === "string") return tree
    const has = (part: Tree, all: readonly Region[]) => all.every(region => regionsIn(part).includes(region))
    return has(tree.first, one) && has(tree.second, other)
      ? {...tree, share: kept}
      : {...tree, first: walk(tree.first), second: walk(tree.second)}
  }
  return {...arrangement, tree: walk(arrangement.tree)}
}

/// The share of a region that moves beside others: half of one region, a third of all.
const shareOfOne = 0.5
const shareOfAll = 1 / 3

/// The arrangement with a region on a side of another one, or of all others.
export function moveRegion(
  arrangement: Arrangement,
  region: Region,
  target: Region | "all",
  side: Side,
): Arrangement {
  const rest = visibleTree(arrangement.tree, [region])
  if (rest === null || target === region) return arrangement
  const put = (tree: Tree, share: number): Tree => {
    const split = side === "left" || side === "right" ? "beside" : "below"
    return side === "left" || side === "top"
      ? {split, first: region, second: tree, share}
      : {split, first: tree, second: region, share: 1 - share}
  }
  const walk = (tree: Tree): Tree => {
    if (tree === target) return put(tree, shareOfOne)
    return typeof tree === "string" ? tree : {...tree, first: walk(tree.first), second: walk(tree.second)}
  }
  return {...arrangement, tree: target === "all" ? put(rest, shareOfAll) : walk(rest)}
}

/// The arrangement with two regions in each other's place.
export function swapRegions(arrangement: Arrangement, one: Region, other: Region): Arrangement {
  const walk = (tree: Tree): Tree => {
    if (typeof tree !== "string") return {...tree, first: walk(tree.first), second: walk(tree.second)}
    return tree === one ? other : tree === other ? one : tree
  }
  return {...arrangement, tree: walk(arrangement.tree)}
}

/// How near to the edge of the page a region is let fall to stand beside all others, and how large the middle of a region is, where it
/// takes that region's place.
const edge = 0.05
const middle = 0.36

/// The arrangement after a region was let fall at a place; `null` where that changes nothing.
export function dropRegion(
  arrangement: Arrangement,
  region: Region,
  x: number,
  y: number,
): Arrangement | null {
  const shown = visibleTree(arrangement.tree, arrangement.hidden)
  if (shown === null || x < 0 || y < 0 || x > 1 || y > 1) return null
  const {side: outer, distance} = nearestSide({x: 0, y: 0, w: 1, h: 1}, x, y)
  const done = (next: Arrangement) => (sameShape(next.tree, arrangement.tree) ? null : next)
  if (distance < edge) return done(moveRegion(arrangement, region, "all", outer))
  for (const [target, box] of boxes(shown)) {
    if (x < box.x || x > box.x + box.w || y < box.y || y > box.y + box.h) continue
    if (target === region) return null
    const {side, distance: depth} = nearestSide(box, x, y)
    return depth > (1 - middle) / 2
      ? swapRegions(arrangement, region, target)
      : done(moveRegion(arrangement, region, target, side))
  }
  return null
}

/// The side of a box that a place is nearest to, and how near, as a share of the box.
function nearestSide(box: Box, x: number, y: number): {side: Side; distance: number} {
  const left = (x - box.x) / box.w
  const top = (y - box.y) / box.h
  const sides: readonly (readonly [Side, number])[] = [
    ["left", left],
    ["right", 1 - left],
    ["top", top],
    ["bottom", 1 - top],
  ]
  const [side, distance] = sides.reduce((best, one) => (one[1] < best[1] ? one : best))
  return {side, distance}
}

/// Whether two trees differ at most in where their borders are.
export function sameShape(one: Tree, other: Tree): boolean {
  if (typeof one === "string" || typeof other === "string") return one === other
  return one.split === other.split && sameShape(one.first, other.first) && sameShape(one.second, other.second)
}

/// Shows or hides a region. One stays to be seen.
export function setVisible(arrangement: Arrangement, region: Region, shown: boolean): Arrangement {
  const hidden = arrangement.hidden.filter(other => other !== region)
  if (shown) return {...arrangement, hidden}
  return hidden.length + 1 < regions.length ? {...arrangement, hidden: [...hidden, region]} : arrangement
}

/// Which views of the program are to be seen, beside the room. The diagram may be shown with each of the others.
export type View = "blocks" | "both" | "haskell" | "diagram"

export function viewOf({hidden}: Arrangement): View | null {
  const blocks = !hidden.includes("blocks")
  const haskell = !hidden.includes("haskell")
  const diagram = !hidden.includes("diagram")
  return blocks && haskell ? "both" : blocks ? "blocks" : haskell ? "haskell" : diagram ? "diagram" : null
}

export function withView(arrangement: Arrangement, view: View): Arrangement {
  if (view === "diagram") {
    const room = arrangement.hidden.filter(region => region === "room")
    return {...arrangement, hidden: [...room, "blocks", "haskell"]}
  }
  const others = arrangement.hidden.filter(region => region === "room" || region === "diagram")
  const other = view === "both" ? [] : view === "blocks" ? (["haskell"] as const) : (["blocks"] as const)
  return {...arrangement, hidden: [...others, ...other]}
}

/// Where a region is in a grid: from which line to which, counted from 1.
export interface Cell {
  readonly column: readonly [number, number]
  readonly row: readonly [number, number]
}

/// A tree as a grid: its tracks as shares, each region's cell, and the cells of its borders, which stand at the line that a cell begins with.
export interface Grid {
  readonly columns: readonly number[]
  readonly rows: readonly number[]
  readonly cells: ReadonlyMap<Region, Cell>
  readonly dividers: readonly (Divider & {readonly cell: Cell})[]
}

export function gridOf(tree: Tree): Grid {
  const placed = boxes(tree)
  const xs = lines([...placed.values()].flatMap(b => [b.x, b.x + b.w]))
  const ys = lines([...placed.values()].flatMap(b => [b.y, b.y + b.h]))
  const cellOf = ({x, y, w, h}: Box): Cell => ({
    column: [lineAt(xs, x), lineAt(xs, x + w)],
    row: [lineAt(ys, y), lineAt(ys, y + h)],
  })
  return {
    columns: tracks(xs),
    rows: tracks(ys),
    cells: new Map([...placed].map(([region, box]) => [region, cellOf(box)])),
    dividers: dividers(tree).map(divider => {
      const [, second] = halves(divider.split, divider.share, divider.box)
      return {...divider, cell: cellOf(second)}
    }),
  }
}

/// Two cuts nearer than this are one, as a share of the whole.
const same = 1e-6

function lines(at: readonly number[]): readonly number[] {
  return [...at].sort((a, b) => a - b).filter((x, i, all) => i === 0 || x - (all[i - 1] ?? 0) > same)
}

const lineAt = (all: readonly number[], at: number) => all.findIndex(x => Math.abs(x - at) <= same) + 1
const tracks = (all: readonly number[]) => all.slice(1).map((x, i) => x - (all[i] ?? 0))
