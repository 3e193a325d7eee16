/// Portuguese of Brazil, as one speaks to a learner of twelve years. Haskell's words and the robot's stay English.

import type {Table} from "../../../editor/src/words/language_table.ts"
import {measuresOf} from "../../../editor/src/words/number_formats.ts"
import {table as wordsOnBlocks} from "../blocks/index.ts"
import {backpack} from "./backpack.ts"
import {blockly, blocks} from "./blocks.ts"
import {challenges} from "./challenges.ts"
import {classroom} from "./classroom.ts"
import {companions} from "./companions.ts"
import {diagram} from "./diagram.ts"
import {film} from "./film.ts"
import {graph} from "./graph.ts"
import {keys} from "./keys.ts"
import {lessonEditor} from "./lesson_editor.ts"
import {lessons} from "./lessons.ts"
import {page} from "./page.ts"
import {preview} from "./preview.ts"
import {recordings} from "./recordings.ts"
import {replies} from "./replies.ts"
import {roomTests} from "./room_tests.ts"
import {world} from "./rooms.ts"
import {runs} from "./runs.ts"
import {twin} from "./twin.ts"
import {welcome} from "./welcome.ts"
import {why} from "./why.ts"

export const table: Table = {
  tag: "pt",
  direction: "ltr",
  page: {
    ...page,
    backpack,
    blocks,
    challenges,
    classroom,
    world,
    companions,
    diagram,
    film,
    graph,
    replies,
    roomTests,
    preview,
    recordings,
    runs,
    keys,
    lessons,
    lessonEditor,
    twin,
    welcome,
    why,
    blockly,
  },
  measures: measuresOf("pt-BR"),
  blocks: wordsOnBlocks,
}
