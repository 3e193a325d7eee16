/// Connections that are drawn in the diagram: from one end to another, what the program would have to do for them. Pure.

import {uniqueName} from "@rosy/codegen"
import type {NetworkAction} from "@rosy/codegen/network-edits"
import type {NodeKind} from "./network.ts"

/// Where a connection begins or ends. `type` is a type as the program writes it; of a function it is its name.
export interface ConnectionEnd {
  /// A step or a chart has its block as type. `new-step`: a step that is offered; `program`: the free space of the drawing.
  readonly kind: NodeKind | "new-step" | "program"
  readonly type: string
}

/// Type of a memory of which it is not said yet what it remembers.
export const newMemory = "Memory"

/// Whether a function takes both, or one of two events as it comes.
export type Joining = "all" | "either"

export type Connection =
  | {readonly kind: "new-function"; readonly sensor: string; readonly actuator: string}
  | {readonly kind: "input"; readonly function: string; readonly type: string; readonly isEvent: boolean}
  | {readonly kind: "output"; readonly function: string; readonly type: string}
  /// `event` is one that the sender sends already.
  | {readonly kind: "functions"; readonly from: string; readonly to: string; readonly event: string | null}

/// Why two ends are never connected.
export type Misfit = "starts-at-command" | "ends-at-sensor" | "not-here"

/// Whether a drag is about steps of tasks.
export const isAboutSteps = (from: ConnectionEnd, to: ConnectionEnd): boolean =>
  from.kind === "new-step" || (isStepKind(from.kind) && isStepKind(to.kind))

const isStepKind = (kind: ConnectionEnd["kind"]) => kind === "step" || kind === "chart" || kind === "task"

const gives = (kind: ConnectionEnd["kind"]) =>
  kind === "event" || kind === "state" || kind === "sample" || kind === "store" || kind === "channel"

const takes = (kind: ConnectionEnd["kind"]) => kind === "command" || kind === "store" || kind === "channel"

/// `sentBy` gives the program's own events that a function sends.
export function connectionOf(
  from: ConnectionEnd,
  to: ConnectionEnd,
  sentBy: (name: string) => readonly string[],
): Connection | Misfit {
  if (from.kind === "command" || from.kind === "done") return "starts-at-command"
  if (to.kind === "event" || to.kind === "state" || to.kind === "sample") return "ends-at-sensor"
  if (from.kind === "function") {
    if (takes(to.kind)) return {kind: "output", function: from.type, type: to.type}
    if (to.kind !== "function") return "not-here"
    return {kind: "functions", from: from.type, to: to.type, event: sentBy(from.type)[0] ?? null}
  }
  if (!gives(from.kind)) return "not-here"
  if (takes(to.kind)) return {kind: "new-function", sensor: from.type, actuator: to.type}
  if (to.kind !== "function") return "not-here"
  const isEvent = from.kind === "event" || from.kind === "channel"
  return {kind: "input", function: to.type, type: from.type, isEvent}
}

/// What is asked before a connection is made: a name for what is new, and how an event joins the others.
export const asksName = (connection: Connection): "function" | "event" | null =>
  connection.kind === "new-function"
    ? "function"
    : connection.kind === "functions" && connection.event === null
      ? "event"
      : null

export const joinings = (connection: Connection): readonly Joining[] =>
  connection.kind === "functions" || (connection.kind === "input" && connection.isEvent)
    ? ["all", "either"]
    : ["all"]

export function actionOf(connection: Connection, name: string, as: Joining): NetworkAction {
  switch (connection.kind) {
    case "new-function":
      return {
        kind: "connect-sensor-to-actuator",
        sensor: connection.sensor,
        actuator: connection.actuator,
        name,
      }
    case "input":
      return {kind: "add-input", function: connection.function, type: connection.type, as}
    case "output":
      return {kind: "add-output", function: connection.function, type: connection.type}
    default:
      return {
        kind: "connect-functions",
        from: connection.from,
        to: connection.to,
        event: connection.event ?? name,
        as,
      }
  }
}

/// Whether the connection is to or from a new memory.
export const hasNewMemory = (connection: Connection): boolean => Object.values(connection).includes(newMemory)

/// The connection with a type in the place of a new memory's.
export const withMemory = <C extends Connection>(connection: C, type: string): C =>
  Object.fromEntries(
    Object.entries(connection).map(([part, value]) => [part, value === newMemory ? type : value]),
  ) as unknown as C

/// A name for what a connection makes, which nothing has yet; `readyName` gives that of the ready-made function that it is.
export function suggestedName(
  connection: Connection,
  taken: ReadonlySet<string>,
  readyName: (wire: {readonly sensor: string; readonly actuator: string}) => string | undefined,
): string {
  return uniqueName(wantedName(connection, readyName), taken)
}

function wantedName(connection: Connection, readyName: Parameters<typeof suggestedName>[2]): string {
  if (connection.kind === "functions") return `From${capital(connection.from)}`
  if (connection.kind !== "new-function") return ""
  const {sensor, actuator} = connection
  return readyName(connection) ?? (sensor === "()" ? `set${word(actuator)}` : `on${word(sensor)}`)
}

const capital = (name: string) => name.charAt(0).toUpperCase() + name.slice(1)

/// The last word of a type: `Hit` of `Memory Hit`.
const word = (type: string) => capital(/([\p{L}\p{N}_]+)\)*$/u.exec(type)?.[1] ?? "It")

/// When a function fires that takes both of two inputs, or one of two events (rules R1, R2 and R4), for a picture: the second is an event or has a value
/// at all times.
export function firings(
  as: Joining,
  first: readonly number[],
  second: readonly number[],
  isEvent: boolean,
): readonly number[] {
  if (!isEvent) return first
  if (as === "either") return [...first, ...second].sort((a, b) => a - b)
  const found: number[] = []
  let [i, j] = [0, 0]
  while (i < first.length && j < second.length) found.push(Math.max(first[i++] ?? 0, second[j++] ?? 0))
  return found
}
