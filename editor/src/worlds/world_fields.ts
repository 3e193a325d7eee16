/// Fields of a world in JSON: each is read with its limits, or refused with its path, as in `sim-service/rosy_sim/world/field_readers.py`.

import {limits, type Spot} from "./world.ts"

/// What is wrong with a world, and where: `boxes[2].w`. The path is empty when it is about the whole.
export interface Fault {
  readonly path: string
  readonly why: string
}

export class Wrong extends Error {
  readonly fault: Fault
  constructor(path: string, why: string) {
    super(why)
    this.fault = {path, why}
  }
}

export type Fields = {readonly [key: string]: unknown}

export const field = (fields: Fields, key: string): unknown => fields[key]

export function record(value: unknown, path: string): Fields {
  if (typeof value !== "object" || value === null || Array.isArray(value))
    throw new Wrong(
      path,
      path === ""
        ? 'this is no world; a world looks like {"size": [5, 4], "start": {"x": 1, "y": 1}}.'
        : 'expected named values in curly brackets, such as {"x": 1, "y": 1}.',
    )
  return value as Fields
}

export function text(fields: Fields, key: string, why: string, path = ""): string {
  const value = or(fields[key], "")
  if (typeof value !== "string") throw new Wrong(path === "" ? key : `${path}.${key}`, why)
  return value
}

/// Numbers beyond this are no lengths or angles of a room.
const tooLarge = 1e6

export function number(value: unknown, path: string): number {
  if (typeof value !== "number")
    throw new Wrong(
      path,
      value === undefined || value === null ? "this number is missing." : "expected a number.",
    )
  if (!(Number.isFinite(value) && Math.abs(value) < tooLarge))
    throw new Wrong(path, "the number is too large.")
  return value
}

export const required = (fields: Fields, key: string, path: string) => number(fields[key], `${path}.${key}`)

export function length(fields: Fields, key: string, path: string, most: number = limits.length[1]): number {
  const value = required(fields, key, path)
  if (!within(value, [limits.length[0], most]))
    throw new Wrong(`${path}.${key}`, `it must be between ${limits.length[0]} and ${most}.`)
  return value
}

export function flag(fields: Fields, key: string, path = "", missing = false): boolean {
  const value = or(fields[key], missing)
  if (typeof value !== "boolean")
    throw new Wrong(path === "" ? key : `${path}.${key}`, "expected true or false.")
  return value
}

export function items(fields: Fields, key: string, path = ""): readonly (readonly [unknown, string])[] {
  const where = path === "" ? key : `${path}.${key}`
  const value = or(fields[key], [])
  if (!Array.isArray(value)) throw new Wrong(where, "expected a list.")
  return value.map((item: unknown, i) => [item, `${where}[${i}]`] as const)
}

export function spot(value: unknown, path: string): Spot {
  if (value === undefined || value === null) throw new Wrong(path, "this point is missing.")
  if (!Array.isArray(value) || value.length !== 2)
    throw new Wrong(path, "expected a point: two numbers, x and y.")
  return [number(value[0], `${path}[0]`), number(value[1], `${path}[1]`)]
}

export function spots(fields: Fields, path: string, least: number): readonly Spot[] {
  const found = items(fields, "points", path).map(([value, where]) => spot(value, where))
  if (!(found.length >= least && found.length <= limits.points))
    throw new Wrong(`${path}.points`, `expected at least ${least} and at most ${limits.points} points.`)
  return found
}

/// Only what is not there has a default: `null` is a mistake.
export const or = (value: unknown, absent: unknown) => (value === undefined ? absent : value)
export const within = (value: number, [least, most]: readonly [number, number]) =>
  value >= least && value <= most
/// A number as Python's `:g` writes it, for the sizes that occur here.
export const short = (value: number) => String(Number(value.toPrecision(6)))
