/// All keys of the page, told by the parts that listen to them.

import {blockKeys} from "../blocks/keys.ts"
import {roomKeys} from "../room/gestures.ts"
import {pageKeys} from "../run/window.ts"
import {textKeys} from "../source/keys.ts"
import {type KeySection, keyLines} from "../state/keys.ts"
import {words} from "../words/index.ts"

export function keySections(): readonly KeySection[] {
  const {sections, page, blocks, text, room} = words.keys
  return [
    {title: sections.page, lines: keyLines(page, pageKeys)},
    {title: sections.blocks, lines: keyLines(blocks, blockKeys())},
    {title: sections.text, lines: keyLines(text, textKeys)},
    {title: sections.room, lines: keyLines(room, roomKeys)},
  ]
}
