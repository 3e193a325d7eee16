/// What can be done with steps of tasks in the diagram: with one that is chosen, and with one that is dragged to another. Pure.

import type {BlockId} from "@rosy/codegen"
import type {NetworkAction, NewStep, WrittenTask} from "@rosy/codegen/network-edits"
import type {ConnectionEnd} from "./connections.ts"

export type StepAction =
  | "addHere"
  | "before"
  | "after"
  | "inside"
  | "earlier"
  | "later"
  | "moveBefore"
  | "moveAfter"
  | "forever"
  | "twice"
  | "parallel"
  | "race"
  | "apart"
  | "remove"

export interface StepOption {
  readonly as: StepAction
  readonly action: NetworkAction
}

/// A step with the chain or chart that it is in.
interface Place {
  readonly task: WrittenTask
  readonly chain: readonly WrittenTask[]
  readonly isChain: boolean
}

/// The step of a block, and where it stands. Of several that stand for the same definition, the first.
function placeOf(tasks: readonly WrittenTask[], block: BlockId): Place | null {
  const search = (all: readonly WrittenTask[], isChain: boolean): Place | null => {
    for (const task of all) {
      if (task.block === block) return {task, chain: all, isChain}
      const found = search(task.steps, task.kind === "sequence" || task.kind === "repeat")
      if (found !== null) return found
    }
    return null
  }
  return search(tasks, false)
}

export const stepAt = (tasks: readonly WrittenTask[], block: BlockId): WrittenTask | null =>
  placeOf(tasks, block)?.task ?? null

interface TextRange {
  readonly start: number
  readonly end: number
}

/// The step that a selected block is, or is in: the one with the shortest text around it.
export function stepAround(
  tasks: readonly WrittenTask[],
  block: BlockId | null,
  rangeOf: (block: BlockId) => TextRange | null,
): WrittenTask | null {
  if (block === null) return null
  const exact = stepAt(tasks, block)
  const inner = exact === null ? rangeOf(block) : null
  if (inner === null) return exact
  const all = (task: WrittenTask): readonly WrittenTask[] => [task, ...task.steps.flatMap(all)]
  let best: {readonly task: WrittenTask; readonly length: number} | null = null
  for (const task of tasks.flatMap(all)) {
    const range = rangeOf(task.block)
    if (range === null || range.start > inner.start || range.end < inner.end) continue
    const length = range.end - range.start
    if (best === null || length <= best.length) best = {task, length}
  }
  return best?.task ?? null
}

/// Whether it has a chain of its own, at whose end there is room for more.
const hasChain = ({kind}: WrittenTask) => kind === "sequence" || kind === "repeat"

/// What can be done with a step, other than adding one.
export function stepOptions(tasks: readonly WrittenTask[], block: BlockId): readonly StepOption[] {
  const place = placeOf(tasks, block)
  if (place === null) return []
  const {task, chain, isChain} = place
  const at = chain.indexOf(task)
  const [before, next] = isChain ? [chain[at - 1], chain[at + 1]] : []
  const both = (as: "parallel" | "race"): readonly StepOption[] =>
    next === undefined ? [] : [{as, action: {kind: "put-beside", step: block, with: next.block, as}}]
  // A sequence without a name is what the task is, and no step of another one.
  const isWhole = task.kind === "sequence" && task.name === ""
  return [
    ...moved("earlier", block, before, "before"),
    ...moved("later", block, next, "after"),
    ...(isWhole ? wholeLoops(task) : loops(block, block)),
    ...both("parallel"),
    ...both("race"),
    ...(task.kind === "repeat" || task.kind === "parallel" || task.kind === "race"
      ? [{as: "apart", action: {kind: "take-apart", step: block}} as const]
      : []),
    ...(isWhole ? [] : [{as: "remove", action: {kind: "delete-step", step: block}} as const]),
  ]
}

function moved(
  as: "earlier" | "later",
  step: BlockId,
  to: WrittenTask | undefined,
  where: "before" | "after",
): readonly StepOption[] {
  return to === undefined ? [] : [{as, action: {kind: "move-step", step, at: to.block, where}}]
}

const loops = (from: BlockId, to: BlockId): readonly StepOption[] => [
  {as: "forever", action: {kind: "loop-steps", from, to, turns: null}},
  {as: "twice", action: {kind: "loop-steps", from, to, turns: 2}},
]

function wholeLoops({steps}: WrittenTask): readonly StepOption[] {
  const [first, last] = [steps[0], steps.at(-1)]
  return first === undefined || last === undefined ? [] : loops(first.block, last.block)
}

/// Where a new step can go at a step that is chosen.
export function additions(
  tasks: readonly WrittenTask[],
  block: BlockId,
  step: NewStep,
): readonly StepOption[] {
  const task = stepAt(tasks, block)
  if (task === null) return []
  const add = (where: "before" | "after" | "inside"): StepOption => ({
    as: where,
    action: {kind: "add-step", at: block, where, step},
  })
  const isWhole = task.kind === "sequence" && task.name === ""
  return [...(isWhole ? [] : [add("before"), add("after")]), ...(hasChain(task) ? [add("inside")] : [])]
}

/// What a drag that begins or ends at a step can mean. A new step goes behind what it is dropped on, or to the end of a chain.
export function dragOptions(
  tasks: readonly WrittenTask[],
  from: ConnectionEnd,
  to: ConnectionEnd,
): readonly StepOption[] {
  if (from.kind === "new-step") {
    const step = newStep(from.type)
    if (to.kind === "program")
      return [{as: "addHere", action: {kind: "add-step", at: null, where: "after", step}}]
    const target = stepAt(tasks, to.type)
    if (target === null) return []
    const where = hasChain(target) && to.kind !== "step" ? "inside" : "after"
    return [{as: where, action: {kind: "add-step", at: to.type, where, step}}]
  }
  const [one, other] = [placeOf(tasks, from.type), placeOf(tasks, to.type)]
  if (one === null || other === null || one.task === other.task) return []
  const move = (where: "before" | "after"): StepOption => ({
    as: where === "before" ? "moveBefore" : "moveAfter",
    action: {kind: "move-step", step: from.type, at: to.type, where},
  })
  if (one.chain !== other.chain || !one.isChain) return [move("after")]
  const isBack = one.chain.indexOf(one.task) >= one.chain.indexOf(other.task)
  const beside = (as: "parallel" | "race"): StepOption => ({
    as,
    action: {kind: "put-beside", step: from.type, with: to.type, as},
  })
  // An arrow back is a loop; one ahead makes the first step come later.
  return isBack
    ? [...loops(to.type, from.type), move("before"), beside("parallel"), beside("race")]
    : [move("after"), beside("parallel"), beside("race")]
}

/// Steps that are offered, as Haskell calls them; `task` and a name is a task of the program.
export const plainSteps = ["driveUntilBump", "drive", "driveBack", "turn", "wait", "say"] as const

export const newStep = (type: string): NewStep => {
  const kind = plainSteps.find(one => one === type)
  return kind === undefined ? {kind: "task", name: type.replace(/^task /, "")} : {kind}
}
