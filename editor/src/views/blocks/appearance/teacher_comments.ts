/// Comments of the teacher on blocks: an icon with a speech bubble, which opens the comment, and an outline. No part of the program: nothing of it is saved with the blocks.

import type {BlockId} from "@rosy/codegen"
import * as Blockly from "blockly/core"
import {bubbleText} from "./annotations.ts"
import {drawSpeechBubble} from "./comment_icon.ts"

export interface CommentOnBlock {
  readonly block: BlockId
  readonly text: string
}

const type = new Blockly.icons.IconType<TeacherCommentIcon>("rosy_teacher_comment")

/// Blockly's icon of a warning has what a comment needs: a bubble with text that is opened by pointer and keyboard.
class TeacherCommentIcon extends Blockly.icons.WarningIcon {
  override getType(): Blockly.icons.IconType<TeacherCommentIcon> {
    return type
  }

  override initView(...pointer: Parameters<Blockly.icons.WarningIcon["initView"]>): void {
    super.initView(...pointer)
    const root = this.svgRoot
    if (root === null) return
    root.classList.replace("blocklyWarningIcon", "rosyTeacherComment")
    drawSpeechBubble(root)
  }
}

export class TeacherComments {
  private readonly workspace: Blockly.WorkspaceSvg
  private shown: ReadonlyMap<BlockId, string> = new Map()

  constructor(workspace: Blockly.WorkspaceSvg) {
    this.workspace = workspace
  }

  show(comments: readonly CommentOnBlock[]): void {
    const texts = new Map<BlockId, string>()
    for (const {block, text} of comments)
      texts.set(block, texts.has(block) ? `${texts.get(block)}\n${text}` : text)
    const before = this.shown
    this.shown = texts
    for (const [id, text] of before) if (texts.get(id) !== text) this.remove(id)
    this.refresh()
  }

  /// Blocks were replaced: the new ones get their icons.
  refresh(): void {
    for (const [id, text] of this.shown) {
      const block = this.workspace.getBlockById(id)
      if (block === null || block.isInsertionMarker() || block.hasIcon(type)) continue
      block.getSvgRoot().classList.add("rosyCommented")
      silently(() => block.addIcon(new TeacherCommentIcon(block).addMessage(bubbleText(text), "teacher")))
    }
  }

  private remove(id: BlockId): void {
    const block = this.workspace.getBlockById(id)
    if (block === null) return
    block.getSvgRoot().classList.remove("rosyCommented")
    silently(() => block.removeIcon(type))
  }
}

/// Icons come and go through events, which would count as the learner's edits.
function silently(act: () => void): void {
  Blockly.Events.disable()
  try {
    act()
  } finally {
    Blockly.Events.enable()
  }
}
