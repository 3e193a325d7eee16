/// Draws blocks: Blockly's zelos with an outline per family, words in empty sockets, and a second line around
/// memory. Colours come from `theme.ts`, the rest of the appearance from `style.ts`.
///
/// Never decides what fits: an outline is only a picture of a type.

import * as Blockly from "blockly/core"
import {Press} from "./fields.ts"
import {lookOf} from "./looks.ts"
import {type Outline, outlineOf, outlines, padding, pen, sides} from "./outlines.ts"

/// The name to give to `Blockly.inject`.
export const rendererName = "rosy"

type Shape = ReturnType<Blockly.zelos.ConstantProvider["shapeFor"]>
type DynamicShape = Extract<Shape, {isDynamic: boolean}>
type NotchShape = ReturnType<Blockly.zelos.ConstantProvider["makeNotch"]>

/// Numbers of our outlines in Blockly's table of shapes, after its own five.
const shapeNumber = (outline: Outline) => 10 + outlines.indexOf(outline)
const outlineNumbered = (shape: number): Outline | undefined => outlines[shape - 10]

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

function inDefinitions(connection: Blockly.Connection | null): boolean {
  return connection?.getCheck()?.includes("definition") ?? false
}

class Constants extends Blockly.zelos.ConstantProvider {
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
        return this.byOutline.get(outlineOf[lookOf(connection).family])!
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

/// What a socket or the end of a stack is called; the end of a stack that stands free is no place to fill.
function placeName(connection: Blockly.RenderedConnection): string | undefined {
  const input = connection.getParentInput()
  if (input !== null) return input.getAriaLabelText() ?? Blockly.Msg.INPUT_LABEL_EMPTY
  const around = connection.getSourceBlock().getTopStackBlock().previousConnection?.targetConnection
  const stack = around?.getParentInput()?.getAriaLabelText()
  return stack == null ? undefined : Blockly.Msg.INPUT_LABEL_END_STATEMENT?.replace("%1", stack)
}

/// Adds to a block's picture what zelos has not: a ring around memory, hints in empty sockets.
class Picture extends Blockly.zelos.PathObject {
  private ring: SVGElement | undefined
  private readonly hints = new Map<string, SVGTextElement>()
  private used = new Set<string>()

  override setPath(path: string): void {
    super.setPath(path)
    this.ring?.setAttribute("d", path)
  }

  override flipRTL(): void {
    super.flipRTL()
    this.ring?.setAttribute("transform", "scale(-1 1)")
  }

  override applyColour(block: Blockly.BlockSvg): void {
    super.applyColour(block)
    this.paintRing()
  }

  override beginDrawing(): void {
    super.beginDrawing()
    this.used = new Set()
  }

  override endDrawing(): void {
    super.endDrawing()
    for (const [name, text] of this.hints) {
      if (this.used.has(name)) continue
      text.remove()
      this.hints.delete(name)
    }
  }

  /// Blockly names a place when the keyboard comes to it. Who explores with a finger or a reading cursor hears the empty
  /// ones too, and nothing of those that are none.
  override addConnectionHighlight(
    ...drawn: Parameters<Blockly.zelos.PathObject["addConnectionHighlight"]>
  ): SVGElement {
    const place = super.addConnectionHighlight(...drawn)
    const [connection] = drawn
    const empty = connection.isSuperior() && connection.targetBlock() === null
    const name = empty ? placeName(connection) : undefined
    if (name === undefined) place.setAttribute("aria-hidden", "true")
    else {
      place.removeAttribute("aria-hidden")
      place.setAttribute("aria-label", name)
    }
    return place
  }

  /// The second line of memory and Maybe: a wider copy behind the block.
  setRing(wanted: boolean): void {
    this.setClass_("rosyRinged", wanted)
    if (wanted && this.ring === undefined) {
      this.ring = Blockly.utils.dom.createSvgElement(Blockly.utils.Svg.PATH, {class: "rosyRing"})
      this.svgRoot.insertBefore(this.ring, this.svgPath)
      this.paintRing()
    } else if (!wanted && this.ring !== undefined) {
      this.ring.remove()
      this.ring = undefined
    }
  }

  private paintRing(): void {
    this.ring?.setAttribute("fill", this.style.colourPrimary)
    this.ring?.setAttribute("stroke", this.style.colourPrimary)
  }

  /// The text element of a hint; made when first measured, gone when its socket is filled.
  hint(name: string, words: string): SVGTextElement {
    this.used.add(name)
    let text = this.hints.get(name)
    if (text === undefined) {
      text = Blockly.utils.dom.createSvgElement(
        Blockly.utils.Svg.TEXT,
        {class: "rosyHint", "dominant-baseline": "central", "aria-hidden": "true"},
        this.svgRoot,
      )
      this.hints.set(name, text)
    }
    if (text.textContent !== words) text.textContent = words
    // Empty sockets are drawn into the same group; the word belongs on top of them.
    this.svgRoot.appendChild(text)
    return text
  }
}

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
const pressRow = 18

function isPress(element: Blockly.blockRendering.Measurable): boolean {
  return Blockly.blockRendering.Types.isField(element) && element.field instanceof Press
}

class Measures extends Blockly.zelos.RenderInfo {
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
    const hint = lookOf(connection).hint
    const room = hint.length * hintCharacter - last.connectionWidth
    last.width = Math.max(last.width, last.connectionWidth * 2 + room + 6)
  }
}

class Drawer extends Blockly.zelos.Drawer {
  override draw(): void {
    const picture = this.block_.pathObject as Picture
    const output = this.info_.outputConnection
    picture.setRing(output !== null && lookOf(output.connectionModel).family === "memory")
    super.draw()
  }

  // A collapsed block has a straight edge, and Blockly's own is drawn from where the corner ended.
  protected override drawJaggedEdge_(row: Parameters<Blockly.zelos.Drawer["drawRightSideRow_"]>[0]): void {
    this.outlinePath_ += ` V ${row.yPos + row.height}`
  }

  override drawInlineInput_(input: Parameters<Blockly.zelos.Drawer["drawInlineInput_"]>[0]): void {
    super.drawInlineInput_(input)
    if (input.connectedBlock !== null || this.info_.isInsertionMarker) return
    const {hint, hole} = lookOf(input.connectionModel)
    const picture = this.block_.pathObject as Picture
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

  protected override makeRenderInfo_(block: Blockly.BlockSvg): Measures {
    return new Measures(this, block)
  }

  protected override makeDrawer_(block: Blockly.BlockSvg, info: Blockly.blockRendering.RenderInfo): Drawer {
    return new Drawer(block, info as Measures)
  }

  override makePathObject(root: SVGElement, style: Blockly.Theme.BlockStyle): Picture {
    return new Picture(root, style, this.getConstants())
  }
}

/// Tells Blockly about the renderer; once for the page.
export function registerRenderer(): void {
  Blockly.blockRendering.register(rendererName, Renderer)
}

/// @internal
export const outlineNumber = {of: shapeNumber, outline: outlineNumbered}
