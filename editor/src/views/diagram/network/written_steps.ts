/// Tasks as the text has them now, as parts of the program: chains of steps from its blocks, with what the compiler reported of the tasks that are opened. Pure.

import type {BlockId} from "@rosy/codegen"
import type {WrittenTask} from "@rosy/codegen/network-edits"
import type {Extent, ProgramPart} from "../../../program/program_graph.ts"

type TaskPart = ProgramPart & {readonly kind: "task"}

/// Tasks with their functions, by the name of their definition, or by their block.
export type OpenedTasks = ReadonlyMap<string, TaskPart>

/// The tasks of a report whose text is that of the program.
export function openedTasks(
  parts: readonly ProgramPart[],
  blockAt: (at: Extent) => BlockId | null,
): OpenedTasks {
  const found = new Map<string, TaskPart>()
  const visit = (part: ProgramPart): void => {
    if (part.kind === "function" || part.kind === "step") return
    if (part.kind !== "task") {
      part.steps.forEach(visit)
      return
    }
    const key = part.name !== "" || part.at === null ? part.name : blockAt(part.at)
    if (key !== null && key !== "") found.set(key, part)
  }
  parts.forEach(visit)
  return found
}

/// The parts with the tasks as they are written now. Tasks that only the compiler knows (`null`) stay as they were reported.
export function withWrittenTasks(
  parts: readonly ProgramPart[],
  tasks: readonly WrittenTask[] | null,
  opened: OpenedTasks,
  textOf: (block: BlockId) => string,
): readonly ProgramPart[] {
  if (tasks === null) return parts
  const written = tasks.map(task => partOf(task, opened, textOf))
  const kept = parts.flatMap(part => (part.kind === "function" ? part : (written.shift() ?? [])))
  return [...kept, ...written]
}

function partOf(task: WrittenTask, opened: OpenedTasks, textOf: (block: BlockId) => string): ProgramPart {
  const {kind, name, block, result, turns} = task
  const shared = {name, at: null, block, result}
  if (kind === "task") {
    const known = opened.get(name === "" ? block : name)
    if (known !== undefined) return {...known, block, result}
  }
  if (kind === "task" || kind === "step") return {...shared, kind: "step", text: textOf(block) || name}
  return {...shared, kind, turns, steps: task.steps.map(step => partOf(step, opened, textOf))}
}
