/// The lasting commands that a definition names, itself or through the functions that it uses: those of the program and of the library's ready-made
/// tasks. An over-approximation: a step that is never reached counts.

import {readTree} from "../../blocks/block_reader.ts"
import {everyNode} from "../../model/child_nodes.ts"
import type {FunctionDeclaration} from "../../model/syntax_tree.ts"
import {heldCommands} from "../../robot/roles.ts"
import type {SavedBlock} from "../../serialized_blocks.ts"
import {generated} from "../toolbox/library_definitions.generated.ts"

type Functions = ReadonlyMap<string, FunctionDeclaration>

let library: Functions | undefined

/// The definitions of the library's ready-made tasks, read once.
function libraryFunctions(): Functions {
  library ??= new Map(
    (generated as readonly {readonly block: SavedBlock}[])
      .flatMap(({block}) => readTree(block).declarations)
      .flatMap(d => (d.kind === "function" ? [[d.name, d] as const] : [])),
  )
  return library
}

export function commandsInText(of: FunctionDeclaration, program: Functions): ReadonlySet<string> {
  const found = new Set<string>()
  const seen = new Set([of])
  for (const definition of seen)
    for (const node of everyNode(definition)) {
      if (node.kind === "constructor-name" && heldCommands.has(node.name)) found.add(node.name)
      if (node.kind !== "variable") continue
      // A program's own definition takes the place of the library's (rule R20).
      const used = program.get(node.name) ?? libraryFunctions().get(node.name)
      if (used !== undefined) seen.add(used)
    }
  return found
}

/// Whether every velocity that a definition names is that of standing still.
export function onlyStandsStill(of: FunctionDeclaration): boolean {
  const nodes = [...everyNode(of)]
  const velocities = nodes.filter(node => node.kind === "constructor-name" && node.name === "Velocity")
  const standing = nodes.filter(
    node =>
      node.kind === "apply" &&
      node.fn.kind === "constructor-name" &&
      node.fn.name === "Velocity" &&
      node.args.length === 2 &&
      node.args.every(arg => arg.kind === "number" && Number(arg.text) === 0),
  )
  return velocities.length > 0 && standing.length === velocities.length
}
