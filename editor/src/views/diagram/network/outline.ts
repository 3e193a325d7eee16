/// Diagram as a list for screen readers and tests: one line for each node, with its inputs and outputs. Pure.

import type {DiagramEdge, DiagramNode, Network, NodeKind} from "./network.ts"

/// The words of the list, in the language of the page.
export interface OutlineWords {
  readonly kinds: Readonly<Record<NodeKind, string>>
  /// A function that is carried out once.
  readonly atStart: string
  readonly charts: Readonly<Record<"sequence" | "repeat" | "parallel" | "race" | "choice", string>>
  readonly times: (n: number) => string
  readonly tick: string
  readonly or: string
  readonly and: string
  readonly optional: (one: string) => string
  readonly perhaps: (one: string) => string
  readonly numbered: (n: number, one: string) => string
  readonly triggeredBy: (all: string) => string
  readonly reads: (all: string) => string
  readonly gives: (all: string) => string
  readonly from: (all: string) => string
  readonly goesTo: (all: string) => string
  readonly followedBy: (next: string) => string
  readonly backTo: (first: string) => string
  readonly contested: string
  /// How to see the ways out of a conflict.
  readonly waysOut: string
  readonly folded: string
  /// It led to the answer that is open.
  readonly inAnswer: string
  /// A kind of node with the name of its topic, which is `null` where the program computes it.
  readonly onTopic: (kind: string, topic: string | null) => string
}

export interface OutlineLine {
  readonly id: string
  /// Containers around it.
  readonly depth: number
  readonly text: string
  readonly isMarked: boolean
}

/// `marked`: the nodes that led to the answer of a question.
export function outline(
  network: Network,
  words: OutlineWords,
  marked: ReadonlySet<string> = new Set(),
): readonly OutlineLine[] {
  const reader = new Reader(network, words)
  const lines: OutlineLine[] = []
  const walk = (parent: string | null, depth: number) => {
    for (const node of network.nodes) {
      if (node.parent !== parent || isJoin(node)) continue
      const isMarked = marked.has(node.id)
      const text = reader.line(node)
      lines.push({id: node.id, depth, text: isMarked ? `${text}; ${words.inAnswer}` : text, isMarked})
      walk(node.id, depth + 1)
    }
  }
  walk(null, 0)
  return lines
}

/// The outline as text, two spaces for each container around a line.
export function outlineText(network: Network, words: OutlineWords): string {
  return outline(network, words)
    .map(({depth, text}) => `${"  ".repeat(depth)}${text}\n`)
    .join("")
}

const isJoin = ({kind}: DiagramNode) => kind === "either" || kind === "all"

/// Functions that `simulate` runs have ways out of their conflict.
export const contestedText = ({parent}: DiagramNode, words: OutlineWords): string =>
  parent === null ? `${words.contested}; ${words.waysOut}` : words.contested

class Reader {
  readonly #words: OutlineWords
  readonly #nodes: ReadonlyMap<string, DiagramNode>
  readonly #edges: readonly DiagramEdge[]

  constructor({nodes, edges}: Network, words: OutlineWords) {
    this.#words = words
    this.#nodes = new Map(nodes.map(node => [node.id, node]))
    this.#edges = edges
  }

  line(node: DiagramNode): string {
    const {kinds, charts, times, atStart, folded, onTopic} = this.#words
    const kind =
      node.kind === "chart" && node.chart !== null
        ? node.turns === null
          ? charts[node.chart]
          : times(node.turns)
        : node.trigger === "start"
          ? `${kinds.function}, ${atStart}`
          : node.topic === null
            ? kinds[node.kind]
            : onTopic(kinds[node.kind], node.topic.name)
    const name = this.#name(node)
    const parts = [name === "" ? kind : `${name}: ${kind}`, ...this.#relations(node)]
    if (node.contested) parts.push(contestedText(node, this.#words))
    if (node.folded) parts.push(folded)
    return parts.join("; ")
  }

  #relations(node: DiagramNode): readonly string[] {
    const {triggeredBy, reads, gives, from, goesTo, followedBy, backTo} = this.#words
    const said = (phrase: (all: string) => string, all: readonly string[]) =>
      all.length === 0 ? [] : [phrase(all.join(", "))]
    const led = (role: "then" | "again") => this.#from(node.id).filter(e => e.role === role)
    const ends = [...led("then"), ...led("again")].flatMap(e => e.label ?? [])
    const names = (edges: readonly DiagramEdge[]) => edges.map(e => this.#label(e.to))
    if (node.kind === "function") {
      const inputs = (role: "triggers" | "reads") =>
        this.#to(node.id)
          .filter(e => e.role === role)
          .map(e => this.#input(e))
      return [
        ...said(triggeredBy, inputs("triggers")),
        ...said(reads, inputs("reads")),
        ...said(
          gives,
          this.#from(node.id).map(e => this.#perhaps(e, this.#label(e.to))),
        ),
      ]
    }
    const senders = this.#to(node.id)
      .filter(e => e.role === "sends" || e.role === "writes")
      .map(e => {
        const one = this.#perhaps(e, this.#label(e.from))
        return e.order === null ? one : this.#words.numbered(e.order, one)
      })
    const takers = this.#from(node.id)
      .filter(e => e.role !== "then" && e.role !== "again")
      .map(e => this.#label(this.#owner(e.to)))
    return [
      ...said(from, senders),
      ...said(goesTo, [...new Set(takers)]),
      ...said(gives, [...new Set(ends)]),
      ...said(followedBy, names(led("then"))),
      ...said(backTo, names(led("again"))),
    ]
  }

  /// A source, or what is joined, of an input.
  #input(edge: DiagramEdge): string {
    const source = this.#nodes.get(edge.from)
    const {or, and, optional} = this.#words
    const text =
      source !== undefined && isJoin(source)
        ? `(${this.#to(source.id)
            .map(e => this.#input(e))
            .join(source.kind === "either" ? or : and)})`
        : this.#label(edge.from)
    return edge.optional ? optional(text) : text
  }

  /// The function that a join belongs to.
  #owner(id: string): string {
    const node = this.#nodes.get(id)
    const [next] = node !== undefined && isJoin(node) ? this.#from(id) : []
    return next === undefined ? id : this.#owner(next.to)
  }

  #perhaps(edge: DiagramEdge, text: string): string {
    return edge.perhaps ? this.#words.perhaps(text) : text
  }

  #label(id: string): string {
    const node = this.#nodes.get(id)
    return node === undefined ? "" : this.#name(node) || this.#words.kinds[node.kind]
  }

  #name(node: DiagramNode): string {
    return node.kind === "sample" && node.key === "()" ? this.#words.tick : node.label
  }

  #to = (id: string) => this.#edges.filter(edge => edge.to === id)
  #from = (id: string) => this.#edges.filter(edge => edge.from === id)
}
