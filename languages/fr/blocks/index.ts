/// Every word of blocks, types and refusals in French. Haskell's words and the robot's stay as they are.

import type {Words} from "../../../codegen/src/words/index.ts"
import {blocks} from "./blocks.ts"
import {commandLine} from "./command_line.ts"
import {reasons} from "./reasons.ts"
import {sentences} from "./sentences.ts"
import {tasks} from "./tasks.ts"
import {toolbox} from "./toolbox.ts"
import {vocabulary} from "./vocabulary.ts"

export const table: Words = {...blocks, ...vocabulary, ...sentences, tasks, toolbox, reasons, commandLine}
