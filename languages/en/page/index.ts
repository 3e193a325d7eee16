/// Every sentence and label of the page in English: what the other languages translate.

import {backpack} from "./backpack.ts"
import {blocks} from "./blocks.ts"
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

export const en = {
  ...page,
  backpack,
  blocks,
  world,
  challenges,
  classroom,
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
  /// Blockly's own words, where they are not its English ones.
  blockly: {} as Readonly<Record<string, string>>,
} as const
