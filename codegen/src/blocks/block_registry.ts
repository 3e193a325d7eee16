/// Registry of all kinds of blocks, and a block's spec by its type.

import {annotatedPatterns} from "./annotated_patterns.ts"
import type {BlockSpec} from "./block_spec.ts"
import {choiceBlocks} from "./conditionals.ts"
import {definitions} from "./definitions.ts"
import {withFoldedSteps} from "./folding.ts"
import {functions} from "./functions.ts"
import {patterns} from "./patterns.ts"
import {raw} from "./raw_haskell.ts"
import {records} from "./records.ts"
import {tasks} from "./tasks.ts"
import {textDeclarations} from "./text_declarations.ts"
import {ownTypes} from "./type_declarations.ts"
import {values} from "./values.ts"

const specs: readonly BlockSpec[] = [
  ...definitions,
  ...patterns,
  ...annotatedPatterns,
  ...values,
  ...records,
  ...choiceBlocks,
  ...functions,
  ...tasks,
  ...ownTypes,
  ...textDeclarations,
  ...raw,
]

export const blockTypes: readonly BlockSpec[] = specs.map(spec => ({
  ...spec,
  shape(extra) {
    const shape = spec.shape(extra)
    return extra.folded === undefined ? shape : {...shape, rows: withFoldedSteps(shape.rows, extra)}
  },
}))

const byType: ReadonlyMap<string, BlockSpec> = new Map(blockTypes.map(spec => [spec.type, spec]))

export function blockView(type: string): BlockSpec | undefined {
  return byType.get(type)
}
