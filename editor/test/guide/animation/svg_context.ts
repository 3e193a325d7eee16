/// Recorder of drawing: a canvas context whose calls become SVG elements, so that the room's own drawing makes an SVG picture.
///
/// Only what the drawing of room and robot uses; a call that is missing here fails. Coordinates are those of the calls: `save`, `translate`, `rotate` and
/// `scale` become groups.

/// A number as SVG reads it, to a tenth of a millimetre.
export const svgNumber = (value: number): string => String(Math.round(value * 10_000) / 10_000 + 0)

/// Draws with a context and returns the elements.
export function drawnSvg(draw: (ctx: CanvasRenderingContext2D) => void): string {
  const recorder = new SvgRecorder()
  draw(recorder as unknown as CanvasRenderingContext2D)
  return recorder.finished()
}

interface Style {
  fillStyle: string
  strokeStyle: string
  lineWidth: number
  lineCap: string
  lineJoin: string
  globalAlpha: number
  dash: readonly number[]
  font: string
}

class SvgRecorder implements Style {
  fillStyle = "#000000"
  strokeStyle = "#000000"
  lineWidth = 1
  lineCap = "butt"
  lineJoin = "miter"
  globalAlpha = 1
  dash: readonly number[] = []
  font = "400 10px sans-serif"
  // The drawing centres all of its texts.
  textAlign = "center"
  textBaseline = "middle"
  private readonly elements: string[] = []
  private readonly saved: {readonly style: Style; readonly groups: number}[] = []
  /// Groups that are open since the last `save`.
  private groups = 0
  private path = ""

  finished(): string {
    return this.elements.join("") + "</g>".repeat(this.groups)
  }

  save(): void {
    const {fillStyle, strokeStyle, lineWidth, lineCap, lineJoin, globalAlpha, dash, font} = this
    const style = {fillStyle, strokeStyle, lineWidth, lineCap, lineJoin, globalAlpha, dash, font}
    this.saved.push({style, groups: this.groups})
    this.groups = 0
  }

  restore(): void {
    const last = this.saved.pop()
    if (last === undefined) throw new Error("expected a save before the restore")
    this.elements.push("</g>".repeat(this.groups))
    this.groups = last.groups
    Object.assign(this, last.style)
  }

  translate(x: number, y: number): void {
    this.opensGroup(`translate(${svgNumber(x)} ${svgNumber(y)})`)
  }

  rotate(angle: number): void {
    this.opensGroup(`rotate(${svgNumber((angle * 180) / Math.PI)})`)
  }

  scale(x: number, y: number): void {
    this.opensGroup(`scale(${svgNumber(x)} ${svgNumber(y)})`)
  }

  setLineDash(dash: readonly number[]): void {
    this.dash = dash
  }

  beginPath(): void {
    this.path = ""
  }

  closePath(): void {
    this.path += "Z"
  }

  moveTo(x: number, y: number): void {
    this.path += `M${svgNumber(x)} ${svgNumber(y)}`
  }

  /// Begins a path that has no point yet (HTML, canvas: "ensure there is a subpath").
  lineTo(x: number, y: number): void {
    this.path += `${this.path === "" ? "M" : "L"}${svgNumber(x)} ${svgNumber(y)}`
  }

  /// A whole circle is two arcs: SVG draws none from a point to itself.
  arc(x: number, y: number, r: number, from: number, to: number): void {
    const at = (angle: number) =>
      `${svgNumber(x + r * Math.cos(angle))} ${svgNumber(y + r * Math.sin(angle))}`
    const radii = `${svgNumber(r)} ${svgNumber(r)} 0`
    this.path += `${this.path === "" ? "M" : "L"}${at(from)}`
    const isWhole = to - from >= 2 * Math.PI
    if (isWhole) this.path += `A${radii} 0 1 ${at(from + Math.PI)}A${radii} 0 1 ${at(from)}`
    else this.path += `A${radii} ${to - from > Math.PI ? 1 : 0} 1 ${at(to)}`
  }

  roundRect(x: number, y: number, w: number, h: number, r: number): void {
    const corner = (px: number, py: number) =>
      `A${svgNumber(r)} ${svgNumber(r)} 0 0 1 ${svgNumber(px)} ${svgNumber(py)}`
    this.moveTo(x + r, y)
    this.path += `H${svgNumber(x + w - r)}${corner(x + w, y + r)}V${svgNumber(y + h - r)}${corner(x + w - r, y + h)}`
    this.path += `H${svgNumber(x + r)}${corner(x, y + h - r)}V${svgNumber(y + r)}${corner(x + r, y)}Z`
  }

  fill(): void {
    this.elements.push(`<path d="${this.path}" fill="${this.fillStyle}"${this.opacity()}/>`)
  }

  stroke(): void {
    if (this.path !== "") this.elements.push(`<path d="${this.path}" fill="none"${this.strokes()}/>`)
  }

  fillRect(x: number, y: number, w: number, h: number): void {
    this.elements.push(`<rect ${box(x, y, w, h)} fill="${this.fillStyle}"${this.opacity()}/>`)
  }

  strokeRect(x: number, y: number, w: number, h: number): void {
    this.elements.push(`<rect ${box(x, y, w, h)} fill="none"${this.strokes()}/>`)
  }

  fillText(text: string, x: number, y: number): void {
    const [, weight = "", size = ""] = /^(\d+) ([\d.]+)px /.exec(this.font) ?? []
    const font = `font-family="sans-serif" font-weight="${weight}" font-size="${svgNumber(Number(size))}"`
    const place = `x="${svgNumber(x)}" y="${svgNumber(y)}" text-anchor="middle" dominant-baseline="central"`
    this.elements.push(`<text ${place} ${font} fill="${this.fillStyle}">${text}</text>`)
  }

  private opensGroup(transform: string): void {
    this.elements.push(`<g transform="${transform}">`)
    this.groups += 1
  }

  private opacity(): string {
    return this.globalAlpha === 1 ? "" : ` opacity="${svgNumber(this.globalAlpha)}"`
  }

  private strokes(): string {
    const dash = this.dash.length === 0 ? "" : ` stroke-dasharray="${this.dash.map(svgNumber).join(" ")}"`
    const cap = this.lineCap === "butt" ? "" : ` stroke-linecap="${this.lineCap}"`
    const join = this.lineJoin === "miter" ? "" : ` stroke-linejoin="${this.lineJoin}"`
    return ` stroke="${this.strokeStyle}" stroke-width="${svgNumber(this.lineWidth)}"${cap}${join}${dash}${this.opacity()}`
  }
}

const box = (x: number, y: number, w: number, h: number): string =>
  `x="${svgNumber(x)}" y="${svgNumber(y)}" width="${svgNumber(w)}" height="${svgNumber(h)}"`
