/// Activity of the diagram while a program runs: which functions have just fired, how often, and the latest values. Its sources are the
/// frames: names of functions, sensed events, channels and memory. Pure.

import {robot} from "@rosy/codegen/robot"
import {commands, states} from "@rosy/codegen/roles"
import type {Frame} from "../../../state/messages/messages.ts"
import {type Network, shortened} from "./network.ts"
import {runningSteps} from "./running_steps.ts"

/// A firing lights a function and its edges this long, in ms of the learner's time.
export const lightMs = 150
/// Values and rates stay this long, in ms of the learner's time, so that they can be read.
export const textMs = 200
/// From this many firings a second on, an edge shows its rate and does not pulse.
const rateFrom = 5
/// Longest value on an edge, in characters.
const longestValue = 24
/// A task is at work for this long after a function in it has fired, in seconds of the run: two ticks of the default rate.
const workSeconds = 0.2
/// The firings of this many seconds of the run make the rate.
const rateWindow = 1

export interface Activity {
  /// When each function was seen to fire last, in ms of the learner's time.
  readonly seen: ReadonlyMap<string, number>
  /// The times of its latest firings, in seconds of the run.
  readonly firings: ReadonlyMap<string, readonly number[]>
  /// The latest value of each type, and since when, in seconds of the run.
  readonly values: ReadonlyMap<string, {readonly value: string; readonly since: number}>
  /// How often the value of each memory has changed.
  readonly writes: ReadonlyMap<string, number>
  /// The names of what fired, in this order; a name that fires again and again alone counts once. The latest ones of a long run.
  readonly trail: readonly string[]
  /// Seconds of the run.
  readonly time: number
  /// The run has ended: no step is at work.
  readonly isOver: boolean
}

/// Names of the trail that are kept.
const longestTrail = 500

export const noActivity: Activity = {
  seen: new Map(),
  firings: new Map(),
  values: new Map(),
  writes: new Map(),
  trail: [],
  time: 0,
  isOver: false,
}

/// The activity after some frames; `now` is the learner's time in ms.
export function observe(before: Activity, frames: readonly Frame[], now: number): Activity {
  const last = frames.at(-1)
  if (last === undefined) return before
  const seen = new Map(before.seen)
  const firings = new Map(before.firings)
  const values = new Map(before.values)
  const writes = new Map(before.writes)
  const trail = [...before.trail]
  const learn = (type: string, value: string, since: number) => {
    const known = values.get(type)?.value
    if (known !== value) values.set(type, {value, since})
    return known !== value
  }
  for (const frame of frames) {
    for (const name of frame.fired) {
      seen.set(name, now)
      if (trail.at(-1) !== name) trail.push(name)
      const recent = (firings.get(name) ?? []).filter(time => time > frame.time - rateWindow)
      firings.set(name, [...recent, frame.time])
    }
    for (const event of frame.sensed)
      values.set(/^\S+/.exec(event)?.[0] ?? event, {value: shortened(event, longest), since: frame.time})
    for (const {type, value} of frame.memory ?? [])
      if (learn(type, value, frame.time)) writes.set(type, (writes.get(type) ?? 0) + 1)
    for (const [channel, content] of Object.entries(frame.channels))
      if (states.has(channel) || commands.has(channel)) learn(channel, valuesOf(channel, content), frame.time)
    learn("Seconds", frame.time.toFixed(1), frame.time)
  }
  return {seen, firings, values, writes, trail: trail.slice(-longestTrail), time: last.time, isOver: false}
}

/// Characters of an event that are shown: a laser scan has thousands.
const longest = 80

const codesOf: {readonly [channel: string]: readonly {readonly [code: string]: string}[]} = robot.codes

/// The values of a state or of a command that lasts, choices by their names. A command with several outputs has the value of each.
function valuesOf(channel: string, content: readonly (number | string)[]): string {
  const codes = codesOf[channel] ?? []
  return content
    .map((value, i) => (codes.length === content.length ? codes[i] : codes.at(-1))?.[value] ?? shown(value))
    .join(" ")
}

const shown = (value: number | string) =>
  typeof value === "string" ? value : Number.isInteger(value) ? `${value}` : value.toFixed(2)

/// Firings per second of the run.
export function rateOf(activity: Activity, name: string): number {
  const times = activity.firings.get(name) ?? []
  return times.filter(time => time > activity.time - rateWindow).length
}

/// Whether a function has fired so lately that its task is the one at work.
function isAtWork(activity: Activity, name: string): boolean {
  const last = activity.firings.get(name)?.at(-1)
  return last !== undefined && activity.time - last < workSeconds
}

/// What is drawn differently at a moment, by node and edge.
export interface Appearance {
  /// Lit functions and edges.
  readonly lit: ReadonlySet<string>
  /// Values and rates on edges.
  readonly onEdges: ReadonlyMap<string, string>
  /// The latest values of sources, stores and commands, whole.
  readonly atNodes: ReadonlyMap<string, string>
}

export function appearanceOf(
  network: Network,
  activity: Activity,
  now: number,
  rateText: (perSecond: number) => string,
): Appearance {
  const lit = new Set<string>()
  const onEdges = new Map<string, string>()
  const atNodes = new Map<string, string>()
  const joins = new Map<string, string>()
  const parents = new Map(network.nodes.map(node => [node.id, node.parent]))
  for (const node of network.nodes) {
    if (node.kind === "either" || node.kind === "all") joins.set(node.id, node.key)
    const value = valueAt(node, activity)
    if (value !== null) atNodes.set(node.id, value)
  }
  const firing = new Map<string, {isLit: boolean; rate: number}>()
  for (const node of network.nodes) {
    if (node.kind !== "function") continue
    const isLit = now - (activity.seen.get(node.key) ?? Number.NEGATIVE_INFINITY) < lightMs
    const rate = rateOf(activity, node.key)
    firing.set(node.id, {isLit, rate})
    if (isLit) lit.add(node.id)
    if (isAtWork(activity, node.key)) for (const id of containersOf(node.parent)) lit.add(id)
  }
  function* containersOf(parent: string | null): Generator<string> {
    for (let id = parent; id !== null; id = parents.get(id) ?? null) yield id
  }
  if (!activity.isOver) for (const id of runningSteps(network, activity)) lit.add(id)
  for (const edge of network.edges) {
    const owner = joins.get(edge.to) ?? joins.get(edge.from)
    const fired =
      firing.get(edge.to) ?? firing.get(edge.from) ?? (owner === undefined ? undefined : firing.get(owner))
    if (fired === undefined || fired.rate === 0) continue
    if (!fired.isLit && fired.rate < rateFrom) continue
    lit.add(edge.id)
    const value = atNodes.get(joins.has(edge.from) || firing.has(edge.from) ? edge.to : edge.from)
    const texts = [fired.rate >= rateFrom ? rateText(fired.rate) : "", shortened(value ?? "", longestValue)]
    const text = texts.filter(one => one !== "").join(" · ")
    if (text !== "") onEdges.set(edge.id, text)
  }
  return {lit, onEdges, atNodes}
}

function valueAt(node: Network["nodes"][number], activity: Activity): string | null {
  if (node.kind === "function" || node.kind === "either" || node.kind === "all") return null
  // The label of a message on a topic of the program is the topic's name.
  if (node.topic !== null) {
    const {name} = node.topic
    const message = name === null ? undefined : activity.values.get(name)
    return message === undefined || name === null ? null : message.value.slice(name.length + 1)
  }
  const found = activity.values.get(node.key)
  if (found === undefined) return null
  if (node.kind === "command") {
    // The channel of Velocity is what the robot measures, not what it was sent.
    return states.has(node.key) ? null : found.value
  }
  return found.value
}

/// Whether something is lit that goes out by itself, or a text is still to be written.
export function isFading(activity: Activity, now: number): boolean {
  for (const at of activity.seen.values()) if (now - at < lightMs + textMs + 50) return true
  return false
}
