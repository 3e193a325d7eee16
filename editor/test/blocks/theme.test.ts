import {readFileSync} from "node:fs"
import {describe, expect, test} from "vitest"
import {socketShade} from "../../src/views/blocks/appearance/style_sheet.ts"
import {
  contrast,
  edgeOf,
  families,
  fillOf,
  fills,
  ink,
  mix,
  type Tone,
} from "../../src/views/blocks/construction/theme.ts"

const tones: readonly Tone[] = ["light", "dark"]

describe.each(tones)("in %s", tone => {
  test.each(families)("words on %s blocks have a contrast of at least 5:1", family => {
    expect(contrast(fills[tone][family], ink[tone])).toBeGreaterThanOrEqual(5)
  })

  test.each(families)("words on %s patterns and in empty sockets have it too", family => {
    expect(contrast(fillOf(tone, family, true), ink[tone])).toBeGreaterThanOrEqual(5)
    const socket = mix(fills[tone][family], "#000000", socketShade[tone])
    expect(contrast(socket, ink[tone])).toBeGreaterThanOrEqual(5)
  })

  test("the colours are the page's tokens", () => {
    const tokens = readFileSync(new URL("../../src/styles/tokens.css", import.meta.url), "utf8")
    const [light, dark] = tokens.split(':root[data-theme="dark"]')
    for (const family of families) {
      expect(tone === "light" ? light : dark).toContain(`--${family}: ${fills[tone][family]};`)
    }
  })
})

/// Machado, Oliveira, Fernandes, “A physiologically-based model for simulation of color vision deficiency”, 2009, table 1, severity 1.0: linear RGB
/// to linear RGB.
const deficiencies = {
  deuteranopia: [
    [0.367322, 0.860646, -0.227968],
    [0.280085, 0.672501, 0.047413],
    [-0.01182, 0.04294, 0.968881],
  ],
  protanopia: [
    [0.152286, 1.052583, -0.204868],
    [0.114503, 0.786281, 0.099216],
    [-0.003882, -0.048116, 1.051998],
  ],
} as const

/// CIE L*a*b* (D65) of a `#rrggbb` colour, seen with a deficiency.
function seen(colour: string, matrix: readonly (readonly number[])[]): readonly [number, number, number] {
  const linear = [1, 3, 5].map(at => {
    const c = Number.parseInt(colour.slice(at, at + 2), 16) / 255
    return c <= 0.04045 ? c / 12.92 : ((c + 0.055) / 1.055) ** 2.4
  })
  const times = (rows: readonly (readonly number[])[], v: readonly number[]) =>
    rows.map(row => row.reduce((sum, share, i) => sum + share * (v[i] ?? 0), 0))
  const rgb = times(matrix, linear).map(c => Math.min(1, Math.max(0, c)))
  const [x = 0, y = 0, z = 0] = times(
    [
      [0.4124564 / 0.95047, 0.3575761 / 0.95047, 0.1804375 / 0.95047],
      [0.2126729, 0.7151522, 0.072175],
      [0.0193339 / 1.08883, 0.119192 / 1.08883, 0.9503041 / 1.08883],
    ],
    rgb,
  ).map(t => (t > 216 / 24389 ? Math.cbrt(t) : ((24389 / 27) * t + 16) / 116))
  return [116 * y - 16, 500 * (x - y), 200 * (y - z)]
}

const pairs = families.flatMap((one, i) => families.slice(i + 1).map(other => [one, other] as const))

describe.each(Object.entries(deficiencies))("with %s", (_, matrix) => {
  test.each(tones)("hues that look alike in %s differ in lightness", tone => {
    const alike = pairs.filter(([one, other]) => {
      const [lightness, a, b] = seen(fills[tone][one], matrix)
      const [otherLightness, otherA, otherB] = seen(fills[tone][other], matrix)
      return Math.hypot(a - otherA, b - otherB) < 15 && Math.abs(lightness - otherLightness) < 7
    })
    expect(alike).toEqual([])
  })
})

test.each(families)("a %s block is told apart from one of its family around it by its edge", family => {
  for (const tone of ["light", "dark"] as const)
    expect(contrast(fillOf(tone, family, false), edgeOf(tone, family, false))).toBeGreaterThanOrEqual(1.5)
})

test("contrast is WCAG's: black on white is 21, a colour on itself 1", () => {
  expect(contrast("#000000", "#ffffff")).toBeCloseTo(21)
  expect(contrast("#123456", "#123456")).toBeCloseTo(1)
})

test("mixing nothing changes nothing, mixing all gives the other", () => {
  expect(mix("#0b6fa4", "#000000", 0)).toBe("#0b6fa4")
  expect(mix("#0b6fa4", "#fedcba", 1)).toBe("#fedcba")
})
