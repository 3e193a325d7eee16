/// All keys of the page, told by the parts that listen to them.

import {blockKeys} from "../blocks/keys.ts"
import {worldKeys} from "../room/editorkeys.ts"
import {roomKeys} from "../room/gestures.ts"
import {pageKeys} from "../run/window.ts"
import {textKeys} from "../source/keys.ts"
import {type KeySection, keyLines} from "../state/keys.ts"
import {words} from "../words/index.ts"

export function keySections(): readonly KeySection[] {
  const {sections, page, blocks, text, room, world} = words.keys
  return [
    {title: sections.page, lines: keyLines(page, pageKeys)},
    {title: sections.blocks, lines: keyLines(blocks, blockKeys())},
    {title: sections.text, lines: keyLines(text, textKeys)},
    {title: sections.room, lines: keyLines(room, roomKeys)},
    {title: words.world.title, lines: keyLines(world, worldKeys)},
  ]
}
