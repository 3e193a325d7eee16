/// Every word of blocks, types and refusals in English: what the other languages translate.

import {blocks} from "./blocks.ts"
import {commandLine} from "./command_line.ts"
import {reasons} from "./reasons.ts"
import {sentences} from "./sentences.ts"
import {tasks} from "./tasks.ts"
import {toolbox} from "./toolbox.ts"
import {vocabulary} from "./vocabulary.ts"

export const en = {...blocks, ...vocabulary, ...sentences, tasks, toolbox, reasons, commandLine} as const
