/// Colours of the eight block families in light and dark, Blockly's themes made of them, and the appearance of each connection.
///
/// `styles/tokens.css` has the same colours for the page (`--event`, `--state`, …). Blockly's themes need hexadecimal numbers, so they are repeated here; a test checks
/// contrast and equality.

import type {Family} from "@rosy/codegen"
import * as Blockly from "blockly/core"

export type Tone = "light" | "dark"

export const families: readonly Family[] = [
  "event",
  "state",
  "command",
  "memory",
  "task",
  "number",
  "choice",
  "own",
]

/// Fill of a block; every one has a contrast of at least 5:1 against `ink` of the same tone (WCAG 2.2 §1.4.3). Two hues that red-green
/// blindness merges differ in lightness.
export const fills: Readonly<Record<Tone, Readonly<Record<Family, string>>>> = {
  light: {
    event: "#a75900",
    state: "#1372a7",
    command: "#0f7c57",
    memory: "#6337a7",
    task: "#990043",
    number: "#355ed4",
    choice: "#992b04",
    own: "#5e6671",
  },
  dark: {
    event: "#feb55c",
    state: "#a9deff",
    command: "#6cebb9",
    memory: "#ba99ed",
    task: "#fa81ab",
    number: "#abbdfe",
    choice: "#f39069",
    own: "#bec7d4",
  },
}

/// Words on blocks.
export const ink: Readonly<Record<Tone, string>> = {light: "#ffffff", dark: "#11151b"}

/// `colour` with a share of `other` mixed in; both `#rrggbb`.
export function mix(colour: string, other: string, share: number): string {
  const channel = (at: number) => {
    const a = Number.parseInt(colour.slice(at, at + 2), 16)
    const b = Number.parseInt(other.slice(at, at + 2), 16)
    return Math.round(a + (b - a) * share)
      .toString(16)
      .padStart(2, "0")
  }
  return `#${channel(1)}${channel(3)}${channel(5)}`
}

/// WCAG 2.2 contrast ratio of two `#rrggbb` colours, 1 to 21.
export function contrast(one: string, two: string): number {
  const luminance = (colour: string) => {
    const linear = (at: number) => {
      const c = Number.parseInt(colour.slice(at, at + 2), 16) / 255
      return c <= 0.04045 ? c / 12.92 : ((c + 0.055) / 1.055) ** 2.4
    }
    return 0.2126 * linear(1) + 0.7152 * linear(3) + 0.0722 * linear(5)
  }
  const [a, b] = [luminance(one), luminance(two)]
  return (Math.max(a, b) + 0.05) / (Math.min(a, b) + 0.05)
}

/// How much darker a pattern is than the definition it stands in, so that the two are told apart where they touch.
const patternShade: Record<Tone, number> = {light: 0.2, dark: 0.16}
const edgeShade: Record<Tone, number> = {light: 0.26, dark: 0.34}

/// Least contrast of a block's edge and its fill, and the share of white in an edge that is lighter than the fill.
const leastEdge = 1.5
const lightEdge = 0.5

/// The name of a block's style in the themes below.
export function styleName(family: Family, pattern: boolean): string {
  return pattern ? `${family}_pattern` : family
}

/// The fill of a block in a tone, also for the contrast test.
export function fillOf(tone: Tone, family: Family, pattern: boolean): string {
  const fill = fills[tone][family]
  return pattern ? mix(fill, tone === "light" ? "#000000" : "#ffffff", patternShade[tone]) : fill
}

/// The edge of a block: darker than its fill, or lighter where a darker one could not be seen between blocks of one family in one another,
/// as of steps in a task.
export function edgeOf(tone: Tone, family: Family, pattern: boolean): string {
  const fill = fillOf(tone, family, pattern)
  const darker = mix(fill, "#000000", edgeShade[tone])
  return pattern || contrast(fill, darker) >= leastEdge ? darker : mix(fill, "#ffffff", lightEdge)
}

const ground: Record<Tone, {workspace: string; paper: string; text: string; line: string}> = {
  light: {workspace: "#f5f6f8", paper: "#ffffff", text: "#1c2230", line: "#c3c8d2"},
  dark: {workspace: "#0f1217", paper: "#171b22", text: "#e9ecf2", line: "#434c5c"},
}

function theme(tone: Tone): Blockly.Theme {
  const blockStyles: Record<string, Partial<Blockly.Theme.BlockStyle>> = {}
  const categoryStyles: Record<string, Blockly.Theme.CategoryStyle> = {}
  for (const family of families) {
    for (const pattern of [false, true]) {
      const colourPrimary = fillOf(tone, family, pattern)
      blockStyles[styleName(family, pattern)] = {
        colourPrimary,
        colourSecondary: mix(colourPrimary, ground[tone].workspace, 0.3),
        colourTertiary: edgeOf(tone, family, pattern),
      }
    }
    categoryStyles[family] = {colour: fills[tone][family]}
  }
  const g = ground[tone]
  return Blockly.Theme.defineTheme(`rosy_${tone}`, {
    name: `rosy_${tone}`,
    blockStyles,
    categoryStyles,
    componentStyles: {
      workspaceBackgroundColour: g.workspace,
      toolboxBackgroundColour: g.paper,
      toolboxForegroundColour: g.text,
      flyoutBackgroundColour: g.paper,
      flyoutForegroundColour: g.text,
      flyoutOpacity: 1,
      scrollbarColour: g.line,
      scrollbarOpacity: 0.7,
      insertionMarkerColour: ink[tone === "light" ? "dark" : "light"],
      insertionMarkerOpacity: 0.22,
    },
    // Points; 10.9 pt are 14.5 px.
    fontStyle: {family: "Inter, system-ui, sans-serif", weight: "600", size: 10.9},
  })
}

/// Themes are registered by name with Blockly, once for the page.
export function themes(): Record<Tone, Blockly.Theme> {
  return {light: theme("light"), dark: theme("dark")}
}

export interface ConnectionStyle {
  readonly family: Family
  /// One or two words, for a socket.
  readonly hint: string
  /// A socket that must be filled before the program can run.
  readonly hole: boolean
}

const looks = new WeakMap<Blockly.Connection, ConnectionStyle>()

const plain: ConnectionStyle = {family: "own", hint: "", hole: false}

export function connectionStyleOf(connection: Blockly.Connection): ConnectionStyle {
  return looks.get(connection) ?? plain
}

/// Whether anything changed, so that only those blocks are drawn again whose look did.
export function setConnectionStyle(connection: Blockly.Connection, look: ConnectionStyle): boolean {
  const old = looks.get(connection)
  if (old !== undefined && old.family === look.family && old.hint === look.hint && old.hole === look.hole)
    return false
  looks.set(connection, look)
  return true
}
