/// The language of blocks: all families together, and a block's spec by its type.

import {choiceBlocks} from "./choices.ts"
import {definitions} from "./definitions.ts"
import {functions} from "./functions.ts"
import {ownTypes} from "./owntypes.ts"
import {patterns} from "./patterns.ts"
import {raw} from "./raw.ts"
import type {BlockSpec} from "./spec.ts"
import {tasks} from "./tasks.ts"
import {values} from "./values.ts"

export const blockTypes: readonly BlockSpec[] = [
  ...definitions,
  ...patterns,
  ...values,
  ...choiceBlocks,
  ...functions,
  ...tasks,
  ...ownTypes,
  ...raw,
]

const byType: ReadonlyMap<string, BlockSpec> = new Map(blockTypes.map(spec => [spec.type, spec]))

export function blockView(type: string): BlockSpec | undefined {
  return byType.get(type)
}
