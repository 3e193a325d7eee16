/// Names of memories as the program writes them: `Memory Hit` for a memory of the type `Memory Bool`. Pure.

import type {ProgramPart, TypeShape} from "./program_graph.ts"

/// How a program writes the type of a memory. Types of the program's runs and of the compiler are both known.
export type MemoryName = (type: string) => string

const named = new WeakMap<readonly ProgramPart[], MemoryName>()

/// The synonym of each memory's type, where the program uses one; a type that it writes under two synonyms is one memory and keeps its own name.
export function memoryNames(network: {readonly parts: readonly ProgramPart[]} | null): MemoryName {
  if (network === null) return type => type
  const known = named.get(network.parts)
  if (known !== undefined) return known
  const written = new Map<string, Set<string>>()
  for (const shape of network.parts.flatMap(shapesOf).flatMap(typesOf)) {
    if (!/^(Memory|Param) /.test(shape.spelled) || shape.written === shape.spelled) continue
    const names = written.get(shape.spelled) ?? new Set()
    written.set(shape.spelled, names.add(shape.written))
  }
  const nameOf: MemoryName = type => {
    // The compiler writes `String`, a run `[Char]`.
    const [name = type, ...others] = written.get(type.replaceAll("[Char]", "String")) ?? []
    return others.length === 0 ? name : type
  }
  named.set(network.parts, nameOf)
  return nameOf
}

function shapesOf(part: ProgramPart): readonly TypeShape[] {
  switch (part.kind) {
    case "function":
      return [...part.inputs, part.output]
    case "task":
      return [...part.start, ...part.parts].flatMap(shapesOf)
    case "step":
      return []
    default:
      return part.steps.flatMap(shapesOf)
  }
}

function typesOf(shape: TypeShape): readonly (TypeShape & {kind: "type"})[] {
  if (shape.kind === "type") return [shape]
  return shape.kind === "all" || shape.kind === "either" ? shape.of.flatMap(typesOf) : typesOf(shape.of)
}
