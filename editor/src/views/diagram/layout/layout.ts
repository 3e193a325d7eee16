/// Layout of the diagram: the engine places the nodes of each scope, from the innermost outwards; a chart of steps is stacked in rows or columns.

import {type DiagramEdge, type DiagramNode, isContainer, type Network} from "../network/network.ts"
import {type Box, inset, type Point, sizeOf, titleHeight} from "./geometry.ts"
import {joinLayouts, type ScopeLayout, withMoved} from "./stable_positions.ts"

/// The part of an ELK graph that is used (https://eclipse.dev/elk/documentation/tooldevelopers/graphdatastructure/jsonformat.html).
export interface ElkGraph {
  readonly id: string
  readonly width?: number
  readonly height?: number
  readonly x?: number
  readonly y?: number
  readonly layoutOptions?: {readonly [option: string]: string}
  readonly children?: readonly ElkGraph[]
  readonly edges?: readonly {
    readonly id: string
    readonly sources: readonly string[]
    readonly targets: readonly string[]
    readonly sections?: readonly {
      readonly startPoint: Point
      readonly endPoint: Point
      readonly bendPoints?: readonly Point[]
    }[]
  }[]
}

/// Gives a graph its positions.
export type Engine = (graph: ElkGraph) => Promise<ElkGraph>

export interface Layout {
  /// Positions within each scope, to keep them in the next layout; the program's own scope is `""`.
  readonly scopes: ReadonlyMap<string, ScopeLayout>
  /// Positions in the whole drawing.
  readonly boxes: ReadonlyMap<string, Box>
  readonly routes: ReadonlyMap<string, readonly Point[]>
  readonly width: number
  readonly height: number
}

/// Space between the steps of a chart, and beside them for the arrow that leads back.
const stepGap = 26
const loopGap = 20

/// `moved`: the places that the learner gave to nodes, each in its scope; those of other nodes are ignored.
export async function layOut(
  network: Network,
  before: Layout | null,
  engine: Engine,
  moved: ReadonlyMap<string, Point> = new Map(),
): Promise<Layout> {
  const scopes = new Map<string, ScopeLayout>()
  const inside = (parent: string | null) => network.nodes.filter(node => node.parent === parent)

  const layScope = async (parent: DiagramNode | null): Promise<{w: number; h: number}> => {
    const nodes = inside(parent?.id ?? null)
    const sizes = new Map<string, {w: number; h: number}>()
    for (const node of nodes) {
      const isOpen = isContainer(node) && !node.folded
      const inner = isOpen ? await layScope(node) : {w: 0, h: 0}
      const own = sizeOf(node)
      const around = {w: Math.max(own.w, inner.w + 2 * inset), h: inner.h + titleHeight + inset}
      sizes.set(node.id, isOpen ? around : own)
    }
    const ids = new Set(nodes.map(node => node.id))
    const edges = network.edges.filter(edge => ids.has(edge.from) && ids.has(edge.to))
    const key = parent?.id ?? ""
    const scope =
      parent?.kind === "chart"
        ? stacked(parent, nodes, sizes, edges)
        : withMoved(
            joinLayouts(before?.scopes.get(key), await networkLayout(nodes, sizes, edges, engine), edges),
            moved,
            edges,
          )
    scopes.set(key, scope)
    return extentOf(scope)
  }
  const {w, h} = await layScope(null)
  return {scopes, ...absolute(network, scopes), width: w, height: h}
}

async function networkLayout(
  nodes: readonly DiagramNode[],
  sizes: ReadonlyMap<string, {w: number; h: number}>,
  edges: readonly DiagramEdge[],
  engine: Engine,
): Promise<ScopeLayout> {
  if (nodes.length === 0) return {boxes: new Map(), routes: new Map()}
  const laid = await engine({
    id: "scope",
    layoutOptions: scopeOptions,
    children: nodes.map(node => ({
      id: node.id,
      width: sizes.get(node.id)?.w ?? 0,
      height: sizes.get(node.id)?.h ?? 0,
      layoutOptions: nodeOptions(node),
    })),
    edges: edges.map(({id, from, to}) => ({id, sources: [from], targets: [to]})),
  })
  const boxes = new Map(
    (laid.children ?? []).map(c => [c.id, {x: c.x ?? 0, y: c.y ?? 0, w: c.width ?? 0, h: c.height ?? 0}]),
  )
  const routes = new Map(
    (laid.edges ?? []).map(({id, sections}) => {
      const points = (sections ?? []).flatMap(s => [s.startPoint, ...(s.bendPoints ?? []), s.endPoint])
      return [id, points] as const
    }),
  )
  return {boxes, routes}
}

/// Left to right; a feedback runs back below. Nodes and edges keep the order of the program where nothing speaks against it.
const scopeOptions = {
  "elk.algorithm": "layered",
  "elk.direction": "RIGHT",
  "elk.edgeRouting": "ORTHOGONAL",
  "elk.layered.feedbackEdges": "true",
  "elk.layered.considerModelOrder.strategy": "NODES_AND_EDGES",
  "elk.spacing.nodeNode": "26",
  "elk.spacing.edgeNode": "14",
  "elk.spacing.edgeEdge": "9",
  "elk.spacing.componentComponent": "38",
  "elk.layered.spacing.nodeNodeBetweenLayers": "46",
  "elk.layered.spacing.edgeNodeBetweenLayers": "14",
  "elk.padding": "[top=4,left=4,bottom=24,right=4]",
}

function nodeOptions({kind}: DiagramNode): {readonly [option: string]: string} {
  if (kind === "event" || kind === "state") return {"elk.layered.layering.layerConstraint": "FIRST"}
  if (kind === "command" || kind === "done") return {"elk.layered.layering.layerConstraint": "LAST"}
  return {}
}

/// The steps of a chart: rows, or columns where they run side by side.
function stacked(
  chart: DiagramNode,
  nodes: readonly DiagramNode[],
  sizes: ReadonlyMap<string, {w: number; h: number}>,
  edges: readonly DiagramEdge[],
): ScopeLayout {
  const isBeside = chart.chart === "parallel" || chart.chart === "race"
  const boxes = new Map<string, Box>()
  let next = 0
  for (const {id} of nodes) {
    const size = sizes.get(id) ?? {w: 0, h: 0}
    boxes.set(id, isBeside ? {x: next, y: 0, ...size} : {x: 0, y: next, ...size})
    next += (isBeside ? size.w : size.h) + stepGap
  }
  const routes = new Map<string, readonly Point[]>()
  for (const {id, from, to, role} of edges) {
    const [a, b] = [boxes.get(from), boxes.get(to)]
    if (a === undefined || b === undefined) continue
    if (role === "again") {
      routes.set(id, routeBack(a, b, Math.max(...[...boxes.values()].map(box => box.x + box.w)) + loopGap))
      continue
    }
    const x = Math.min(a.w, b.w) / 2
    routes.set(id, [
      {x, y: a.y + a.h},
      {x, y: b.y},
    ])
  }
  return {boxes, routes}
}

/// From the right side of the last step around all to the right side of the first: to itself, where there is one.
function routeBack(last: Box, first: Box, x: number): readonly Point[] {
  const isSame = last === first
  const low = last.y + (isSame ? (3 * last.h) / 4 : last.h / 2)
  const high = first.y + (isSame ? first.h / 4 : first.h / 2)
  return [
    {x: last.x + last.w, y: low},
    {x, y: low},
    {x, y: high},
    {x: first.x + first.w, y: high},
  ]
}

function extentOf({boxes, routes}: ScopeLayout): {w: number; h: number} {
  let [w, h] = [0, 0]
  for (const box of boxes.values()) [w, h] = [Math.max(w, box.x + box.w), Math.max(h, box.y + box.h)]
  for (const route of routes.values()) for (const {x, y} of route) [w, h] = [Math.max(w, x), Math.max(h, y)]
  return {w, h}
}

/// The positions of all scopes in one drawing.
function absolute(
  network: Network,
  scopes: ReadonlyMap<string, ScopeLayout>,
): Pick<Layout, "boxes" | "routes"> {
  const boxes = new Map<string, Box>()
  const routes = new Map<string, readonly Point[]>()
  const walk = (parent: string | null, x: number, y: number) => {
    const scope = scopes.get(parent ?? "")
    if (scope === undefined) return
    const moved = <T extends Point>(at: T): T => ({...at, x: at.x + x, y: at.y + y})
    for (const [id, route] of scope.routes) routes.set(id, route.map(moved))
    for (const node of network.nodes.filter(n => n.parent === parent)) {
      const box = scope.boxes.get(node.id)
      if (box === undefined) continue
      boxes.set(node.id, moved(box))
      if (isContainer(node) && !node.folded) walk(node.id, x + box.x + inset, y + box.y + titleHeight)
    }
  }
  walk(null, 0, 0)
  return {boxes, routes}
}
