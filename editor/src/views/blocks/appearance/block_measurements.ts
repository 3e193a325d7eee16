/// Measurements of a block for the Blockly renderer: round corners, spacing of rows, and room for hints.

import * as Blockly from "blockly/core"
import {ButtonField} from "../construction/fields.ts"
import {connectionStyleOf} from "../construction/theme.ts"
import {inDefinitions} from "./render_constants.ts"

/// Average width of a character of a hint, which is short and small: exact enough to leave room, and free.
const hintCharacter = 6.6

/// In a stack only the outer corners are round, so that steps stand flush.
class TopEdge extends Blockly.zelos.TopRow {
  override hasLeftSquareCorner(block: Blockly.BlockSvg): boolean {
    return super.hasLeftSquareCorner(block) || block.getPreviousBlock() !== null
  }
}

class BottomEdge extends Blockly.zelos.BottomRow {
  override hasLeftSquareCorner(block: Blockly.BlockSvg): boolean {
    return super.hasLeftSquareCorner(block) || block.getNextBlock() !== null
  }
}

/// Pixels: the height of a row that holds only `+` and `−`.
const pressRow = 24

function isPress(element: Blockly.blockRendering.Measurable): boolean {
  return Blockly.blockRendering.Types.isField(element) && element.field instanceof ButtonField
}

export class BlockMeasurements extends Blockly.zelos.RenderInfo {
  override topRow = new TopEdge(this.constants_)
  override bottomRow = new BottomEdge(this.constants_)

  protected override populateTopRow_(): void {
    super.populateTopRow_()
    if (this.outputConnection === null || this.hasStatementInput) {
      this.topRow.minHeight = this.constants_.CORNER_RADIUS
    }
  }

  // A round corner needs its whole radius, and a row claims only half of it.
  protected override populateBottomRow_(): void {
    super.populateBottomRow_()
    if (this.outputConnection === null || this.hasStatementInput) {
      this.bottomRow.minHeight = this.constants_.CORNER_RADIUS
    }
  }

  // The top row of these blocks has room for its round corners already.
  override getSpacerRowHeight_(
    ...[before, after]: Parameters<Blockly.zelos.RenderInfo["getSpacerRowHeight_"]>
  ): number {
    const {Types} = Blockly.blockRendering
    const round = this.outputConnection === null || this.hasStatementInput
    if (round && Types.isTopRow(before) && Types.isInputRow(after) && !after.hasStatement) return 0
    return super.getSpacerRowHeight_(before, after)
  }

  override getInRowSpacing_(
    ...[before, after]: Parameters<Blockly.zelos.RenderInfo["getInRowSpacing_"]>
  ): number {
    const {Types} = Blockly.blockRendering
    if (before !== null && after !== null && Types.isLeftSquareCorner(before)) {
      if (Types.isPreviousConnection(after) || Types.isNextConnection(after)) return after.notchOffset
    }
    return super.getInRowSpacing_(before, after)
  }

  // Zelos makes room for a notch that definitions do not have.
  protected override adjustXPosition_(): void {
    if (!inDefinitions(this.block_.previousConnection)) super.adjustXPosition_()
  }

  override addInput_(input: Blockly.Input, row: Parameters<Blockly.zelos.RenderInfo["addInput_"]>[1]): void {
    super.addInput_(input, row)
    if (input.fieldRow.length > 0 && row.elements.every(isPress))
      row.minHeight = Math.min(row.minHeight, pressRow)
    const last = row.elements[row.elements.length - 1]
    if (last === undefined || !Blockly.blockRendering.Types.isInlineInput(last)) return
    const connection = input.connection
    if (connection === null || last.connectedBlockWidth > 0) return
    const hint = connectionStyleOf(connection).hint
    const room = hint.length * hintCharacter - last.connectionWidth
    last.width = Math.max(last.width, last.connectionWidth * 2 + room + 6)
  }
}
