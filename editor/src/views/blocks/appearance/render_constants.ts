/// Constants of the Blockly renderer: sizes, an outline per family, and straight edges for definitions.

import * as Blockly from "blockly/core"
import {connectionStyleOf} from "../construction/theme.ts"
import {type Outline, outlineOf, outlines, padding, pen, sides} from "./outlines.ts"

type Shape = ReturnType<Blockly.zelos.ConstantProvider["shapeFor"]>
type DynamicShape = Extract<Shape, {isDynamic: boolean}>
type NotchShape = ReturnType<Blockly.zelos.ConstantProvider["makeNotch"]>

/// Numbers of our outlines in Blockly's table of shapes, after its own five.
const shapeNumber = (outline: Outline) => 10 + outlines.indexOf(outline)

function dynamicShape(outline: Outline): DynamicShape {
  const {left, right} = sides[outline]
  return {
    type: shapeNumber(outline),
    isDynamic: true,
    width: height => left.width(height),
    height: height => height,
    connectionOffsetY: height => height / 2,
    connectionOffsetX: width => -width,
    pathDown: height => left.path(height, pen(false, false)),
    pathUp: height => left.path(height, pen(false, true)),
    pathRightDown: height => right.path(height, pen(true, false)),
    pathRightUp: height => right.path(height, pen(true, true)),
  }
}

/// Definitions stack in `where` and `let`, but are no steps: their edges are straight.
const flatNotch: NotchShape = {
  type: 5,
  width: 24,
  height: 0,
  pathLeft: " h 24",
  pathRight: " h -24",
}

export function inDefinitions(connection: Blockly.Connection | null): boolean {
  return connection?.getCheck()?.includes("definition") ?? false
}

export class Constants extends Blockly.zelos.ConstantProvider {
  private readonly byOutline = new Map(outlines.map(outline => [outline, dynamicShape(outline)]))

  constructor() {
    super()
    // Pixels. Smaller than zelos, which is made for tablets: a function should be read as one sentence.
    this.CORNER_RADIUS = 11
    this.MIN_BLOCK_HEIGHT = 30
    this.TOP_ROW_MIN_HEIGHT = 3
    this.BOTTOM_ROW_MIN_HEIGHT = 3
    this.DUMMY_INPUT_MIN_HEIGHT = 24
    this.EMPTY_INLINE_INPUT_HEIGHT = 26
    this.EMPTY_INLINE_INPUT_PADDING = 14
    this.EMPTY_STATEMENT_INPUT_HEIGHT = 34
    this.STATEMENT_INPUT_SPACER_MIN_WIDTH = 120
    this.FIELD_BORDER_RECT_RADIUS = 13
    this.FIELD_BORDER_RECT_X_PADDING = 9
    this.FIELD_BORDER_RECT_Y_PADDING = 3
    this.FIELD_BORDER_RECT_COLOUR = "#ffffff"
    // An arrow of text has the colour of the text in every theme, a picture has not.
    this.FIELD_DROPDOWN_SVG_ARROW = false
    this.FIELD_DROPDOWN_COLOURED_DIV = false
    this.FIELD_TEXTINPUT_BOX_SHADOW = false
    for (const outer of outlines) {
      const inside: Record<number, number> = {0: padding(outer, undefined)}
      for (const inner of outlines) inside[shapeNumber(inner)] = padding(outer, inner)
      this.SHAPE_IN_SHAPE_PADDING[shapeNumber(outer)] = inside
    }
  }

  override shapeFor(connection: Blockly.RenderedConnection): Shape {
    switch (connection.type) {
      case Blockly.ConnectionType.INPUT_VALUE:
      case Blockly.ConnectionType.OUTPUT_VALUE:
        return this.byOutline.get(outlineOf[connectionStyleOf(connection).family])!
      default:
        return inDefinitions(connection) ? flatNotch : super.shapeFor(connection)
    }
  }

  override getCSS_(selector: string): string[] {
    // Zelos paints fields in fixed colours and the selection with a filter, which is slow on large blocks.
    return [
      `${selector} .blocklyText, ${selector} .blocklyFlyoutLabelText {`,
      `font: ${this.FIELD_TEXT_FONTWEIGHT} ${this.FIELD_TEXT_FONTSIZE}pt ${this.FIELD_TEXT_FONTFAMILY};`,
      "}",
      `${selector} .blocklyHtmlInput {`,
      `font-family: ${this.FIELD_TEXT_FONTFAMILY}; font-weight: ${this.FIELD_TEXT_FONTWEIGHT};`,
      "}",
      `${selector} .blocklyInsertionMarker>.blocklyPath {`,
      `fill-opacity: ${this.INSERTION_MARKER_OPACITY}; stroke: none;`,
      "}",
    ]
  }
}
