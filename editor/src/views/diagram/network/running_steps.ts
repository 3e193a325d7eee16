/// The step at which each chain of a task is, from the order in which functions fired: frames say what fired, and not for which step. Pure.
///
/// A step of the library is at work from its first firing until another step of its chain fires. Steps that fire nothing, such as `wait`, are at work
/// after one that kept firing and has stopped. Where steps with the same firings follow each other directly, the first of them counts.

import type {DiagramNode, Network} from "./network.ts"

/// What has happened so far, as `Activity` has it.
interface Firings {
  readonly trail: readonly string[]
  readonly firings: ReadonlyMap<string, readonly number[]>
  /// Seconds of the run.
  readonly time: number
}

/// What steps of the library fire when they begin, where that is not their own name. A test holds it against `rosy-hs/src/Rosy/Motion.hs`.
export const firedBy: {readonly [step: string]: readonly string[]} = {
  driveBack: ["once"],
  blink: ["once"],
  beep: ["once"],
  penDown: ["once"],
  penUp: ["once"],
  penColor: ["once"],
  penWidth: ["once"],
  eitherOr: ["dice"],
  driveUntilBump: ["start of a task"],
  driveUntil: ["start of a task"],
  curveUntilObstacle: ["start of a task"],
  turnBetween: ["randomNumber", "turn"],
  wait: [],
}

/// A step fires again and again from so many firings in a second on, and has stopped after so many seconds without one.
const keepsFiringFrom = 3
const stoppedAfter = 0.2

export function runningSteps({nodes, edges}: Network, fired: Firings): ReadonlySet<string> {
  const children = new Map<string, DiagramNode[]>()
  for (const node of nodes)
    if (node.parent !== null) children.set(node.parent, [...(children.get(node.parent) ?? []), node])
  const namesIn = (node: DiagramNode): readonly string[] => {
    if (node.kind === "step") return firedBy[node.key] ?? [node.key]
    if (node.kind === "function") return [node.key]
    return (children.get(node.id) ?? []).flatMap(namesIn)
  }
  const running = new Set<string>()
  const visit = (node: DiagramNode): void => {
    const inside = children.get(node.id) ?? []
    const loops = edges.some(e => e.role === "again" && inside.some(({id}) => id === e.to))
    const isChain = loops || edges.some(e => e.role === "then" && inside.some(({id}) => id === e.from))
    const at = isChain ? chainAt(inside.map(namesIn), loops, fired) : -1
    for (const [i, child] of inside.entries()) {
      if (child.kind !== "step" && child.kind !== "chart" && child.kind !== "task") continue
      const isAtWork = isChain ? i === at : namesIn(child).some(name => fired.trail.includes(name))
      if (!isAtWork) continue
      running.add(child.id)
      visit(child)
    }
  }
  for (const node of nodes)
    if (node.parent === null && (node.kind === "chart" || node.kind === "task" || node.kind === "step")) {
      if (node.kind === "step" && namesIn(node).some(name => fired.trail.includes(name))) running.add(node.id)
      else visit(node)
    }
  return running
}

/// The place in a chain of steps with these names; -1 before its first firing.
function chainAt(steps: readonly (readonly string[])[], loops: boolean, fired: Firings): number {
  let at = -1
  for (const name of fired.trail) {
    if (steps[at]?.includes(name)) continue
    const ahead = steps.findIndex((names, i) => i > at && names.includes(name))
    const next = ahead < 0 && loops ? steps.findIndex(names => names.includes(name)) : ahead
    if (next >= 0) at = next
  }
  const next = at + 1 < steps.length ? at + 1 : loops ? 0 : -1
  if (next < 0 || steps[next]?.length !== 0) return at
  if (at < 0) return fired.time > 0 ? next : at
  const times = (steps[at] ?? []).flatMap(name => fired.firings.get(name) ?? [])
  const isOver = times.length >= keepsFiringFrom && fired.time - Math.max(...times) > stoppedAfter
  return isOver ? next : at
}
