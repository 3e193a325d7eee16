/// What is wrong with how a page looks: axe-core's findings (WCAG 2.2 A and AA), controls under others, blocks that are cut, scrolling to the side.

import {AxeBuilder} from "@axe-core/playwright"
import type {Page} from "@playwright/test"

const standard = ["wcag2a", "wcag2aa", "wcag21a", "wcag21aa", "wcag22aa"]

/// What axe has against a part of the page, or all of it. What blocks look like is drawn, and `editor/test/blocks/theme.test.ts` holds its
/// contrast.
export async function faults(page: Page, part = "body"): Promise<readonly string[]> {
  const {violations} = await new AxeBuilder({page})
    .include(part)
    .exclude(".blocklyWorkspace")
    .withTags(standard)
    .analyze()
  return violations.flatMap(({id, nodes}) => nodes.map(node => `${id}: ${node.target.join(" ")}`))
}

/// Controls that are in sight, but have something else at their middle. With an open dialog only its own.
export function covered(page: Page): Promise<readonly string[]> {
  return page.evaluate(() => {
    const root = document.querySelector("dialog[open]") ?? document.body
    const controls = [...root.querySelectorAll("button, a[href], input, select, textarea")]
    const middle = (box: DOMRect) => ({x: box.x + box.width / 2, y: box.y + box.height / 2})
    const inside = ({x, y}: {x: number; y: number}, box: DOMRect) =>
      x >= box.left && x < box.right && y >= box.top && y < box.bottom
    /// Not scrolled out of what is around it.
    const isInSight = (one: Element) => {
      const at = middle(one.getBoundingClientRect())
      if (!inside(at, new DOMRect(0, 0, innerWidth, innerHeight))) return false
      for (let around = one.parentElement; around !== null; around = around.parentElement)
        if (getComputedStyle(around).overflow !== "visible" && !inside(at, around.getBoundingClientRect()))
          return false
      return one.checkVisibility({visibilityProperty: true, opacityProperty: true})
    }
    return controls.filter(isInSight).flatMap(one => {
      const {x, y} = middle(one.getBoundingClientRect())
      const there = document.elementFromPoint(x, y)
      const own =
        there === null || one.contains(there) || there.contains(one) || there.closest("label")?.contains(one)
      const name = (element: Element) =>
        `${element.tagName} ${element.getAttribute("aria-label") ?? element.textContent?.slice(0, 30) ?? ""}`
      return own ? [] : [`${name(one)} is under ${name(there)}`]
    })
  })
}

/// Blocks that stick out of the visible workspace.
export function cutBlocks(page: Page): Promise<readonly string[]> {
  return page.evaluate(() => {
    const view = document.querySelector(".blocklySvg")!.getBoundingClientRect()
    const left = document.querySelector(".blocklyToolbox")?.getBoundingClientRect().right ?? view.left
    return [
      ...document.querySelectorAll(".blocklySvg .blocklyBlockCanvas .blocklyDraggable > .blocklyPath"),
    ].flatMap(path => {
      const box = path.getBoundingClientRect()
      const fits = box.left >= left - 1 && box.right <= view.right + 1 && box.bottom <= view.bottom + 1
      return fits ? [] : [path.getAttribute("aria-label") ?? "a block"]
    })
  })
}

/// Controls and words in the bars at the top of the page, of the regions and below the room that lie over each other, and words that are cut off; a program's name may be.
export function crowded(page: Page): Promise<readonly string[]> {
  return page.evaluate(() => {
    const parts = [
      ...document.querySelectorAll<HTMLElement>(
        ":is(.topbar, .region-head, .roombar, .timebar) :is(button, input, select, h1, h2, .saved, .state, .clock)",
      ),
    ].filter(one => one.checkVisibility() && getComputedStyle(one).clipPath === "none")
    const name = (one: HTMLElement) => one.ariaLabel ?? one.textContent ?? one.tagName
    const over = parts.flatMap((one, i) => {
      const a = one.getBoundingClientRect()
      return parts.slice(i + 1).flatMap(other => {
        const b = other.getBoundingClientRect()
        const across = Math.min(a.right, b.right) - Math.max(a.left, b.left)
        const down = Math.min(a.bottom, b.bottom) - Math.max(a.top, b.top)
        return across > 1 && down > 1 ? [`${name(one)} and ${name(other)}`] : []
      })
    })
    const isCut = (one: HTMLElement) =>
      one.tagName !== "INPUT" &&
      (one.scrollWidth > one.clientWidth + 1 || one.scrollHeight > one.clientHeight + 1)
    const words = parts.flatMap(one => [one, ...one.querySelectorAll<HTMLElement>("span")])
    return [...over, ...words.filter(isCut).map(one => `${name(one)} is cut off`)]
  })
}

/// Where the parts of the page are, in pixels.
export function places(page: Page): Promise<readonly string[]> {
  return page.evaluate(() =>
    [
      ...document.querySelectorAll(
        ".topbar > :not(.space), .region, .canvas-host, .timebar, .timebar button, .tabs",
      ),
    ].map(one => {
      const {x, y, width, height} = one.getBoundingClientRect()
      return `${one.tagName} ${one.classList[0]}: ${[x, y, width, height].map(Math.round).join()}`
    }),
  )
}

/// Lines of the Haskell that are higher than the lowest one: they are wrapped.
export function wrappedLines(page: Page): Promise<readonly string[]> {
  return page.evaluate(() => {
    const lines = [...document.querySelectorAll("[data-testid=haskell] .cm-line")]
    const heights = lines.map(line => line.getBoundingClientRect().height)
    const lowest = Math.min(...heights)
    return lines.flatMap((line, i) => (heights[i]! > 1.5 * lowest ? [line.textContent ?? ""] : []))
  })
}

/// Pixels by which the page is wider than the window.
export function excessWidth(page: Page): Promise<number> {
  return page.evaluate(() => Math.max(0, (document.scrollingElement?.scrollWidth ?? 0) - innerWidth))
}
