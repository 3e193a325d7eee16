/// Structures of diagrams: those of the examples, and one for each kind of input, output, store, task and chart. `protocol/goldens/graphs` holds what the
/// compiler reports, `structures/*.txt` the nodes with their edges, as the page lists them.

import {join} from "node:path"
import {describe, expect, it} from "vitest"
import {diagram} from "../../../languages/en/page/diagram.ts"
import {type ProgramPart, programParts} from "../../src/program/program_graph.ts"
import {firstFolds, fold} from "../../src/views/diagram/network/network.ts"
import {networkOf} from "../../src/views/diagram/network/network_builder.ts"
import {outlineText} from "../../src/views/diagram/network/outline.ts"
import {decode} from "../../src/wire/decode.ts"
import {graphNames, readGraph} from "./graphs.ts"

const names = graphNames()

describe("the structure of the diagram", () => {
  it.each(names)("of %s", async name => {
    const text = outlineText(readGraph(name), diagram.list)
    await expect(text).toMatchFileSnapshot(join(import.meta.dirname, "structures", `${name}.txt`))
  })

  it.each(names)(
    "of %s: every edge joins two nodes of one scope, and no node is alone in its kind of input",
    name => {
      const {nodes, edges} = readGraph(name)
      const parents = new Map(nodes.map(node => [node.id, node.parent]))
      expect(new Set(nodes.map(node => node.id)).size).toBe(nodes.length)
      for (const edge of edges) {
        expect(parents.has(edge.from) && parents.has(edge.to)).toBe(true)
        expect(parents.get(edge.from)).toBe(parents.get(edge.to))
      }
      // A source, a store or a sink exists because something is connected to it.
      const connected = new Set(edges.flatMap(edge => [edge.from, edge.to]))
      const free = new Set(["function", "task", "chart", "step"])
      for (const node of nodes) if (!free.has(node.kind)) expect(connected).toContain(node.id)
    },
  )

  it("hides what is inside of a folded container, and folds when there are more than forty nodes", () => {
    const network = readGraph("drawSquare")
    const tasks = network.nodes.filter(node => node.kind === "task")
    const folded = fold(network, new Set(tasks.map(node => node.id)))
    expect(folded.nodes.filter(node => node.folded).map(node => node.label)).toEqual(["move", "turn"])
    expect(folded.nodes.map(node => node.kind)).not.toContain("function")
    expect(firstFolds(network).size).toBe(0)
    const many = {...network, nodes: Array.from({length: 10}, () => network.nodes).flat()}
    expect(firstFolds(many).size).toBeGreaterThan(0)
  })

  it("says where a graph of the compiler is not what it should be", () => {
    const broken = {
      parts: [{kind: "function", name: "f", inputs: [{either: [{typo: "Bumper"}]}], output: {all: []}}],
    }
    expect(decode(programParts, broken)).toEqual({
      kind: "mismatch",
      message: "at parts[0].inputs[0].either[0].type: expected text",
    })
    const unknown = decode(programParts, {parts: [{kind: "loop", name: "f"}]})
    expect(unknown).toEqual({kind: "mismatch", message: "at parts[0].kind: expected a kind of part"})
  })

  it("a command is in conflict where the program says so, and in tasks where several functions keep sending it", () => {
    const type = (written: string) =>
      ({kind: "type", written, spelled: written, own: false, topic: null}) as const
    const fn = (name: string, input: string) =>
      ({kind: "function", name, at: null, inputs: [type(input)], output: type("Velocity")}) as const
    const both = [fn("go", "Seconds"), fn("follow", "Light")]
    const contested = (conflicts: ReadonlySet<string> | null, parts: readonly ProgramPart[]) =>
      networkOf(parts, () => "", conflicts).nodes.flatMap(n => (n.contested ? [n.key] : []))
    const ticking = [fn("go", "Seconds"), fn("turn", "Clock")]
    expect(contested(new Set(["Velocity"]), both)).toEqual(["Velocity"])
    // One goes before the other: there is no conflict, although both keep sending.
    expect(contested(new Set(), ticking)).toEqual([])
    expect(contested(null, ticking)).toEqual(["Velocity"])
    const task = {kind: "task", name: "move", at: null, start: [], parts: ticking} as const
    expect(contested(new Set(), [task])).toEqual(["Velocity"])
  })

  it("labels what has no name with its text", () => {
    const at = {line: 1, column: 17, endLine: 1, endColumn: 60}
    const parts = [
      {kind: "function", name: "the function at line 1", at, inputs: [], output: {kind: "all", of: []}},
    ] as const
    const network = networkOf(parts, () => "\\(Bumper side Pressed) ->\n   Velocity (-0.5) 0")
    expect(network.nodes.find(node => node.kind === "function")).toMatchObject({
      label: "\\(Bumper side Pressed) …",
      key: "the function at line 1",
    })
  })
})
