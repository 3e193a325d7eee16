/// Blockly renderer: zelos with an outline per family, hints in empty sockets, and a second line around memory. Colours come from `theme.ts`, the rest of the appearance
/// from `style_sheet.ts`. It does not decide what fits: an outline only shows a type.

import * as Blockly from "blockly/core"
import {connectionStyleOf} from "../construction/theme.ts"
import {BlockMeasurements} from "./block_measurements.ts"
import {BlockPath} from "./block_path.ts"
import {Constants} from "./render_constants.ts"

/// The name to give to `Blockly.inject`.
export const rendererName = "rosy"

class Drawer extends Blockly.zelos.Drawer {
  override draw(): void {
    const picture = this.block_.pathObject as BlockPath
    const output = this.info_.outputConnection
    picture.setRing(output !== null && connectionStyleOf(output.connectionModel).family === "memory")
    super.draw()
  }

  // A collapsed block has a straight edge, and Blockly's own is drawn from where the corner ended.
  protected override drawJaggedEdge_(row: Parameters<Blockly.zelos.Drawer["drawRightSideRow_"]>[0]): void {
    this.outlinePath_ += ` V ${row.yPos + row.height}`
  }

  override drawInlineInput_(input: Parameters<Blockly.zelos.Drawer["drawInlineInput_"]>[0]): void {
    super.drawInlineInput_(input)
    if (input.connectedBlock !== null || this.info_.isInsertionMarker) return
    const {hint, hole} = connectionStyleOf(input.connectionModel)
    const picture = this.block_.pathObject as BlockPath
    picture.getOutlinePath(input.input.name).classList.toggle("rosyHole", hole)
    if (hint === "") return
    const text = picture.hint(input.input.name, hint)
    const x = input.xPos + input.width / 2
    text.setAttribute("x", `${this.info_.RTL ? -x : x}`)
    text.setAttribute("y", `${input.centerline}`)
  }
}

class Renderer extends Blockly.zelos.Renderer {
  protected override makeConstants_(): Constants {
    return new Constants()
  }

  protected override makeRenderInfo_(block: Blockly.BlockSvg): BlockMeasurements {
    return new BlockMeasurements(this, block)
  }

  protected override makeDrawer_(block: Blockly.BlockSvg, info: Blockly.blockRendering.RenderInfo): Drawer {
    return new Drawer(block, info as BlockMeasurements)
  }

  override makePathObject(root: SVGElement, style: Blockly.Theme.BlockStyle): BlockPath {
    return new BlockPath(root, style, this.getConstants())
  }
}

/// Tells Blockly about the renderer; once for the page.
export function registerRenderer(): void {
  Blockly.blockRendering.register(rendererName, Renderer)
}
