/// The diagram, for the page: `openDiagram(host, options)`. It is loaded when it is shown for the first time.

import type {NodePlaces} from "@rosy/codegen"
import type {ProgramPart} from "../../program/program_graph.ts"
import type {Frame} from "../../state/messages/messages.ts"
import {pngOf, standalone} from "./drawing/picture.ts"
import type {ViewOptions, ViewWords} from "./drawing/view_types.ts"
import type {Point} from "./layout/geometry.ts"
import {type Layout, layOut} from "./layout/layout.ts"
import {openLayoutEngine} from "./layout/layout_engine.ts"
import {placesAfter} from "./layout/renamed_places.ts"
import {type Activity, isFading, noActivity, observe} from "./network/activity.ts"
import type {CausalPath} from "./network/causal_path.ts"
import {explained} from "./network/explained.ts"
import {type DiagramNode, firstFolds, fold, type Network} from "./network/network.ts"
import {networkOf} from "./network/network_builder.ts"
import {type OutlineLine, outline} from "./network/outline.ts"
import {openDrawing} from "./view.ts"

export type {DiagramNode} from "./network/network.ts"
export type {OutlineLine} from "./network/outline.ts"
export {pendingParts} from "./network/pending_parts.ts"
export {openedTasks, withWrittenTasks} from "./network/written_steps.ts"

export interface DiagramOptions {
  readonly words: ViewWords
  chosen(node: DiagramNode): void
  valueClicked(node: DiagramNode): void
  typeOf(node: DiagramNode): string | null
  lastOf(node: DiagramNode): string | null
  /// The learner moved a node: all places that nodes have been moved to.
  moved(places: NodePlaces): void
  /// A new drawing is there, or none could be made.
  drawn(outcome: "drawn" | "empty" | "failed", nodes: readonly DiagramNode[]): void
}

export interface DiagramView {
  /// Shows what a program runs; `text` is the program's, `conflicts` as in `networkOf`.
  show(parts: readonly ProgramPart[], text: string, conflicts: ReadonlySet<string> | null): void
  /// The new frames of the run; `now` is the learner's time in ms. Returns whether more is to be drawn without a new frame.
  live(frames: readonly Frame[], now: number): boolean
  /// One frame of the past.
  at(frame: Frame | null, now: number): void
  /// A new run: nothing has happened yet.
  clear(): void
  /// The run is over: no step of a task is at work.
  rest(): void
  select(name: string | null, block: string | null): void
  /// Marks what led to the answer of a question.
  explain(path: CausalPath): void
  /// Places everything anew.
  tidy(): void
  /// The learner moved these nodes, now or before the program was opened.
  place(places: NodePlaces): void
  /// Whether a drag moves a node, and connects none.
  setMoving(on: boolean): void
  /// With what led to the answer of a question.
  list(path: CausalPath): readonly OutlineLine[]
  chooseById(id: string): void
  svgFile(): Promise<string>
  pngFile(): Promise<Blob | null>
}

export function openDiagram(host: HTMLElement, options: DiagramOptions): DiagramView {
  const engine = openLayoutEngine()
  let whole: Network = {nodes: [], edges: []}
  let network = whole
  let layout: Layout | null = null
  let folded: ReadonlySet<string> = new Set()
  let activity: Activity = noActivity
  let moved: NodePlaces = {}
  let asked = 0

  const drawing = openDrawing(host, {
    words: options.words,
    chosen: options.chosen,
    valueClicked: options.valueClicked,
    typeOf: options.typeOf,
    lastOf: options.lastOf,
    moved(id, by) {
      const scope = layout?.scopes.get(network.nodes.find(node => node.id === id)?.parent ?? "")
      const box = scope?.boxes.get(id)
      if (box === undefined) return
      const known = new Set(whole.nodes.map(node => node.id))
      const kept = Object.entries(moved).filter(([node]) => known.has(node))
      const place = [box.x + by.x, box.y + by.y].map(at => Math.max(0, Math.round(at))) as [number, number]
      options.moved({...Object.fromEntries(kept), [id]: place})
    },
    toggled(id) {
      const next = new Set(folded)
      if (!next.delete(id)) next.add(id)
      folded = next
      void draw()
    },
  } satisfies ViewOptions)

  // Positions come later than the network; only those of the newest one are drawn.
  const draw = async () => {
    const mine = ++asked
    const shown = fold(whole, folded)
    try {
      const placed = await layOut(shown, layout, engine.layOut, pointsOf(moved))
      if (mine !== asked) return
      network = shown
      layout = placed
      drawing.show(network, placed)
      options.drawn(whole.nodes.length === 0 ? "empty" : "drawn", whole.nodes)
    } catch {
      if (mine === asked) options.drawn("failed", [])
    }
  }

  return {
    show(parts, text, conflicts) {
      const lines = text.split("\n")
      const first = whole.nodes.length === 0
      const before = whole
      whole = networkOf(parts, at => textOf(lines, at), conflicts)
      const places = placesAfter(before, whole, moved)
      if (places !== moved) options.moved(places)
      moved = places
      if (first) folded = firstFolds(whole)
      void draw()
    },
    live(frames, now) {
      activity = observe(activity, frames, now)
      drawing.live(activity, now, false)
      return isFading(activity, now)
    },
    at(frame, now) {
      activity = observe(noActivity, frame === null ? [] : [frame], now)
      drawing.live(activity, now, true)
    },
    clear() {
      activity = noActivity
    },
    rest() {
      activity = {...activity, isOver: true}
    },
    select: (name, block) => drawing.select(name, block),
    explain: path => drawing.explain(path),
    tidy() {
      layout = null
      drawing.fit()
      void draw()
    },
    place(places) {
      moved = places
      if (whole.nodes.length > 0) void draw()
    },
    setMoving: on => drawing.setMoving(on),
    list: path => outline(whole, options.words.list, explained(whole, path).marked),
    chooseById(id) {
      const node = whole.nodes.find(one => one.id === id)
      if (node !== undefined) options.chosen(node)
    },
    svgFile: () => standalone(drawing.svg, getComputedStyle(host).backgroundColor),
    pngFile: async () => pngOf(await standalone(drawing.svg, getComputedStyle(host).backgroundColor)),
  }
}

const pointsOf = (places: NodePlaces): ReadonlyMap<string, Point> =>
  new Map(Object.entries(places).map(([node, [x, y]]) => [node, {x, y}]))

/// The first line of a piece of the text.
function textOf(
  lines: readonly string[],
  {line, column, endLine, endColumn}: NonNullable<DiagramNode["at"]>,
): string {
  const characters = [...(lines[line - 1] ?? "")]
  return characters.slice(column - 1, line === endLine ? endColumn - 1 : undefined).join("")
}
