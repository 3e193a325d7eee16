/// Roles of a function's types in the dataflow diagram: event, state, store or command, and what makes the function fire. Pure.

import {states} from "@rosy/codegen/roles"
import type {ProgramPart, TypeShape} from "../../../program/program_graph.ts"

/// What makes a function fire (rules R1 to R3); a start is carried out once.
export type Trigger = "event" | "state" | "tick" | "start"
export type Leaf = TypeShape & {kind: "type"}
export type LeafKind =
  | "event"
  | "state"
  | "sample"
  | "tick"
  | "store"
  | "channel"
  | "command"
  | "done"
  | "nothing"

/// What a type is as an input or an output (section *Terms* of rosy-hs/LANGUAGE.md).
export function leafKind({spelled, own, topic}: Leaf, side: "input" | "output"): LeafKind {
  const head = /^[^\s]+/.exec(spelled)?.[0] ?? spelled
  if (own) return "channel"
  // Also where the type has the name of one of the robot's.
  if (topic !== null) return side === "input" ? "event" : "command"
  if (head === "Memory" || head === "Param") return "store"
  if (head === "Never" || (spelled === "()" && side === "output")) return "nothing"
  if (side === "output") return head === "Done" ? "done" : "command"
  if (spelled === "()") return "tick"
  if (head === "Seconds" || head === "Clock" || head === "StdGen") return "sample"
  return states.has(head) ? "state" : "event"
}

/// Whether a start does nothing: `()`.
export const isIdle = (part: ProgramPart) =>
  part.kind === "function" && part.inputs.length === 0 && leavesOf(part.output).length === 0

/// The sides of nested `Either`s.
export function sidesOf(shape: TypeShape): readonly TypeShape[] {
  return shape.kind === "either" ? shape.of.flatMap(sidesOf) : [shape]
}

function leavesOf(shape: TypeShape): readonly Leaf[] {
  if (shape.kind === "type") return [shape]
  return shape.kind === "all" || shape.kind === "either" ? shape.of.flatMap(leavesOf) : leavesOf(shape.of)
}

export function uniqueLeaves(shape: TypeShape): readonly Leaf[] {
  const all = leavesOf(shape)
  return all.filter((leaf, i) => all.findIndex(other => other.spelled === leaf.spelled) === i)
}

/// Whether every firing has an output of this type.
export function isCertain(shape: TypeShape, spelled: string): boolean {
  switch (shape.kind) {
    case "type":
      return shape.spelled === spelled
    case "all":
      return shape.of.some(one => isCertain(one, spelled))
    case "either":
      return shape.of.every(one => isCertain(one, spelled))
    default:
      return false
  }
}

export function triggerOf(inputs: readonly TypeShape[], isStart: boolean): Trigger {
  if (isStart) return "start"
  const hasEvent = (shape: TypeShape, inEither: boolean): boolean => {
    if (shape.kind === "all" || shape.kind === "either")
      return shape.of.some(one => hasEvent(one, inEither || shape.kind === "either"))
    if (shape.kind === "maybe" || shape.kind === "each") return hasEvent(shape.of, true)
    const kind = leafKind(shape, "input")
    // What never happens never triggers either.
    return kind === "event" || kind === "channel" || kind === "nothing" || (inEither && kind === "state")
  }
  if (inputs.some(shape => hasEvent(shape, false))) return "event"
  const kinds = inputs.flatMap(leavesOf).map(leaf => leafKind(leaf, "input"))
  const ticks = kinds.includes("tick") || inputs.some(hasMaybe)
  return kinds.includes("state") && !ticks ? "state" : "tick"
}

function hasMaybe(shape: TypeShape): boolean {
  if (shape.kind === "maybe") return true
  return (shape.kind === "all" || shape.kind === "either") && shape.of.some(hasMaybe)
}
