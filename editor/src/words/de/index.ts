/// German, as one speaks to somebody of twelve years. Haskell's words and the robot's stay English.

import {de} from "@rosy/codegen/words/de"
import {measuresOf} from "../measures.ts"
import type {Table} from "../table.ts"
import {blockly, blocks} from "./blocks.ts"
import {keys} from "./keys.ts"
import {page} from "./page.ts"
import {world} from "./rooms.ts"

export const german: Table = {
  tag: "de",
  direction: "ltr",
  page: {...page, blocks, world, keys, blockly},
  measures: measuresOf("de"),
  blocks: de,
}
