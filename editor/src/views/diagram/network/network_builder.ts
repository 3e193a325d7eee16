/// Builder of the dataflow network from the parts that the compiler reports. Pure.

import type {Extent, ProgramPart, TypeShape} from "../../../program/program_graph.ts"
import {type MemoryName, memoryNames} from "../../../program/written_memories.ts"
import {
  type DiagramEdge,
  type DiagramNode,
  type EdgeRole,
  type Network,
  type NodeKind,
  shortened,
} from "./network.ts"
import {
  isCertain,
  isIdle,
  type Leaf,
  type LeafKind,
  leafKind,
  sidesOf,
  type Trigger,
  triggerOf,
  uniqueLeaves,
} from "./type_roles.ts"

type FunctionPart = ProgramPart & {kind: "function"}

/// Longest label of a node without a name, in characters.
const longestLabel = 24

/// `textAt` is the program's text at a place; it is the label of functions and steps without a name. `conflicts` are the commands over which functions
/// that `simulate` runs are in conflict; in tasks, and where that is not known (`null`), those that several functions keep sending count.
export function networkOf(
  parts: readonly ProgramPart[],
  textAt: (at: Extent) => string,
  conflicts: ReadonlySet<string> | null = null,
): Network {
  const build = new Builder(textAt, memoryNames({parts}))
  build.scope(null, [], parts)
  return build.network(conflicts)
}

class Builder {
  readonly #textAt: (at: Extent) => string
  readonly #memoryName: MemoryName
  readonly #nodes = new Map<string, DiagramNode>()
  readonly #edges = new Map<string, DiagramEdge>()

  constructor(textAt: (at: Extent) => string, memoryName: MemoryName) {
    this.#textAt = textAt
    this.#memoryName = memoryName
  }

  scope(parent: string | null, starts: readonly ProgramPart[], parts: readonly ProgramPart[]): void {
    for (const part of starts) if (!isIdle(part)) this.#part(parent, part, true)
    for (const part of parts) this.#part(parent, part, false)
  }

  network(conflicts: ReadonlySet<string> | null): Network {
    const edges = [...this.#edges.values()]
    const senders = (id: string) => edges.filter(e => e.to === id && e.role === "sends")
    const repeats = (e: DiagramEdge) => {
      const trigger = this.#nodes.get(e.from)?.trigger
      return !e.perhaps && (trigger === "state" || trigger === "tick")
    }
    const isContested = ({id, key, parent}: DiagramNode) =>
      parent === null && conflicts !== null ? conflicts.has(key) : senders(id).filter(repeats).length > 1
    const nodes = [...this.#nodes.values()].map(node =>
      node.kind === "command" ? {...node, contested: isContested(node)} : node,
    )
    const commands = new Set(nodes.filter(n => n.kind === "command").map(n => n.id))
    const numbered = edges.map(edge => {
      const all = commands.has(edge.to) ? senders(edge.to) : []
      return all.length < 2 ? edge : {...edge, order: all.indexOf(edge) + 1}
    })
    return {nodes, edges: numbered}
  }

  #part(parent: string | null, part: ProgramPart, isStart: boolean): string {
    switch (part.kind) {
      case "function":
        return this.#function(parent, part, isStart)
      case "step":
        return this.#add(parent, "step", part.name, {
          key: part.name,
          at: part.at,
          block: part.block ?? null,
          label: this.#label(part),
        })
      case "task": {
        const id = this.#container(parent, part, "task")
        this.scope(id, part.start, part.parts)
        return id
      }
      default: {
        const chart = {chart: part.kind, turns: part.turns}
        const id = this.#container(parent, part, "chart", chart)
        // One turn of a repetition is a sequence without a name: its steps are those of the repetition.
        const [only] = part.steps
        const isTurn = part.kind === "repeat" && only?.kind === "sequence" && only.name === ""
        const inner = isTurn ? only.steps : part.steps
        const steps = inner.map(step => this.#part(id, step, false))
        const isChain = part.kind === "sequence" || part.kind === "repeat"
        const ends = inner.map((step, i) => this.#endOf(step, steps[i] ?? id))
        if (isChain)
          steps.slice(1).forEach((step, i) => {
            this.#edge(steps[i] ?? step, step, "then", {label: ends[i] ?? null})
          })
        const [first, last] = [steps[0], steps.at(-1)]
        if (part.kind === "repeat" && first !== undefined && last !== undefined)
          this.#edge(last, first, "again", {label: ends.at(-1) ?? null})
        return id
      }
    }
  }

  /// How a step ends: the name of its result, or the type of the `Done` that its functions give.
  #endOf({result}: ProgramPart, id: string): string | null {
    if (typeof result === "string") return result
    const done = [...this.#nodes.values()].find(node => node.parent === id && node.kind === "done")
    return done === undefined ? null : done.label.replace(/ \(\)$/, "")
  }

  #container(
    parent: string | null,
    part: ProgramPart,
    kind: "task" | "chart",
    more: Partial<DiagramNode> = {},
  ): string {
    return this.#add(parent, kind, part.name || part.kind, {
      key: part.name,
      at: part.at,
      block: part.block ?? null,
      label: part.name,
      ...more,
    })
  }

  #function(parent: string | null, part: FunctionPart, isStart: boolean): string {
    const trigger = triggerOf(part.inputs, isStart)
    const id = this.#add(parent, "function", part.name, {
      key: part.name,
      at: part.at,
      label: this.#label(part),
      trigger,
    })
    for (const shape of part.inputs) this.#input(parent, id, id, shape, trigger, false)
    if (trigger === "tick") this.#edge(this.#tick(parent), id, "triggers")
    for (const leaf of uniqueLeaves(part.output)) {
      const perhaps = !isCertain(part.output, leaf.spelled)
      const target = this.#sink(parent, leaf)
      if (target !== null)
        this.#edge(id, target, leafKind(leaf, "output") === "store" ? "writes" : "sends", {perhaps})
    }
    return id
  }

  /// Connects an input of the function `owner` to `target`: the function, or a join before it. Returns whether it triggers.
  #input(
    parent: string | null,
    owner: string,
    target: string,
    shape: TypeShape,
    trigger: Trigger,
    inEither: boolean,
    optional = false,
  ): boolean {
    switch (shape.kind) {
      case "type": {
        const kind = leafKind(shape, "input")
        const source = this.#source(parent, shape, kind)
        if (source === null) return false
        const triggers =
          kind === "event" ||
          kind === "channel" ||
          kind === "tick" ||
          (kind === "state" && (inEither || trigger === "state" || trigger === "start"))
        this.#edge(source, target, triggers ? "triggers" : "reads", {optional})
        return triggers
      }
      case "maybe": {
        this.#edge(this.#tick(parent), owner, "triggers")
        this.#input(parent, owner, target, shape.of, trigger, true, true)
        return true
      }
      case "each":
        return this.#input(parent, owner, target, shape.of, trigger, inEither, optional)
      default: {
        const inner = shape.kind === "either" ? sidesOf(shape) : shape.of
        const [only] = inner
        if (only === undefined) return false
        const isEither = shape.kind === "either"
        if (inner.length === 1)
          return this.#input(parent, owner, target, only, trigger, inEither || isEither, optional)
        const join = this.#add(parent, shape.kind, `${owner}/${shape.kind}`, {key: owner})
        const triggering = inner.map(one =>
          this.#input(parent, owner, join, one, trigger, isEither || inEither),
        )
        const triggers = triggering.some(one => one)
        this.#edge(join, target, triggers ? "triggers" : "reads", {optional})
        return triggers
      }
    }
  }

  #source(parent: string | null, leaf: Leaf, kind: LeafKind): string | null {
    if (kind === "nothing" || kind === "done" || kind === "command") return null
    return kind === "tick" ? this.#tick(parent) : this.#shared(parent, kind, leaf)
  }

  #sink(parent: string | null, leaf: Leaf): string | null {
    const kind = leafKind(leaf, "output")
    if (kind === "command" || kind === "store" || kind === "channel" || kind === "done")
      return this.#shared(parent, kind, leaf)
    return null
  }

  #tick(parent: string | null): string {
    return this.#shared(parent, "sample", {
      kind: "type",
      written: "()",
      spelled: "()",
      own: false,
      topic: null,
    })
  }

  /// The one node of a type in a scope.
  #shared(parent: string | null, kind: NodeKind, leaf: Leaf): string {
    const id = idOf(parent, `${kind}:${leaf.spelled}`)
    if (!this.#nodes.has(id))
      this.#set(id, parent, kind, {
        key: leaf.spelled,
        label: kind === "store" ? this.#memoryName(leaf.spelled) : leaf.written,
        topic: leaf.topic,
      })
    return id
  }

  /// A new node; a second one of the same name gets a number.
  #add(parent: string | null, kind: NodeKind, name: string, more: Partial<DiagramNode>): string {
    const wanted = kind === "either" || kind === "all" ? name : idOf(parent, name)
    let id = wanted
    for (let n = 2; this.#nodes.has(id); n++) id = `${wanted}#${n}`
    this.#set(id, parent, kind, more)
    return id
  }

  #set(id: string, parent: string | null, kind: NodeKind, more: Partial<DiagramNode>): void {
    const rest = {trigger: null, chart: null, turns: null, topic: null, contested: false, folded: false}
    this.#nodes.set(id, {id, parent, kind, label: "", key: "", at: null, block: null, ...rest, ...more})
  }

  #edge(from: string, to: string, role: EdgeRole, more: Partial<DiagramEdge> = {}): void {
    const id = `${from} → ${to} ${role}`
    if (!this.#edges.has(id))
      this.#edges.set(id, {
        id,
        from,
        to,
        role,
        optional: false,
        perhaps: false,
        order: null,
        label: null,
        ...more,
      })
  }

  #label(part: ProgramPart): string {
    if (part.text !== undefined) return shortened(part.text, longestLabel)
    if (part.at === null || (part.kind === "function" && /^[\p{L}_][\p{L}\p{N}_']*$/u.test(part.name)))
      return part.name
    return shortened(this.#textAt(part.at) || part.name, longestLabel)
  }
}

const idOf = (parent: string | null, name: string) => (parent === null ? name : `${parent}/${name}`)
