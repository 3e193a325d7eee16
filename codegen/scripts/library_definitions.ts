/// Conversion of the library's ready-made tasks from their Haskell source to blocks.
///
/// Input: the text of `rosy-hs/src/Rosy/Motion.hs`. Output: its definitions as saved blocks without ids. A learner's program does not name the
/// tasks that it starts, so `taskNamed` with its two names becomes `task`. A definition whose signature has a class that `Rosy` does not export
/// (`driveUntil`) gets no signature here: a program can write its type only for the values of one call.

import {openView, type Reader} from "../src/reader/index.ts"
import type {SavedBlock, SavedInput} from "../src/serialized_blocks.ts"
import {library} from "../src/types/environment/standard_library.ts"
import type {LibraryDefinition} from "../src/workspace/library_definitions.ts"

export const motionSource = new URL("../../rosy-hs/src/Rosy/Motion.hs", import.meta.url)

export function libraryDefinitions(reader: Reader, source: string): LibraryDefinition[] {
  const imports = source.lastIndexOf("\nimport ")
  const body = source
    .slice(source.indexOf("\n\n", imports))
    .replaceAll(/\btaskNamed \(Name "[^"]*"\) \(Name "[^"]*"\)/g, "task")
  if (/\btaskNamed\b/.test(body))
    throw new Error("expected taskNamed with two names, found another form in Motion.hs")
  return openView(reader, body).declarations.map(({name, block}) =>
    isWritable(block.extraState?.signature)
      ? {name, block: withoutIds(block)}
      : {name, block: withoutIds(withoutSignature(block)), typedByCall: true},
  )
}

function isWritable(signature: unknown): boolean {
  return ![...library.hidden].some(name => new RegExp(`\\b${name}\\b`).test(String(signature)))
}

function withoutSignature({extraState, ...block}: SavedBlock): SavedBlock {
  return {...block, extraState: {...extraState, signature: ""}}
}

function withoutIds({id: _, x: __, y: ___, ...block}: SavedBlock): SavedBlock {
  const {inputs, next} = block
  const input = (one: SavedInput): SavedInput =>
    one.block === undefined ? {} : {block: withoutIds(one.block)}
  return {
    ...block,
    ...(inputs === undefined
      ? {}
      : {inputs: Object.fromEntries(Object.entries(inputs).map(([name, one]) => [name, input(one)]))}),
    ...(next === undefined ? {} : {next: input(next)}),
  }
}
