/// Every world that hands can draw is one the simulator takes, and every edit can be taken back.

import {readFileSync} from "node:fs"
import {Ajv2020} from "ajv/dist/2020.js"
import fc from "fast-check"
import {describe, expect, it} from "vitest"
import {tools} from "../../src/worlds/drawing_tools.ts"
import {edit, openEditor} from "../../src/worlds/editor_state.ts"
import type {WorldEdit, WorldEditor} from "../../src/worlds/editor_value.ts"
import {handlesOf} from "../../src/worlds/part_handles.ts"
import {partAt} from "../../src/worlds/part_hit_testing.ts"
import {startFault} from "../../src/worlds/start_validation.ts"
import type {World} from "../../src/worlds/world.ts"
import {readWorld} from "../../src/worlds/world_decoder.ts"
import {writeWorld} from "../../src/worlds/world_encoder.ts"
import {exists, partLimits, partsOf} from "../../src/worlds/world_parts.ts"
import {anyWorld, emptyRoom} from "./worlds.ts"

const schema = JSON.parse(
  readFileSync(new URL("../../../protocol/world.schema.json", import.meta.url), "utf8"),
) as object
const fitsSchema = new Ajv2020({strictTypes: false, strictRequired: false}).compile(schema)

/// A place, also a little outside of the room: hands slip.
const spot = fc.tuple(
  fc.double({min: -0.5, max: 7, noNaN: true}),
  fc.double({min: -0.5, max: 7, noNaN: true}),
)

const anyEdit: fc.Arbitrary<WorldEdit> = fc.oneof(
  {weight: 4, arbitrary: fc.record({kind: fc.constant("down" as const), at: spot, reach: fc.constant(0.1)})},
  {weight: 4, arbitrary: fc.record({kind: fc.constant("move" as const), at: spot})},
  {weight: 4, arbitrary: fc.constant({kind: "up" as const})},
  {weight: 3, arbitrary: fc.record({kind: fc.constant("tool" as const), tool: fc.constantFrom(...tools)})},
  fc.constant({kind: "cancel" as const}),
  fc.record({kind: fc.constant("snap" as const), snap: fc.boolean()}),
  fc.record({
    kind: fc.constant("choose" as const),
    part: fc.record({
      kind: fc.constantFrom(
        "wall" as const,
        "box" as const,
        "round" as const,
        "line" as const,
        "goal" as const,
      ),
      index: fc.nat(4),
    }),
  }),
  fc.constant({kind: "choose" as const, part: {kind: "start" as const}}),
  fc.record({
    kind: fc.constant("step" as const),
    dx: fc.integer({min: -9, max: 9}),
    dy: fc.integer({min: -9, max: 9}),
    fine: fc.boolean(),
  }),
  fc.constant({kind: "press" as const}),
  fc.record({kind: fc.constant("turn" as const), steps: fc.integer({min: -30, max: 30}), fine: fc.boolean()}),
  fc.constant({kind: "delete" as const}),
  fc.constant({kind: "duplicate" as const}),
  fc.record({
    kind: fc.constant("resize" as const),
    width: fc.double({min: 0, max: 30, noNaN: true}),
    height: fc.double({min: 0, max: 30, noNaN: true}),
  }),
  fc.constant({kind: "undo" as const}),
  fc.constant({kind: "redo" as const}),
)
const edits = fc.array(anyEdit, {maxLength: 60})
const after = (world: World, list: readonly WorldEdit[]) => list.reduce(edit, openEditor(world))
/// The editor once the hand is away from the sheet.
const atRest = (editor: WorldEditor) => edit(editor, {kind: "up"})

describe("the world editor", () => {
  it("only makes worlds that the schema and the simulator take, or says why the robot cannot start", () => {
    fc.assert(
      fc.property(anyWorld, edits, (world, list) => {
        const file = writeWorld(atRest(after(world, list)).world)
        expect(fitsSchema(file), JSON.stringify(fitsSchema.errors)).toBe(true)
        const read = readWorld(file)
        expect(read.kind).toBe("world")
      }),
      {numRuns: 300},
    )
  })

  it("goes back to the world it was opened with by undo alone, and forth again by redo", () => {
    fc.assert(
      fc.property(anyWorld, edits, (world, list) => {
        let editor = atRest(after(world, list))
        while (editor.future.length > 0) editor = edit(editor, {kind: "redo"})
        const last = editor.world
        const worlds: World[] = []
        while (editor.past.length > 0) {
          worlds.push(editor.world)
          editor = edit(editor, {kind: "undo"})
        }
        expect(editor.world).toEqual(world)
        for (const expected of worlds.reverse()) {
          editor = edit(editor, {kind: "redo"})
          expect(editor.world).toBe(expected)
        }
        expect(editor.world).toEqual(last)
      }),
      {numRuns: 200},
    )
  })

  it("undoes one edit with one undo, whatever it was", () => {
    fc.assert(
      fc.property(anyWorld, edits, anyEdit, (world, list, one) => {
        const before = atRest(after(world, list))
        if (one.kind === "undo" || one.kind === "redo") return
        const now = atRest(edit(before, one))
        const back = now.past.length > before.past.length ? edit(now, {kind: "undo"}) : now
        expect(back.world).toEqual(before.world)
      }),
      {numRuns: 200},
    )
  })

  it("never chooses what is not there", () => {
    fc.assert(
      fc.property(anyWorld, edits, (world, list) => {
        const {chosen, world: now} = after(world, list)
        if (chosen !== null) expect(exists(now, chosen)).toBe(true)
      }),
      {numRuns: 200},
    )
  })

  it("leaves a world alone that is only clicked at", () => {
    fc.assert(
      fc.property(anyWorld, fc.array(spot, {maxLength: 8}), (world, places) => {
        const clicks = places.flatMap((at): WorldEdit[] => [
          {kind: "down", at, reach: 0.1},
          {kind: "move", at},
          {kind: "up"},
        ])
        const editor = after(world, clicks)
        expect(editor.world).toBe(world)
        expect(editor.past).toEqual([])
      }),
    )
  })

  it("refuses a thing that can be pushed beyond the limit, says why, and draws one that stands still", () => {
    const drum = {x: 1, y: 1, r: 0.1, movable: true, mass: 1}
    const full = {...emptyRoom, rounds: Array.from({length: partLimits.movable}, () => drum)}
    const drawing: readonly WorldEdit[] = [
      {kind: "tool", tool: "crate"},
      {kind: "down", at: [2, 2], reach: 0.1},
      {kind: "move", at: [3, 3]},
      {kind: "up"},
    ]
    const refused = after(full, drawing)
    expect(refused.world).toEqual(full)
    expect(refused.refused).toBe("movable")
    const chosen = edit(refused, {kind: "choose", part: {kind: "round", index: 0}})
    expect(chosen.refused).toBe(null)
    expect(edit(chosen, {kind: "duplicate"})).toMatchObject({world: full, refused: "movable"})
    const box = {x: 4, y: 4, w: 0.4, h: 0.4, theta: 0, movable: true, mass: 1}
    const pushable = edit(chosen, {kind: "change", world: {...full, boxes: [box]}})
    expect(pushable).toMatchObject({world: full, refused: "movable"})
    const still = [{kind: "tool", tool: "box"} as const, ...drawing.slice(1)].reduce(edit, refused)
    expect(still).toMatchObject({refused: null, world: {boxes: [{movable: false}]}})
  })

  it("takes back a drawing that is cancelled, as when a second finger comes", () => {
    fc.assert(
      fc.property(anyWorld, fc.constantFrom(...tools), spot, fc.array(spot), (world, tool, from, path) => {
        const editor = after(world, [
          {kind: "tool", tool},
          {kind: "down", at: from, reach: 0.1},
          ...path.map((at): WorldEdit => ({kind: "move", at})),
          {kind: "cancel"},
        ])
        expect(editor.world).toEqual(world)
        expect(editor.past).toEqual([])
      }),
    )
  })
})

describe("a line on the floor", () => {
  const way = (...path: readonly [number, number][]): WorldEdit[] => [
    {kind: "down", at: path[0] ?? [0, 0], reach: 0.1},
    ...path.slice(1).map((at): WorldEdit => ({kind: "move", at})),
    {kind: "up"},
  ]
  const lineTool: WorldEdit = {kind: "tool", tool: "line"}
  const pointsOf = (editor: WorldEditor, index = 0) => editor.world.lines[index]?.points ?? []
  /// A quarter of a circle of 1.5 m, as a hand draws it: a point each centimetre.
  const arc = Array.from({length: 236}, (_, i): [number, number] => [
    2 + 1.5 * Math.sin(i / 150),
    2 + 1.5 * (1 - Math.cos(i / 150)),
  ])

  it("drawn by hand is as round as the way of the hand, with few points", () => {
    const editor = after(emptyRoom, [lineTool, ...way(...arc)])
    const points = pointsOf(editor)
    expect(points.length).toBeGreaterThan(3)
    expect(points.length).toBeLessThan(15)
    for (const [x, y] of points.slice(1))
      expect(Math.abs(Math.hypot(x - 2, y - 3.5) - 1.5)).toBeLessThan(0.06)
    expect(edit(editor, {kind: "undo"}).world).toEqual(emptyRoom)
  })

  it("goes on with each click on the grid, until another tool is chosen", () => {
    const editor = after(emptyRoom, [lineTool, ...way([1.02, 1]), ...way([2.04, 1]), ...way([2, 2.01])])
    expect(pointsOf(editor).slice(-2)).toEqual([
      [2, 1],
      [2, 2],
    ])
    const second = after(editor.world, [lineTool, ...way([4, 4])])
    expect(second.world.lines).toHaveLength(2)
  })

  it("that is long keeps room for its end", () => {
    // Straight pieces of 4 m, 60 of them: far more than 200 points before they are thinned.
    const zigzag = Array.from({length: 60 * 80}, (_, i): [number, number] => {
      const [row, along] = [Math.floor(i / 80), (i % 80) * 0.05]
      return [row % 2 === 0 ? 1 + along : 5 - along, 1 + row * 0.05]
    })
    const points = pointsOf(after(emptyRoom, [lineTool, ...way(...zigzag)]))
    expect(points.length).toBeLessThanOrEqual(200)
    expect(points.at(-1)?.[1]).toBeGreaterThan(3.8)
  })

  it("is found by a pointer under things and over goals, moved, pulled, copied and removed", () => {
    const drawn = after(emptyRoom, [lineTool, ...way([3, 1], [4, 1], [4, 2])])
    const part = {kind: "line", index: 0} as const
    expect(partAt(drawn.world, [3.5, 1.02], 0.05)).toEqual(part)
    const chosen = edit(drawn, {kind: "choose", part})
    expect(handlesOf(chosen.world, part)).toHaveLength(pointsOf(chosen).length)
    const moved = edit(chosen, {kind: "step", dx: 1, dy: 0, fine: false})
    expect(pointsOf(moved)[0]?.[0]).toBeCloseTo(3.1)
    expect(edit(moved, {kind: "duplicate"}).world.lines).toHaveLength(2)
    expect(edit(moved, {kind: "delete"}).world.lines).toEqual([])
  })

  it("is drawn by keys: the cross-hair goes down, along, and up", () => {
    const keys: readonly WorldEdit[] = [
      lineTool,
      {kind: "press"},
      ...Array.from({length: 10}, (): WorldEdit => ({kind: "step", dx: 1, dy: 0, fine: false})),
      {kind: "press"},
    ]
    const [from, to] = pointsOf(after(emptyRoom, keys))
    expect((to?.[0] ?? 0) - (from?.[0] ?? 0)).toBeCloseTo(1)
  })

  it("beyond the limit is refused with the reason", () => {
    const line = {
      points: [
        [1, 1],
        [2, 1],
      ] as const,
      width: 0.05,
    }
    const full = {...emptyRoom, lines: Array.from({length: partLimits.lines}, () => line)}
    expect(after(full, [lineTool, ...way([1, 1])])).toMatchObject({world: full, refused: "lines"})
  })
})

describe("hands", () => {
  const draw = (tool: (typeof tools)[number], ...path: [number, number][]): WorldEdit[] => {
    const [from = [0, 0]] = path
    return [
      {kind: "tool", tool},
      {kind: "down", at: from, reach: 0.1},
      ...path.slice(1).map((at): WorldEdit => ({kind: "move", at})),
      {kind: "up"},
    ]
  }

  it("draw a wall from end to end, on the grid", () => {
    const {world, chosen, tool} = after(emptyRoom, draw("wall", [1.03, 0.98], [2, 2], [3.04, 2.02]))
    expect(world.walls).toEqual([{from: [1, 1], to: [3, 2]}])
    expect(chosen).toEqual({kind: "wall", index: 0})
    expect(tool).toBe("choose")
  })

  it("draw a box from corner to corner, then drag it and pull it larger", () => {
    const {world} = after(emptyRoom, [
      ...draw("crate", [1, 1], [1.4, 1.6]),
      {kind: "down", at: [1.2, 1.3], reach: 0.1},
      {kind: "move", at: [2.21, 1.3]},
      {kind: "up"},
      {kind: "down", at: [2.4, 1.6], reach: 0.1},
      {kind: "move", at: [2.8, 2]},
      {kind: "up"},
    ])
    expect(world.boxes).toEqual([{x: 2.4, y: 1.5, w: 0.8, h: 1, theta: 0, movable: true, mass: 1}])
  })

  it("keep the opposite corner of a turned box where it is", () => {
    fc.assert(
      fc.property(
        fc.double({min: -3, max: 3, noNaN: true}),
        fc.nat(3),
        fc.double({min: 1.5, max: 4.5, noNaN: true}),
        fc.double({min: 1.5, max: 4.5, noNaN: true}),
        (theta, corner, x, y) => {
          const box = {x: 3, y: 3, w: 0.6, h: 0.4, theta, movable: false, mass: 1}
          const world = {...emptyRoom, size: [6, 6] as const, boxes: [box]}
          const part = {kind: "box", index: 0} as const
          const handles = handlesOf(world, part)
          const fixed = handles[(corner + 2) % 4]?.at ?? [0, 0]
          const at = handles[corner]?.at ?? [0, 0]
          const editor = after(world, [
            {kind: "snap", snap: false},
            {kind: "choose", part},
            {kind: "down", at, reach: 0.02},
            {kind: "move", at: [x, y]},
            {kind: "up"},
          ])
          const now = handlesOf(editor.world, part)[(corner + 2) % 4]?.at ?? [9, 9]
          expect(Math.hypot(now[0] - fixed[0], now[1] - fixed[1])).toBeLessThan(1e-3)
        },
      ),
    )
  })

  it("put down something of the usual size with a click", () => {
    for (const tool of ["wall", "box", "crate", "round", "drum", "reach", "touch", "avoid", "lap"] as const) {
      const editor = after(emptyRoom, draw(tool, [2.5, 2]))
      expect(partsOf(editor.world), tool).toHaveLength(2)
      expect(editor.chosen).not.toBeNull()
    }
  })

  it("fill every tile between two moves of a quick pointer", () => {
    const {world} = after(emptyRoom, draw("hole", [0.25, 0.25], [4.75, 0.25]))
    expect(world.tiles.at(-1)).toBe("OOOOOOOOOO")
    expect(world.size).toEqual([5, 4])
    const back = after(world, draw("floor", [0.25, 0.25], [4.75, 0.25]))
    expect(back.world.tiles).toEqual([])
  })

  it("go on with the points of a goal, and draw a path freely", () => {
    const visit = after(emptyRoom, [
      ...draw("visit", [1, 1]),
      ...draw("visit", [2, 1]),
      ...draw("visit", [2, 2]),
    ])
    expect(visit.world.goals).toMatchObject([
      {
        kind: "visit",
        points: [
          [1, 1],
          [2, 1],
          [2, 2],
        ],
      },
    ])
    const path = after(emptyRoom, draw("draw", [1, 1], [1.1, 1], [1.5, 1], [1.5, 1.5]))
    expect(path.world.goals).toMatchObject([
      {
        kind: "draw",
        points: [
          [1, 1],
          [1.5, 1],
          [1.5, 1.5],
        ],
      },
    ])
    const single = after(emptyRoom, draw("draw", [1, 1]))
    expect(single.world.goals).toMatchObject([
      {
        points: [
          [1, 1],
          [1.5, 1],
        ],
      },
    ])
  })

  it("do all of it with the keyboard's cross-hair", () => {
    const editor = after(emptyRoom, [
      {kind: "tool", tool: "wall"},
      {kind: "press"},
      {kind: "step", dx: 0, dy: 10, fine: false},
      {kind: "press"},
      {kind: "step", dx: 1, dy: 0, fine: false},
      {kind: "turn", steps: 6, fine: false},
    ])
    expect(editor.world.walls).toEqual([{from: [3.1, 2.5], to: [2.1, 2.5]}])
    expect(
      after(editor.world, [{kind: "choose", part: {kind: "wall", index: 0}}, {kind: "delete"}]).world.walls,
    ).toEqual([])
  })

  it("take the robot before the things under it, and things before goals", () => {
    const goal = {kind: "reach", title: "", within: null, x: 2, y: 2, r: 1} as const
    const box = {x: 2, y: 2.6, w: 0.5, h: 0.5, theta: 0, movable: false, mass: 1}
    const world: World = {...emptyRoom, start: {x: 1.5, y: 2, theta: 0}, goals: [goal], boxes: [box]}
    expect(partAt(world, [1.6, 2], 0.05)).toEqual({kind: "start"})
    expect(partAt(world, [2, 2.6], 0.05)).toEqual({kind: "box", index: 0})
    expect(partAt(world, [2.6, 2], 0.05)).toEqual({kind: "goal", index: 0})
    expect(partAt(world, [4, 3.5], 0.05)).toBeNull()
  })

  it("hear why the robot cannot start there", () => {
    const inWall = after(emptyRoom, draw("wall", [1.5, 1.5], [1.5, 2.5])).world
    expect(startFault(inWall)?.why).toMatch(/inside a wall/)
    const overHole = after(emptyRoom, draw("hole", [1.5, 2.2])).world
    expect(startFault(overHole)?.why).toMatch(/over a hole/)
    expect(startFault(emptyRoom)).toBeNull()
  })
})
