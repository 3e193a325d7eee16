/// Shows on blocks what type inference found: families as colour and outline, types in headers, holes, problems.
///
/// Touches only blocks whose look changes; typing a number repaints nothing.

import {type BlockProblem, type Family, type Inference, socketKey} from "@rosy/codegen"
import * as Blockly from "blockly/core"
import {extraOf, shapeOf} from "./build.ts"
import {Signature} from "./fields.ts"
import {lookOf, setLook} from "./looks.ts"
import {savedTop} from "./snapshot.ts"
import {styleName} from "./theme.ts"

/// What each top-level block and what is told of it was when it was painted.
const painted = new WeakMap<Blockly.Block, {readonly stamp: object | undefined; readonly saved: unknown}>()

/// Paints `inference` onto the blocks of a workspace. `names` are families of names from elsewhere, for blocks in the
/// toolbox, which stand outside the program.
export function showInference(
  workspace: Blockly.WorkspaceSvg,
  inference: Inference,
  names?: ReadonlyMap<string, Family>,
): void {
  const holes = new Set(
    inference.problems
      .filter(
        problem => problem.kind === "hole" && problem.block !== undefined && problem.input !== undefined,
      )
      .map(problem => socketKey(problem.block!, problem.input!)),
  )
  const fresh = workspace.getTopBlocks(false).filter(top => {
    const stamp = inference.stamps.get(top.id)
    const saved = savedTop(top)
    const before = painted.get(top)
    painted.set(top, {stamp, saved})
    return names !== undefined || stamp === undefined || before?.stamp !== stamp || before.saved !== saved
  })
  for (const block of fresh.flatMap(top => top.getDescendants(false))) {
    if (block.isInsertionMarker()) continue
    const shape = shapeOf(block)
    if (shape === undefined) continue
    const definition = inference.definitions.get(block.id)
    const called = names?.get(String(extraOf(block).name ?? ""))
    const family = called ?? definition?.family ?? inference.blocks.get(block.id)?.family ?? shape.family
    const style = styleName(family, shape.connects.as === "pattern")
    if (block.getStyleName() !== style) block.setStyle(style)
    let changed = false
    if (block.outputConnection !== null) {
      changed = setLook(block.outputConnection, {family, hint: "", hole: false})
    }
    for (const input of block.inputList) {
      if (definition !== undefined) {
        for (const field of input.fieldRow) if (field instanceof Signature) field.show(definition.type)
      }
      const connection = input.connection
      if (connection === null || input.type !== Blockly.inputs.inputTypes.VALUE) continue
      const key = socketKey(block.id, input.name)
      const wanted = inference.sockets.get(key)?.family ?? lookOf(connection).family
      const look = {
        family: wanted,
        hint: lookOf(connection).hint,
        hole: names === undefined && holes.has(key),
      }
      changed = setLook(connection, look) || changed
    }
    if (changed) block.queueRender()
  }
}

/// Problems that a block wears as an icon with a sentence. A hole is shown by its socket and a loose block by its
/// outline: while somebody builds, both are normal, and an icon would come and go at every step.
export function worn(problems: readonly BlockProblem[]): readonly BlockProblem[] {
  return problems.filter(problem => problem.kind !== "hole" && problem.kind !== "loose")
}
