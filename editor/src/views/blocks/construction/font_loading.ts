/// Fonts of the blocks: when they have arrived, blocks and toolbox are measured again.

import type * as Blockly from "blockly/core"
import {clearWidthCache} from "./text_width.ts"

/// What words on blocks are set in (`theme.ts`, `appearance/style_sheet.ts`).
const fonts = ['600 14px "Inter"', '700 14px "Inter"', '500 12px "Inter"', '500 12px "JetBrains Mono"']

/// Measures all blocks again when the fonts have arrived, and tells: widths measured before are wrong.
export function measureWhenFontsArrive(workspace: Blockly.WorkspaceSvg, measured: () => void): void {
  void Promise.all(fonts.map(font => document.fonts.load(font))).then(() => {
    clearWidthCache()
    measureAgain(workspace)
    // The toolbox is as wide as its words, and what stands beside it must know.
    workspace.getToolbox()?.handleToolboxItemResize()
    measured()
  })
}

function measureAgain(workspace: Blockly.WorkspaceSvg): void {
  for (const one of [workspace, workspace.getFlyout()?.getWorkspace()]) {
    for (const block of one?.getAllBlocks(false) ?? []) {
      for (const input of block.inputList) for (const field of input.fieldRow) field.markDirty()
      block.queueRender()
    }
  }
}
