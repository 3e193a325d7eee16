/// Worlds for the tests: a small empty one, and any that the schema allows.

import fc from "fast-check"
import {type Spot, simulatedRobots, type World, type WorldGoal} from "../../src/worlds/world.ts"

export const emptyRoom: World = {
  name: "test",
  title: "",
  size: [5, 4],
  start: {x: 1.5, y: 2, theta: 0},
  tile: 0.5,
  tiles: [],
  walls: [],
  boxes: [],
  rounds: [],
  lines: [],
  goals: [],
  realism: null,
  dock: null,
  battery: 1,
  scanner: true,
  robot: "kobuki",
}

/// Without the negative zero, which JSON does not know.
const between = (min: number, max: number) => fc.double({min, max, noNaN: true}).map(n => n + 0)
const place = between(0, 6)
const spot: fc.Arbitrary<Spot> = fc.tuple(place, place)
const length = between(0.01, 3)
const weight = {movable: fc.boolean(), mass: between(0.05, 1000)}
const about = {title: fc.constantFrom("", "Come here"), within: fc.option(between(0.01, 600))}
const points = fc.array(spot, {minLength: 2, maxLength: 6})

const goal: fc.Arbitrary<WorldGoal> = fc.oneof(
  fc.record({
    ...about,
    kind: fc.constantFrom("reach" as const, "touch" as const),
    x: place,
    y: place,
    r: length,
  }),
  fc.record({
    title: about.title,
    within: fc.constant(null),
    kind: fc.constant("avoid" as const),
    what: fc.constant("place" as const),
    x: place,
    y: place,
    r: length,
  }),
  fc.record({
    title: about.title,
    within: fc.constant(null),
    kind: fc.constant("avoid" as const),
    what: fc.constantFrom("bumps" as const, "holes" as const),
  }),
  fc.record({...about, kind: fc.constant("visit" as const), points, r: length}),
  fc.record({
    ...about,
    kind: fc.constant("lap" as const),
    from: spot,
    to: spot,
    laps: fc.integer({min: 1, max: 1000}),
  }),
  fc.record({...about, kind: fc.constant("draw" as const), points, tolerance: length}),
)

const tiles = fc.oneof(
  fc.constant([] as string[]),
  fc
    .array(fc.string({unit: fc.constantFrom("#", ".", "O"), minLength: 12, maxLength: 12}), {
      minLength: 12,
      maxLength: 12,
    })
    .filter(rows => rows.some(row => row.includes("."))),
)

/// Any world of six by six metres, with or without tiles.
export const anyWorld: fc.Arbitrary<World> = fc.record({
  name: fc.constantFrom("", "mine"),
  title: fc.constantFrom("", "A room"),
  size: fc.constant([6, 6] as Spot),
  start: fc.record({x: place, y: place, theta: between(-7, 7)}),
  tile: fc.constant(0.5),
  tiles,
  walls: fc.array(fc.record({from: spot, to: spot}), {maxLength: 4}),
  boxes: fc.array(fc.record({x: place, y: place, w: length, h: length, theta: between(-7, 7), ...weight}), {
    maxLength: 4,
  }),
  rounds: fc.array(fc.record({x: place, y: place, r: length, ...weight}), {maxLength: 4}),
  goals: fc.array(goal, {maxLength: 4}),
  robot: fc.constantFrom(...simulatedRobots),
  realism: fc.option(
    fc.record({
      slip: between(0, 0.5),
      drift: between(0, 1),
      noise: between(0, 0.5),
      latency: between(0, 2),
      travel: between(0.2, 2),
      turning: between(0.2, 2),
      veer: between(-5, 5),
    }),
  ),
  dock: fc.option(fc.record({x: between(0, 0.5), y: between(0, 0.5), theta: between(-7, 7)})),
  battery: between(0, 1),
  scanner: fc.boolean(),
  lines: fc.array(
    fc.record({
      points: fc.array(fc.tuple(place, place), {minLength: 2, maxLength: 5}),
      width: between(0.01, 1),
    }),
    {maxLength: 3},
  ),
})
