/// Graph of a function of the program: input against output, from the firings of the run. Pure.

import {type FiringLog, latestFirings} from "../state/runs/firing_log.ts"
import type {Branch} from "../wire/firing.generated.ts"
import type {FiringShown} from "../wire/page/explanations.generated.ts"

/// A number of what a function takes or gives: the second number of `Position 1 0` is its `y`.
export interface Axis {
  /// `Position`; empty for a number without a constructor.
  readonly type: string
  /// Among the numbers of a value of this type, from 0, and how many there are.
  readonly part: number
  readonly parts: number
}

export interface GraphPoint {
  readonly x: number
  readonly y: number
}

/// A case of the function, and the points at which it was taken, in the order of their inputs.
export interface GraphCase {
  /// Its pattern or guard, as the program writes it; empty where the function has no cases.
  readonly text: string
  readonly points: readonly GraphPoint[]
}

export interface FunctionGraph {
  readonly inputs: readonly Axis[]
  readonly outputs: readonly Axis[]
  /// The chosen axes; `null` when there is no such number.
  readonly x: Axis | null
  readonly y: Axis | null
  /// In the order of the program.
  readonly cases: readonly GraphCase[]
  /// The latest firing until the displayed moment, and the number of its case.
  readonly now: (GraphPoint & {readonly of: number}) | null
}

/// Points of one graph: the curve is as wide as some hundred pixels.
const mostPoints = 240

/// Which axes the learner has chosen, as `axisName` says; the first ones otherwise.
export interface ChosenAxes {
  readonly x?: string
  readonly y?: string
}

export const axisKey = ({type, part}: Axis): string => `${type} ${part}`

/// From the firings of the function until `time`, s. Without a choice, y is the first output that varies.
export function functionGraph(
  log: FiringLog,
  name: string,
  time: number,
  chosen: ChosenAxes = {},
): FunctionGraph {
  const firings = log.pieces
    .flatMap(piece => piece.firings)
    .filter(firing => firing.function === name && firing.time <= time)
  const read = firings.map(firing => ({
    firing,
    took: numbersOf(firing.took),
    gave: numbersOf(firing.gave),
  }))
  const inputs = axesOf(read.map(({took}) => took))
  const outputs = axesOf(read.map(({gave}) => gave))
  const valueAt = (numbers: Numbers, axis: Axis | null) =>
    axis === null ? undefined : numbers.find(one => axisKey(one) === axisKey(axis))?.value
  const varies = (axis: Axis, of: "took" | "gave") =>
    new Set(read.map(one => valueAt(one[of], axis)).filter(value => value !== undefined)).size > 1
  const pick = (axes: readonly Axis[], key: string | undefined, of: "took" | "gave") =>
    axes.find(axis => axisKey(axis) === key) ?? axes.find(axis => varies(axis, of)) ?? axes[0] ?? null
  const x = pick(inputs, chosen.x, "took")
  const y = pick(outputs, chosen.y, "gave")

  const cases = new Map<string, {place: number; text: string; points: GraphPoint[]}>()
  let last: (GraphPoint & {readonly in: string}) | null = null
  for (const {firing, took, gave} of read) {
    const at = valueAt(took, x)
    const to = valueAt(gave, y)
    if (at === undefined || to === undefined) continue
    const branch = innermostBranch(firing)
    const key = branch === null ? "" : `${branch.start.line}:${branch.start.column}`
    const found = cases.get(key) ?? {
      place: branch === null ? 0 : branch.start.line * 10_000 + branch.start.column,
      text: branch?.text ?? "",
      points: [],
    }
    cases.set(key, found)
    found.points.push({x: at, y: to})
    last = {x: at, y: to, in: key}
  }
  const inOrder = [...cases].sort(([, a], [, b]) => a.place - b.place)
  return {
    inputs,
    outputs,
    x,
    y,
    cases: inOrder.map(([, {text, points}]) => ({text, points: thinned(points)})),
    now: last === null ? null : {x: last.x, y: last.y, of: inOrder.findIndex(([key]) => key === last.in)},
  }
}

/// The functions of the program that have a graph, as far as it is known: not those of whose latest values none is a number.
export function graphedFunctions(log: FiringLog, names: readonly string[]): readonly string[] {
  const latest = latestFirings(log, Number.POSITIVE_INFINITY)
  return names.filter(name => {
    const firing = latest.get(name)
    if (firing === undefined) return true
    return [firing.took, firing.gave].every(values => values.length > 0 && numbersOf(values).length > 0)
  })
}

type Numbers = readonly (Axis & {readonly value: number})[]

const number = /(?<![\w.])\(?(-?\d+(?:\.\d+)?(?:e-?\d+)?)(?![\w.])/g

type Values = readonly {readonly value: string}[]

/// A graph is drawn anew some times a second, and a firing never changes.
const known = new WeakMap<Values, Numbers>()

/// The numbers in values as Haskell shows them, such as `Velocity (-0.3) 0.0`; a text has none.
function numbersOf(values: Values): Numbers {
  const found = known.get(values) ?? readNumbers(values)
  known.set(values, found)
  return found
}

function readNumbers(values: Values): Numbers {
  const seen = new Set<string>()
  return values.flatMap(({value}) => {
    const type = /^[A-Z]\w*/.exec(value)?.[0] ?? ""
    if (value.includes('"') || seen.has(type)) return []
    seen.add(type)
    const found = [...value.matchAll(number)].map(match => Number(match[1]))
    return found.map((value, part) => ({type, part, parts: found.length, value}))
  })
}

function axesOf(all: readonly Numbers[]): readonly Axis[] {
  const axes = new Map<string, Axis>()
  for (const numbers of all)
    for (const {type, part, parts} of numbers) axes.set(axisKey({type, part, parts}), {type, part, parts})
  return [...axes.values()]
}

/// The case that decided: of nested branches of the function the one that was taken last.
function innermostBranch({function: name, branches}: FiringShown): Branch | null {
  const own = branches.filter(branch => branch.in.includes(name))
  return (own.length > 0 ? own : branches).at(-1) ?? null
}

/// Different points in the order of their inputs, evenly left out where there are more than a graph has room for.
function thinned(points: readonly GraphPoint[]): readonly GraphPoint[] {
  const different = new Map(points.map(point => [`${point.x} ${point.y}`, point]))
  const inOrder = [...different.values()].sort((a, b) => a.x - b.x || a.y - b.y)
  const every = Math.ceil(inOrder.length / mostPoints)
  return every <= 1 ? inOrder : inOrder.filter((_, i) => i % every === 0 || i === inOrder.length - 1)
}
