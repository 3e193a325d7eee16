/// Regions that move: whatever is done to them, they fill the page, and none is lost.

import fc from "fast-check"
import {describe, expect, it} from "vitest"
import {reduce} from "../../src/reducers/reducer.ts"
import {
  type Arrangement,
  afterLesson,
  type Box,
  boxes,
  dividers,
  dropRegion,
  duringLesson,
  firstArrangement,
  gridOf,
  leastShare,
  mostShare,
  moveRegion,
  presetTrees,
  type Region,
  regions,
  regionsIn,
  resizeSplit,
  type Side,
  sameShape,
  setVisible,
  swapRegions,
  type Tree,
  viewOf,
  visibleTree,
  withView,
} from "../../src/state/arrangement.ts"
import {initialState} from "../../src/state/page_state.ts"
import {memoryStorage as storage} from "../../src/storage/memory_storage.ts"
import {openProgramStore} from "../../src/storage/program_store.ts"

const anyRegion = fc.constantFrom(...regions)
const anySide = fc.constantFrom<Side>("left", "right", "top", "bottom")
type Deed = (arrangement: Arrangement) => Arrangement

/// What a learner can do to an arrangement.
const deed: fc.Arbitrary<Deed> = fc.oneof(
  fc.tuple(anyRegion, fc.constantFrom<Region | "all">("all", ...regions), anySide).map(
    ([region, target, side]): Deed =>
      a =>
        moveRegion(a, region, target, side),
  ),
  fc.tuple(anyRegion, anyRegion).map(
    ([one, other]): Deed =>
      a =>
        swapRegions(a, one, other),
  ),
  fc.tuple(anyRegion, fc.boolean()).map(
    ([region, shown]): Deed =>
      a =>
        setVisible(a, region, shown),
  ),
  fc.constantFrom("blocks", "both", "haskell").map(
    (view): Deed =>
      a =>
        withView(a, view as never),
  ),
  fc.tuple(anyRegion, fc.double({min: 0, max: 1, noNaN: true}), fc.double({min: 0, max: 1, noNaN: true})).map(
    ([region, x, y]): Deed =>
      a =>
        dropRegion(a, region, x, y) ?? a,
  ),
  fc.tuple(fc.nat(), fc.double({min: -1, max: 2, noNaN: true})).map(
    ([n, share]): Deed =>
      a => {
        const all = dividers(visibleTree(a.tree, a.hidden) ?? "room")
        const divider = all[n % Math.max(1, all.length)]
        return divider === undefined ? a : resizeSplit(a, divider, share)
      },
  ),
)
const arrangements = fc
  .array(deed, {maxLength: 12})
  .map(deeds => deeds.reduce((a, act) => act(a), firstArrangement))

const area = ({w, h}: Box) => w * h
const overlap = (a: Box, b: Box) =>
  Math.max(0, Math.min(a.x + a.w, b.x + b.w) - Math.max(a.x, b.x)) *
  Math.max(0, Math.min(a.y + a.h, b.y + b.h) - Math.max(a.y, b.y))

/// The regions that a new page shows; the diagram is hidden.
const shownAtFirst = ["blocks", "haskell", "room"] as const
const withoutDiagram = (tree: Tree): Tree => visibleTree(tree, ["diagram"]) ?? tree

/// Every way of putting three regions beside and below each other, borders aside.
function allShapes(): Tree[] {
  const orders = [
    [0, 1, 2],
    [0, 2, 1],
    [1, 0, 2],
    [1, 2, 0],
    [2, 0, 1],
    [2, 1, 0],
  ].map(order => order.map(i => shownAtFirst[i] ?? "room"))
  return orders.flatMap(([a = "room", b = "room", c = "room"]) =>
    (["beside", "below"] as const).flatMap(outer =>
      (["beside", "below"] as const).flatMap((inner): Tree[] => [
        {split: outer, first: a, second: {split: inner, first: b, second: c, share: 0.5}, share: 0.5},
        {split: outer, first: {split: inner, first: a, second: b, share: 0.5}, second: c, share: 0.5},
      ]),
    ),
  )
}

/// What is seen of a tree: for each two regions, on which side of each other they are.
function looks(tree: Tree): string {
  const placed = boxes(tree)
  const at = (region: Region) => placed.get(region) ?? {x: 0, y: 0, w: 0, h: 0}
  return regions
    .flatMap(one =>
      regions.map(
        other =>
          `${Number(at(one).x + at(one).w <= at(other).x + 1e-9)}${Number(at(one).y + at(one).h <= at(other).y + 1e-9)}`,
      ),
    )
    .join(" ")
}

describe("an arrangement", () => {
  it("fills the page with every region that is shown, without overlap", () => {
    fc.assert(
      fc.property(arrangements, arrangement => {
        expect([...regionsIn(arrangement.tree)].sort()).toEqual([...regions].sort())
        const tree = visibleTree(arrangement.tree, arrangement.hidden)
        expect(tree).not.toBeNull()
        const placed = [...boxes(tree ?? "room")]
        expect(placed.map(([region]) => region).sort()).toEqual(
          regions.filter(region => !arrangement.hidden.includes(region)).sort(),
        )
        expect(placed.reduce((sum, [, box]) => sum + area(box), 0)).toBeCloseTo(1, 9)
        for (const [i, [, a]] of placed.entries())
          for (const [, b] of placed.slice(i + 1)) expect(overlap(a, b)).toBeCloseTo(0, 9)
      }),
    )
  })

  it("is a grid whose cells are its boxes", () => {
    fc.assert(
      fc.property(arrangements, ({tree, hidden}) => {
        const shown = visibleTree(tree, hidden) ?? "room"
        const grid = gridOf(shown)
        const upTo = (tracks: readonly number[], line: number) =>
          tracks.slice(0, line - 1).reduce((a, b) => a + b, 0)
        for (const [region, box] of boxes(shown)) {
          const cell = grid.cells.get(region)
          expect(upTo(grid.columns, cell?.column[0] ?? 0)).toBeCloseTo(box.x, 5)
          expect(upTo(grid.columns, cell?.column[1] ?? 0)).toBeCloseTo(box.x + box.w, 5)
          expect(upTo(grid.rows, cell?.row[0] ?? 0)).toBeCloseTo(box.y, 5)
          expect(upTo(grid.rows, cell?.row[1] ?? 0)).toBeCloseTo(box.y + box.h, 5)
        }
        expect(grid.dividers).toHaveLength(grid.cells.size - 1)
      }),
    )
  })

  it("keeps its borders where both sides are of use, and moves only the one that was moved", () => {
    fc.assert(
      fc.property(arrangements, fc.nat(), fc.double({min: -1, max: 2, noNaN: true}), (arrangement, n, to) => {
        const all = dividers(visibleTree(arrangement.tree, arrangement.hidden) ?? "room")
        const divider = all[n % Math.max(1, all.length)]
        if (divider === undefined) return
        const after = resizeSplit(arrangement, divider, to)
        expect(sameShape(after.tree, arrangement.tree)).toBe(true)
        const now = dividers(visibleTree(after.tree, after.hidden) ?? "room")
        expect(now[all.indexOf(divider)]?.share).toBe(Math.min(mostShare, Math.max(leastShare, to)))
        for (const [i, other] of all.entries()) if (other !== divider) expect(now[i]?.share).toBe(other.share)
      }),
    )
  })

  it("reaches every other one by moving regions to the sides, as the arrow keys do", () => {
    const reached = new Map([[looks(withoutDiagram(firstArrangement.tree)), firstArrangement]])
    const todo = [firstArrangement]
    for (let now = todo.pop(); now !== undefined; now = todo.pop())
      for (const region of shownAtFirst)
        for (const side of ["left", "right", "top", "bottom"] as const) {
          const after = moveRegion(now, region, "all", side)
          const shape = looks(withoutDiagram(after.tree))
          if (reached.has(shape)) continue
          reached.set(shape, after)
          todo.push(after)
        }
    for (const tree of [...allShapes(), ...presetTrees])
      expect([...reached.keys()]).toContain(looks(withoutDiagram(tree)))
  })

  it("has a hidden region where it was when it is shown again", () => {
    fc.assert(
      fc.property(arrangements, anyRegion, (arrangement, region) => {
        if (arrangement.hidden.includes(region)) return
        const hidden = setVisible(arrangement, region, false)
        expect(setVisible(hidden, region, true)).toEqual(arrangement)
        expect(hidden.hidden.length).toBeLessThan(regions.length)
      }),
    )
  })

  it("swaps in the middle of a region, and stands beside it near its edge", () => {
    const room = boxes(firstArrangement.tree).get("room")
    const x = (room?.x ?? 0) + (room?.w ?? 0) / 2
    expect(dropRegion(firstArrangement, "blocks", x, 0.5)?.tree).toEqual(
      swapRegions(firstArrangement, "blocks", "room").tree,
    )
    expect(dropRegion(firstArrangement, "haskell", x, 0.8)?.tree).toEqual(
      moveRegion(firstArrangement, "haskell", "room", "bottom").tree,
    )
    expect(dropRegion(firstArrangement, "haskell", 0.5, 0.99)?.tree).toEqual(
      moveRegion(firstArrangement, "haskell", "all", "bottom").tree,
    )
    // Over itself, and outside.
    expect(dropRegion(firstArrangement, "room", x, 0.5)).toBeNull()
    expect(dropRegion(firstArrangement, "room", 1.2, 0.5)).toBeNull()
  })

  it("says which views of the program there are, and shows the room when a program runs", () => {
    const alone = setVisible(withView(firstArrangement, "haskell"), "room", false)
    expect(viewOf(alone)).toBe("haskell")
    expect([...alone.hidden].sort()).toEqual(["blocks", "diagram", "room"])
    const {state} = reduce({...initialState, arrangement: alone}, {kind: "run-pressed"})
    expect([...state.arrangement.hidden].sort()).toEqual(["blocks", "diagram"])
  })

  it("shows the diagram alone, or with the views beside it", () => {
    const alone = withView(firstArrangement, "diagram")
    expect(viewOf(alone)).toBe("diagram")
    expect([...alone.hidden].sort()).toEqual(["blocks", "haskell"])
    const beside = setVisible(firstArrangement, "diagram", true)
    expect(viewOf(beside)).toBe("both")
    expect(withView(beside, "blocks").hidden).toEqual(["haskell"])
    const box = (region: Region) => boxes(beside.tree).get(region) ?? {x: 0, y: 0, w: 0, h: 0}
    expect(box("diagram").y).toBeCloseTo(box("blocks").y + box("blocks").h, 9)
  })
})

describe("what the browser remembers of it", () => {
  it("comes back as it was", () => {
    fc.assert(
      fc.property(arrangements, arrangement => {
        const programStore = openProgramStore(storage(), storage())
        programStore.setPreferences({arrangement})
        expect(programStore.preferences().arrangement).toEqual(arrangement)
      }),
    )
  })

  it("has the diagram hidden below the blocks when it is from before there was one", () => {
    const there = storage()
    const tree = {
      split: "beside",
      first: "room",
      second: {split: "below", first: "blocks", second: "haskell", share: 0.5},
      share: 0.4,
    }
    there.setItem("rosy.liking", JSON.stringify({arrangement: {tree, hidden: ["haskell"]}}))
    const {arrangement} = openProgramStore(there, storage()).preferences()
    expect(arrangement?.hidden).toEqual(["haskell", "diagram"])
    expect(withoutDiagram(arrangement?.tree ?? "room")).toEqual(tree)
  })

  it("is left alone when it is no arrangement", () => {
    const wrong = [
      {tree: "blocks", hidden: []},
      {tree: {...(firstArrangement.tree as object), share: 7}, hidden: []},
      {tree: firstArrangement.tree, hidden: [...regions]},
      {tree: {split: "beside", first: "blocks", second: "blocks", share: 0.5}, hidden: []},
    ]
    for (const arrangement of wrong) {
      const there = storage()
      there.setItem("rosy.liking", JSON.stringify({arrangement}))
      expect(openProgramStore(there, storage()).preferences()).toEqual({})
    }
  })
})

describe("a lesson on a page that is not wide", () => {
  it("gives the blocks the width of the Haskell, and ends with the arrangement before", () => {
    const before = boxes(visibleTree(firstArrangement.tree, firstArrangement.hidden) ?? "room")
    for (const width of [1280, 1366]) {
      const now = duringLesson(firstArrangement, width)
      const during = boxes(visibleTree(now.tree, now.hidden) ?? "room")
      expect([...during.keys()].sort()).toEqual([...before.keys()].sort())
      expect(during.get("blocks")?.w).toBeGreaterThan((before.get("blocks")?.w ?? 0) * 1.3)
      expect(duringLesson(now, width)).toBe(now)
      expect(afterLesson(now)).toEqual(firstArrangement)
    }
  })

  it("leaves an arrangement that the learner has chosen, and a wide page, as they are", () => {
    for (const tree of presetTrees.slice(1)) {
      const chosen = {tree, hidden: firstArrangement.hidden}
      expect(duringLesson(chosen, 1280)).toBe(chosen)
      expect(afterLesson(chosen)).toBe(chosen)
    }
    const moved = resizeSplit(
      firstArrangement,
      dividers(firstArrangement.tree)[0] ?? expect.fail("expected a divider"),
      0.5,
    )
    expect(duringLesson(moved, 1280)).toBe(moved)
    expect(duringLesson(firstArrangement, 1440)).toBe(firstArrangement)
    expect(afterLesson(firstArrangement)).toBe(firstArrangement)
  })
})
