/// What lights up and what edges carry while a program runs.

import {robot} from "@rosy/codegen/robot"
import {heldCommands, odometry, states} from "@rosy/codegen/roles"
import {describe, expect, it} from "vitest"
import type {Frame} from "../../src/state/messages/messages.ts"
import {
  appearanceOf,
  isFading,
  lightMs,
  noActivity,
  observe,
} from "../../src/views/diagram/network/activity.ts"
import type {DiagramNode, Network, NodeKind} from "../../src/views/diagram/network/network.ts"
import {type Leaf, leafKind} from "../../src/views/diagram/network/type_roles.ts"
import {readGraph} from "./graphs.ts"

const frame = (step: number, more: Partial<Frame> = {}): Frame => ({
  run: 1,
  step,
  time: step * 0.02,
  x: 0,
  y: 0,
  theta: 0,
  channels: {},
  fired: [],
  sensed: [],
  boxes: null,
  ghost: null,
  memory: null,
  ...more,
})
const rate = (n: number) => `${n}/s`
const walker = readGraph("randomWalk")
const edge = (from: string, to: string) => walker.edges.find(e => e.from === from && e.to === to)?.id ?? ""

describe("what happens in the diagram", () => {
  it("lights a function and its edges for a moment, with the value that triggered it", () => {
    const hit = frame(10, {fired: ["bumper"], sensed: ["Bumper LeftBumper Pressed"]})
    const activity = observe(noActivity, [hit], 1000)
    const now = appearanceOf(walker, activity, 1000 + lightMs - 1, rate)
    expect(now.lit).toContain("bumper")
    expect(now.lit).toContain(edge("event:Bumper", "bumper"))
    expect(now.lit).not.toContain("wheel")
    // Longer than an edge is wide: the node has the whole.
    expect(now.onEdges.get(edge("event:Bumper", "bumper"))).toBe("Bumper LeftBumper Press…")
    expect(now.atNodes.get("event:Bumper")).toBe("Bumper LeftBumper Pressed")
    expect(isFading(activity, 1000 + lightMs)).toBe(true)
    const later = appearanceOf(walker, activity, 1000 + lightMs, rate)
    expect([...later.lit]).toEqual([])
    expect(later.onEdges.size).toBe(0)
    expect(later.atNodes.get("event:Bumper")).toBe("Bumper LeftBumper Pressed")
    expect(isFading(activity, 5000)).toBe(false)
  })

  it("shows rate and latest value of what fires more than five times a second, without a pulse", () => {
    const frames = Array.from({length: 51}, (_, i) =>
      frame(i, {fired: ["spin"], memory: [{type: "Memory Mode", value: i < 40 ? "Go" : "Stop"}]}),
    )
    const activity = observe(noActivity, frames, 1000)
    const later = appearanceOf(walker, activity, 1000 + lightMs, rate)
    expect(later.lit).not.toContain("spin")
    expect(later.onEdges.get(edge("store:Memory Mode", "spin"))).toBe("50/s · Stop")
    expect(activity.writes.get("Memory Mode")).toBe(2)
    expect(activity.values.get("Memory Mode")?.since).toBeCloseTo(0.8, 9)
    // A second without firings ends it.
    const silent = observe(activity, [frame(110)], 3000)
    expect(appearanceOf(walker, silent, 3000, rate).onEdges.size).toBe(0)
  })

  it("shows the lights that a command has switched, and no value that frames do not tell", () => {
    const activity = observe(noActivity, [frame(1, {channels: {Led1: [2], Velocity: [0.5, 0]}})], 0)
    const {atNodes} = appearanceOf(walker, activity, 0, rate)
    expect(atNodes.get("command:Led1")).toBe("Orange")
    expect(atNodes.has("command:Velocity")).toBe(false)
  })

  /// A value of each leaf of a channel, as frames have it: the last code of a choice, or a number; and the text that is shown.
  function sample(channel: string): {content: number[]; text: string} {
    const codes = (robot.codes as {[channel: string]: readonly {[code: string]: string}[]})[channel]
    if (codes === undefined) return {content: [1.25], text: "1.25"}
    const chosen = codes.map(names => Object.entries(names).at(-1) ?? ["7", "7"])
    return {content: chosen.map(([code]) => Number(code)), text: chosen.map(([, name]) => name).join(" ")}
  }
  const only = (kind: NodeKind, key: string): Network => ({
    nodes: [{...(walker.nodes[0] as DiagramNode), id: "one", kind, key, topic: null}],
    edges: [],
  })
  const measured = [...states].filter(state => state === "Velocity" || !odometry.has(state))

  it.each([...states])("takes %s as a state", state => {
    expect(leafKind({kind: "type", spelled: state, own: false, topic: null} as Leaf, "input")).toBe("state")
  })

  it.each(measured)("shows the value of the state %s, choices by their names", state => {
    const {content, text} = sample(state)
    const activity = observe(noActivity, [frame(1, {channels: {[state]: content}})], 0)
    expect(appearanceOf(only("state", state), activity, 0, rate).atNodes.get("one")).toBe(text)
  })

  it.each([...heldCommands].filter(command => !states.has(command)))(
    "shows what %s was last sent",
    command => {
      const {content, text} = sample(command)
      const activity = observe(noActivity, [frame(1, {channels: {[command]: content}})], 0)
      expect(appearanceOf(only("command", command), activity, 0, rate).atNodes.get("one")).toBe(text)
    },
  )

  it("shows each output of a command that has several", () => {
    const activity = observe(noActivity, [frame(1, {channels: {ExternalPower: [1, 0, 1, 1]}})], 0)
    const {atNodes} = appearanceOf(only("command", "ExternalPower"), activity, 0, rate)
    expect(atNodes.get("one")).toBe("PowerOn PowerOff PowerOn PowerOn")
  })

  it("lights the task at work, with all that is around it", () => {
    const square = readGraph("drawSquare")
    const moving = observe(noActivity, [frame(5, {fired: ["runMove"]})], 0)
    const tasks = (lit: ReadonlySet<string>) =>
      square.nodes.filter(n => n.kind === "task" && lit.has(n.id)).map(n => n.label)
    expect(tasks(appearanceOf(square, moving, 0, rate).lit)).toEqual(["move"])
    const turning = observe(moving, [frame(30, {fired: ["runTurn"]})], 500)
    expect(tasks(appearanceOf(square, turning, 500, rate).lit)).toEqual(["turn"])
    expect(appearanceOf(square, turning, 500, rate).lit).toContain("drawSquare")
  })

  it("shows the latest message of a topic of the program, not the robot's value of the same name", () => {
    const network = readGraph("own-topics")
    const told = frame(3, {
      sensed: ['/mobile_base/sensors/core {"battery":120}'],
      channels: {Battery: [16.1]},
    })
    const now = appearanceOf(network, observe(noActivity, [told], 0), 0, rate)
    expect(now.atNodes.get("event:Battery")).toBe('{"battery":120}')
    expect(now.atNodes.get("event:Level")).toBeUndefined()
  })
})
