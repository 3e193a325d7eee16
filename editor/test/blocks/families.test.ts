import {readFileSync} from "node:fs"
import {describe, expect, test} from "vitest"
import {contrast, families, fills, ink, mix, type Tone} from "../../src/blocks/families.ts"
import {socketShade} from "../../src/blocks/style.ts"
import {fillOf} from "../../src/blocks/theme.ts"

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

test("contrast is WCAG's: black on white is 21, a colour on itself 1", () => {
  expect(contrast("#000000", "#ffffff")).toBeCloseTo(21)
  expect(contrast("#123456", "#123456")).toBeCloseTo(1)
})

test("mixing nothing changes nothing, mixing all gives the other", () => {
  expect(mix("#0b6fa4", "#000000", 0)).toBe("#0b6fa4")
  expect(mix("#0b6fa4", "#fedcba", 1)).toBe("#fedcba")
})
