/// Blockly's themes for Rosy: one style per family, a second for its patterns, in light and in dark.

import type {Family} from "@rosy/codegen"
import * as Blockly from "blockly/core"
import {families, fills, ink, mix, type Tone} from "./families.ts"

/// How much darker a pattern is than the definition it stands in, so that the two are told apart where they touch.
const patternShade: Record<Tone, number> = {light: 0.2, dark: 0.16}
const edgeShade: Record<Tone, number> = {light: 0.26, dark: 0.34}

/// The name of a block's style in the themes below.
export function styleName(family: Family, pattern: boolean): string {
  return pattern ? `${family}_pattern` : family
}

/// The fill of a block in a tone, also for the contrast test.
export function fillOf(tone: Tone, family: Family, pattern: boolean): string {
  const fill = fills[tone][family]
  return pattern ? mix(fill, tone === "light" ? "#000000" : "#ffffff", patternShade[tone]) : fill
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
        colourTertiary: mix(colourPrimary, "#000000", edgeShade[tone]),
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
