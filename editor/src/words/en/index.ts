/// Every sentence and label of the page in English: what the other languages translate.

import {blocks} from "./blocks.ts"
import {keys} from "./keys.ts"
import {page} from "./page.ts"
import {world} from "./rooms.ts"

export const en = {
  ...page,
  blocks,
  world,
  keys,
  /// Blockly's own words, where they are not its English ones.
  blockly: {} as Readonly<Record<string, string>>,
} as const
