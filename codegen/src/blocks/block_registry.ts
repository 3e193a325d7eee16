/// Registry of all kinds of blocks, and a block's spec by its type.

import {annotatedPatterns} from "./families/annotated_patterns.ts"
import {choiceBlocks} from "./families/conditionals.ts"
import {definitions} from "./families/definitions.ts"
import {functions} from "./families/functions.ts"
import {patterns} from "./families/patterns.ts"
import {priority} from "./families/priority.ts"
import {raw} from "./families/raw_haskell.ts"
import {records} from "./families/records.ts"
import {tasks} from "./families/tasks.ts"
import {textDeclarations} from "./families/text_declarations.ts"
import {ownTypes} from "./families/type_declarations.ts"
import {values} from "./families/values.ts"
import {withFoldedSteps} from "./folding.ts"
import type {BlockSpec} from "./spec/block_spec.ts"

const specs: readonly BlockSpec[] = [
  ...definitions,
  ...patterns,
  ...annotatedPatterns,
  ...values,
  ...records,
  ...choiceBlocks,
  priority,
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
