/// What lies above what: a question about a connection is not covered by the borders between regions, which are dragged.

import {readFileSync} from "node:fs"
import {expect, test} from "vitest"

/// The `z-index` of each rule of a style sheet whose selector begins so.
function levels(file: string, selector: string): readonly number[] {
  const css = readFileSync(new URL(`../../src/styles/${file}.css`, import.meta.url), "utf8")
  return [...css.matchAll(/([^{}]+)\{([^{}]*)\}/g)].flatMap(([, selectors = "", body = ""]) => {
    const level = /z-index: (\d+);/.exec(body)?.[1]
    return level !== undefined && selectors.trim().startsWith(selector) ? [Number(level)] : []
  })
}

test("the buttons of a question about a connection are above the borders between regions", () => {
  const borders = levels("regions", ".border")
  expect(borders.length).toBeGreaterThan(0)
  expect(Math.min(...levels("diagram", ".diagram-ask"))).toBeGreaterThan(Math.max(...borders))
})
