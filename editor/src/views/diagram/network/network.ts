/// Structure of the dataflow diagram: nodes, edges and containment, and which containers are folded. Pure.
///
/// Every scope (the program, a running task) has its own sources, stores and sinks, so a container is complete in itself and can be
/// folded. An edge never leaves its scope; an event of the program's own that another scope takes is a node of the same name there.

import type {BlockId} from "@rosy/codegen"
import type {ChartKind, Extent, TopicName} from "../../../program/program_graph.ts"
import type {Trigger} from "./type_roles.ts"

export type NodeKind =
  /// Something that happens to the robot, and a quantity that it always has.
  | "event"
  | "state"
  /// A value that can be read at any time; the tick of the default-rate clock.
  | "sample"
  | "function"
  /// `Memory` or `Param`.
  | "store"
  /// An event of the program's own.
  | "channel"
  | "command"
  /// The end of the task.
  | "done"
  /// A dot where the sides of an `Either` meet, a bar where the parts of a tuple join.
  | "either"
  | "all"
  | "task"
  | "chart"
  /// A task that is not composed further.
  | "step"

export interface DiagramNode {
  readonly id: string
  /// The container that it is in; `null` in the program itself.
  readonly parent: string | null
  readonly kind: NodeKind
  readonly label: string
  /// The type without synonyms, or the name under which a function fires.
  readonly key: string
  readonly at: Extent | null
  /// Of a step or a chart that can be changed: its block in the program.
  readonly block: BlockId | null
  readonly trigger: Trigger | null
  readonly chart: ChartKind | null
  readonly turns: number | null
  /// Where the program itself says where the values come from or go to.
  readonly topic: TopicName | null
  /// A command over which functions are in conflict.
  readonly contested: boolean
  readonly folded: boolean
}

/// `then` leads to the next step, `again` from the last step of a loop to its first.
export type EdgeRole = "triggers" | "reads" | "sends" | "writes" | "then" | "again"

export interface DiagramEdge {
  readonly id: string
  readonly from: string
  readonly to: string
  readonly role: EdgeRole
  /// A `Maybe` input: the function fires without it, too.
  readonly optional: boolean
  /// An output that not every firing has.
  readonly perhaps: boolean
  /// Place among the senders of a command; `null` when there is one.
  readonly order: number | null
  /// How the step that it leaves ends: the name of its result, or the type of its `Done`.
  readonly label: string | null
}

export interface Network {
  readonly nodes: readonly DiagramNode[]
  readonly edges: readonly DiagramEdge[]
}

/// The node whose value an edge carries: a source or a store before a function; a command, an event or a store behind it.
export function valuedNode({nodes}: Network, {from, to}: DiagramEdge): string {
  const kind = nodes.find(node => node.id === from)?.kind
  return kind === "either" || kind === "all" || kind === "function" ? to : from
}

/// A text on one line, cut at `longest` characters.
export function shortened(text: string, longest: number): string {
  const line = text.replace(/\s+/g, " ").trim()
  return line.length <= longest ? line : `${line.slice(0, longest - 1)}…`
}

/// Nodes from which on a diagram opens with its containers folded.
const foldedFrom = 40

/// The network without what is inside of the given containers.
export function fold(network: Network, folded: ReadonlySet<string>): Network {
  const byId = new Map(network.nodes.map(node => [node.id, node]))
  const isHidden = (node: DiagramNode): boolean => {
    if (node.parent === null) return false
    const parent = byId.get(node.parent)
    return folded.has(node.parent) || (parent !== undefined && isHidden(parent))
  }
  const nodes = network.nodes.filter(node => !isHidden(node))
  const kept = new Set(nodes.map(node => node.id))
  return {
    nodes: nodes.map(node => (folded.has(node.id) ? {...node, folded: true} : node)),
    edges: network.edges.filter(edge => kept.has(edge.from) && kept.has(edge.to)),
  }
}

export const isContainer = (node: Pick<DiagramNode, "kind">): boolean =>
  node.kind === "task" || node.kind === "chart"

/// The containers to fold at first: the outermost tasks and charts, when there is more than fits.
export function firstFolds(network: Network): ReadonlySet<string> {
  if (network.nodes.length <= foldedFrom) return new Set()
  const charts = new Set(network.nodes.filter(n => n.kind === "chart").map(n => n.id))
  // A chart around all of the program stays open: its steps are what there is to see.
  const isOuter = (n: DiagramNode) => n.parent === null || charts.has(n.parent)
  const tasks = network.nodes.filter(n => n.kind === "task" && isOuter(n))
  return new Set(tasks.map(n => n.id))
}

export const isJoin = (network: Network, id: string) => {
  const kind = network.nodes.find(node => node.id === id)?.kind
  return kind === "either" || kind === "all"
}

export const firstOf = (network: Network) =>
  network.nodes.find(node => node.kind !== "either" && node.kind !== "all")
