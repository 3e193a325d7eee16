/// The commands that a function of the program may give, from the types that the compiler reports, and all commands that can be asked for. Pure.

import {commands} from "@rosy/codegen/roles"
import type {ProgramPart, TypeShape} from "../../program/program_graph.ts"

/// Those of the function first, then the others that a program may send: that it never sends them is an answer as well.
export function commandsToAsk(parts: readonly ProgramPart[], name: string): readonly string[] {
  return [...new Set([...commandsOf(parts, name), ...commands])]
}

export function commandsOf(parts: readonly ProgramPart[], name: string): readonly string[] {
  const given = parts.flatMap((part): readonly string[] => {
    switch (part.kind) {
      case "function":
        return part.name === name ? types(part.output) : []
      case "task":
        return commandsOf([...part.start, ...part.parts], name)
      case "step":
        return []
      default:
        return commandsOf(part.steps, name)
    }
  })
  return [...new Set(given)]
}

function types(shape: TypeShape): readonly string[] {
  switch (shape.kind) {
    case "type":
      return shape.own || isNoCommand(shape.spelled) ? [] : [shape.spelled]
    case "maybe":
    case "each":
      return types(shape.of)
    case "all":
    case "either":
      return shape.of.flatMap(types)
  }
}

/// What an output may be besides commands and events of the program: memory, the end of a task, nothing.
const isNoCommand = (type: string) => /^(?:Memory|Param|Done|Feedback|Never)\b|^\(\)$/.test(type)
