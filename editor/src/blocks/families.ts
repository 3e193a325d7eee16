/// The eight families of things a block can be, and their colours in light and in dark.
///
/// `styles/tokens.css` has the same colours for the page (`--event`, `--state`, …); Blockly's themes want plain
/// hexadecimal numbers, so they stand here a second time, and a test holds both the contrast and the match.

import type {Family} from "@rosy/codegen"

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

/// Fill of a block; every one has a contrast of at least 5:1 against `ink` of the same tone (WCAG 2.2 §1.4.3).
export const fills: Readonly<Record<Tone, Readonly<Record<Family, string>>>> = {
  light: {
    event: "#a85a00",
    state: "#0b6fa4",
    command: "#0a7a55",
    memory: "#7446b8",
    task: "#c2185b",
    number: "#2f5bd0",
    choice: "#b3411a",
    own: "#5d6570",
  },
  dark: {
    event: "#f0a64a",
    state: "#6cc3f0",
    command: "#56d6a5",
    memory: "#c2a1f5",
    task: "#ff86b0",
    number: "#8eabff",
    choice: "#ff9b73",
    own: "#b3bcc9",
  },
}

/// Words on blocks.
export const ink: Readonly<Record<Tone, string>> = {light: "#ffffff", dark: "#11151b"}

/// The words a screen reader and a tooltip use for a family.
export const familyWords: Readonly<Record<Family, string>> = {
  event: "event",
  state: "state",
  command: "command",
  memory: "memory or maybe",
  task: "task",
  number: "number",
  choice: "choice",
  own: "value",
}

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
