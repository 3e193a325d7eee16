/// Interface of the drawn diagram: its words, its events, and what it can show.

import type {Point} from "../layout/geometry.ts"
import type {Layout} from "../layout/layout.ts"
import type {Activity} from "../network/activity.ts"
import type {CausalPath} from "../network/causal_path.ts"
import type {DiagramNode, Network} from "../network/network.ts"
import type {OutlineWords} from "../network/outline.ts"

export interface ViewWords {
  readonly title: string
  readonly keys: string
  readonly notYet: string
  readonly lastValue: (value: string) => string
  readonly rate: (perSecond: number) => string
  readonly type: (type: string) => string
  readonly unfold: (name: string) => string
  readonly foldUp: (name: string) => string
  readonly list: OutlineWords
}

export interface ViewOptions {
  readonly words: ViewWords
  /// The learner chose a node.
  chosen(node: DiagramNode): void
  /// The learner moved a node by so many pixels of the drawing.
  moved(id: string, by: Point): void
  /// A container was opened or closed.
  toggled(id: string): void
  /// The learner clicked on the value of a node.
  valueClicked(node: DiagramNode): void
  /// The type of a function.
  typeOf(node: DiagramNode): string | null
  /// The latest value that frames do not tell: what a function took and gave, a command, an event of the program. `null` when it is not known.
  lastOf(node: DiagramNode): string | null
}

export interface DrawnDiagram {
  readonly svg: SVGSVGElement
  show(network: Network, layout: Layout): void
  /// Undoes the zoom.
  fit(): void
  /// Whether a drag moves a node, and connects none.
  setMoving(on: boolean): void
  /// Marks the functions of this name, and the step of this block.
  select(name: string | null, block: string | null): void
  /// Marks what led to the answer of a question.
  explain(path: CausalPath): void
  /// Texts change at most five times a second, unless `atOnce`.
  live(activity: Activity, now: number, atOnce: boolean): void
}
