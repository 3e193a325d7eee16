/// Layouts by the real engine: no two nodes overlap, what is inside of a container is drawn inside, and an edit moves nothing that it does not change.

import ELK, {type ElkNode} from "elkjs/lib/elk.bundled.js"
import fc from "fast-check"
import {describe, expect, it} from "vitest"
import {cases, seed} from "../../../codegen/test/extent.ts"
import {type Box, overlaps} from "../../src/views/diagram/layout/geometry.ts"
import {type ElkGraph, type Engine, type Layout, layOut} from "../../src/views/diagram/layout/layout.ts"
import {isContainer, type Network} from "../../src/views/diagram/network/network.ts"
import {networkOf} from "../../src/views/diagram/network/network_builder.ts"
import {graphNames, readGraph} from "./graphs.ts"
import {anyFunction, anyProgram} from "./random_programs.ts"

const elk = new ELK()
const engine: Engine = graph => elk.layout(structuredClone(graph) as ElkNode) as Promise<ElkGraph>

const network = (parts: Parameters<typeof networkOf>[0]) => networkOf(parts, () => "")

function expectSound({nodes}: Network, {boxes, width, height}: Layout): void {
  for (const node of nodes) {
    const box = boxes.get(node.id)
    expect(box, node.id).toBeDefined()
    if (box === undefined) continue
    expect(
      box.x >= 0 && box.y >= 0 && box.x + box.w <= width + 1 && box.y + box.h <= height + 1,
      node.id,
    ).toBe(true)
    const around = node.parent === null ? undefined : boxes.get(node.parent)
    if (around !== undefined) expect(isWithin(box, around), `${node.id} in ${node.parent}`).toBe(true)
    for (const other of nodes) {
      if (other.id <= node.id || other.parent !== node.parent) continue
      const taken = boxes.get(other.id)
      expect(taken !== undefined && overlaps(box, taken), `${node.id} and ${other.id}`).toBe(false)
    }
  }
}

const isWithin = (box: Box, around: Box) =>
  box.x >= around.x &&
  box.y >= around.y &&
  box.x + box.w <= around.x + around.w &&
  box.y + box.h <= around.y + around.h

describe("the layout", () => {
  it.each(graphNames())("of %s has no overlapping nodes, and an edge for each relation", async name => {
    const graph = readGraph(name)
    const layout = await layOut(graph, null, engine)
    expectSound(graph, layout)
    expect([...layout.routes.keys()].sort()).toEqual(graph.edges.map(edge => edge.id).sort())
  })

  it("has sources at the left of functions and commands at the right of them", async () => {
    const graph = readGraph("randomWalk")
    const {boxes} = await layOut(graph, null, engine)
    const at = (kind: string) => graph.nodes.filter(n => n.kind === kind).map(n => boxes.get(n.id)?.x ?? 0)
    expect(Math.max(...at("event"))).toBeLessThan(Math.min(...at("function")))
    expect(Math.min(...at("command"))).toBeGreaterThan(Math.max(...at("function")))
  })

  it("of random programs has no overlapping nodes, also after edits of one function", {
    timeout: 600_000,
  }, async () => {
    await fc.assert(
      fc.asyncProperty(anyProgram, anyFunction, async (parts, changed) => {
        const before = network(parts)
        const first = await layOut(before, null, engine)
        expectSound(before, first)
        const after = network([...parts.slice(0, 1), changed, ...parts.slice(2)])
        const second = await layOut(after, first, engine)
        expectSound(after, second)
        // What stays, and is of the same size, stays where it is in its scope.
        for (const [scope, {boxes}] of second.scopes)
          for (const [id, box] of boxes) {
            const was = first.scopes.get(scope)?.boxes.get(id)
            if (was !== undefined && was.w === box.w && was.h === box.h && !isInChart(after, scope))
              expect(box, id).toEqual(was)
          }
        // Nothing has changed: nothing moves.
        expect(await layOut(after, second, engine)).toEqual(second)
      }),
      {numRuns: cases(10), seed},
    )
  })

  it("has a moved node where it was moved to, covers nothing, and ignores nodes that are gone", async () => {
    const graph = readGraph("randomWalk")
    const first = await layOut(graph, null, engine)
    const moved = new Map([
      ["gone", {x: 5, y: 5}],
      ["chgdir", {x: 0, y: 0}],
    ])
    const second = await layOut(graph, first, engine, moved)
    expectSound(graph, second)
    expect(second.boxes.get("chgdir")).toMatchObject({x: 0, y: 0})
    // A wire ends at the node; what is not in the way stays.
    for (const {id, from} of graph.edges)
      if (from === "chgdir") {
        const {x = 0, y = 0, w = 0, h = 0} = second.boxes.get(from) ?? {}
        expect(second.routes.get(id)?.[0]).toEqual({x: x + w, y: y + h / 2})
      }
    const moves = graph.nodes.filter(n => second.boxes.get(n.id)?.y !== first.boxes.get(n.id)?.y)
    expect(moves.length).toBeLessThan(graph.nodes.length)
    // Opened again, from nothing but the program and the places.
    const again = await layOut(graph, null, engine, moved)
    expect(again.boxes.get("chgdir")).toMatchObject({x: 0, y: 0})
    expectSound(graph, again)
  })

  it("puts a renamed function where it was under its former name", async () => {
    const graph = readGraph("randomWalk")
    const before = await layOut(graph, null, engine)
    const rename = (id: string) => id.replace(/\bchgdir\b/g, "turned")
    const renamed: Network = {
      nodes: graph.nodes.map(n => ({...n, id: rename(n.id), label: rename(n.label)})),
      edges: graph.edges.map(e => ({...e, id: rename(e.id), from: rename(e.from), to: rename(e.to)})),
    }
    const after = await layOut(renamed, before, engine)
    expect(after.boxes.get("turned")).toEqual(before.boxes.get("chgdir"))
  })
})

const isInChart = (graph: Network, scope: string) =>
  graph.nodes.some(node => node.id === scope && isContainer(node) && node.kind === "chart")
