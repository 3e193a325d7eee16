/// The diagram of a program: it leads to block and text, shows values while the program runs, and is there for keyboard and screen reader.

import {readFileSync} from "node:fs"
import {AxeBuilder} from "@axe-core/playwright"
import {expect, type Page} from "@playwright/test"
import {atRest} from "./at_rest.ts"
import {drawnParts, drawnPoints, pixelsOf} from "./drawing.ts"
import {Learner} from "./learner.ts"
import {test} from "./story.ts"

const diagram = (page: Page) => page.getByRole("region", {name: "Diagram", exact: true})
const node = (page: Page, name: RegExp) => diagram(page).getByRole("button", {name})

async function showsDiagram(page: Page) {
  await page.getByRole("button", {name: "Diagram", exact: true}).click()
  await expect(node(page, /^spin: function/)).toBeVisible()
}

test("a node of the random walker leads to its block and its lines, and values travel while it runs", async ({
  page,
}) => {
  const learner = new Learner(page)
  await learner.opens("randomWalk")
  await showsDiagram(page)
  await learner.keeps("diagram")
  await expect(node(page, /^Bumper: robot event; to bumper$/)).toBeVisible()
  await node(page, /^chgdir: function/).click()
  await expect(page.locator(".blocklySelected").first()).toContainText("chgdir")
  await expect(page.locator(".source-host .hs-linked-line").first()).toContainText("chgdir")
  await learner.runs()
  // The default rate is above five a second: the edge shows the rate and what it carries.
  const carried = diagram(page).locator("text.carried")
  await expect(carried.filter({hasText: /^\d+\/s · (Go|Turn )/}).first()).toBeAttached()
  await expect(node(page, /^Memory Mode: memory/).locator(".value")).toHaveText(/Go|Turn|Stop/)
  await expect(node(page, /^Bumper: robot event/).locator(".value")).toHaveText(
    /^\w+Bumper (Pressed|Released)$/,
  )
  await learner.keeps("diagram-running")
  // The chosen node has its questions.
  await diagram(page).getByRole("button", {name: "Why did chgdir not run?"}).click()
  await expect(page.getByTestId("why-answer")).toContainText(/^chgdir (takes a ChgDir; none came|did run)/)
  await node(page, /^Led2: command/).click()
  await diagram(page).getByRole("button", {name: "Why no Led2?"}).click()
  await expect(page.getByTestId("why").getByRole("heading")).toHaveText("Why no Led2?")
  await expect(page.getByTestId("why-answer")).toContainText("cliff takes a Cliff; none came")
  await learner.keeps("diagram-questions")
  await learner.stops()
})

test("the diagram goes by keyboard, is a list for a screen reader, and becomes a file", async ({page}) => {
  const learner = new Learner(page)
  await learner.opens("randomWalk")
  await showsDiagram(page)
  await node(page, /^Cliff: robot event/).focus()
  await page.keyboard.press("ArrowRight")
  await expect(node(page, /^cliff: function/)).toBeFocused()
  await page.keyboard.press("Enter")
  await expect(page.locator(".source-host .hs-linked-line").first()).toContainText("cliff")
  const {violations} = await new AxeBuilder({page}).include(".region.diagram").analyze()
  expect(violations).toEqual([])
  const saved = page.waitForEvent("download")
  await diagram(page).getByRole("button", {name: "Save as SVG"}).click()
  expect((await saved).suggestedFilename()).toBe("randomWalk diagram.svg")
  const picture = page.waitForEvent("download")
  await diagram(page).getByRole("button", {name: "Save as PNG"}).click()
  expect((await picture).suggestedFilename()).toBe("randomWalk diagram.png")
  await diagram(page).getByRole("button", {name: "As a list"}).click()
  const list = diagram(page).getByRole("listitem")
  await expect(
    list.filter({hasText: "spin: function; runs on tick; reads Memory Mode, Seconds"}),
  ).toBeVisible()
  const inList = await new AxeBuilder({page}).include(".region.diagram").analyze()
  expect(inList.violations).toEqual([])
})

test("an edit of one function moves no other node", async ({page}) => {
  const learner = new Learner(page)
  await learner.opens("randomWalk")
  await showsDiagram(page)
  const places = () =>
    page.evaluate(() =>
      Object.fromEntries(
        [...document.querySelectorAll<SVGGElement>("svg.diagram [data-node]")].map(g => [
          g.dataset["node"],
          g.style.transform,
        ]),
      ),
    )
  const before = await atRest(page, places)
  for (const [was, becomes] of [
    ["Led2, Maybe", "Led1, Maybe"],
    ["Led2 Orange, Just", "Led1 Orange, Just"],
    ["Led2 Black, Nothing", "Led1 Black, Nothing"],
  ] as const) {
    await learner.findsInHaskell(was)
    await page.keyboard.type(becomes)
  }
  await expect(node(page, /^cliff: function; runs on Cliff; gives Led1/)).toBeVisible()
  expect(await atRest(page, places)).toEqual(before)
})

test("the files of the diagram show every text and node with its colours, without the page", async ({
  page,
  browser,
}, info) => {
  const learner = new Learner(page)
  await learner.opens("randomWalk")
  await showsDiagram(page)
  await learner.runs()
  await expect(node(page, /^Memory Mode: memory/).locator(".value")).toHaveText(/Go|Turn|Stop/)
  await page.getByRole("button", {name: "Pause", exact: true}).click()
  const files = {svg: info.outputPath("diagram.svg"), png: info.outputPath("diagram.png")}
  const saves = async (kind: "svg" | "png") => {
    const saved = page.waitForEvent("download")
    await diagram(page)
      .getByRole("button", {name: `Save as ${kind.toUpperCase()}`})
      .click()
    await (await saved).saveAs(files[kind])
  }
  // The chosen node: the keyboard's mark is no part of the file.
  let parts = await atRest(page, () => drawnParts(page))
  await expect(async () => {
    parts = await atRest(page, () => drawnParts(page))
    await saves("svg")
    await saves("png")
    expect(await drawnParts(page)).toEqual(parts)
  }).toPass()
  const points = await drawnPoints(page)
  expect(parts.length).toBeGreaterThan(60)
  expect(points.length).toBeGreaterThan(20)

  // What programs without CSS do not know is not in it.
  const file = readFileSync(files.svg, "utf8").replaceAll(/<style>.*?<\/style>/gs, "")
  expect(file).not.toMatch(/var\(|color\(|color-mix|class=|style=|\d(?:px)?\) rotate\([^)]*deg/)
  const alone = await (await browser.newContext({deviceScaleFactor: 2})).newPage()
  await alone.goto(`file://${files.svg}`)
  await alone.evaluate(() => document.fonts.ready.then(() => undefined))
  expect(await drawnParts(alone)).toEqual(parts)
  const seen = await pixelsOf(page, await alone.locator("svg").first().screenshot(), points)
  const saved = await pixelsOf(page, readFileSync(files.png), points)
  const expected = points.map(({what, colour}) => `${what}: ${colour}`)
  expect(seen).toEqual(expected)
  expect(saved).toEqual(expected)
  await alone.context().close()
})

test.describe("with reduced motion", () => {
  test.use({contextOptions: {reducedMotion: "reduce"}})

  test("nothing travels in the diagram, and firings are still seen in diagram and blocks", async ({page}) => {
    const learner = new Learner(page)
    await learner.opens("randomWalk")
    await showsDiagram(page)
    await page.evaluate(watchMotion)
    const seen = () => page.evaluate(() => (window as unknown as {seen: () => SeenMotion}).seen())
    await learner.runs()
    // What fires is lit: function, edges, and block.
    await expect.poll(seen).toMatchObject({
      functions: expect.arrayContaining(["spin"]),
      edges: true,
      blocks: true,
    })
    const lit = diagram(page).locator(".node.function.lit .outline").first()
    const dark = diagram(page).locator(".node.function:not(.lit) .outline").first()
    await expect(lit).toHaveCSS("stroke-width", "3px")
    await expect(dark).toHaveCSS("stroke-width", "2px")
    // A node goes, and when the diagram is tidied up others take other places at once.
    await learner.findsInHaskell("wheel, chgdir")
    await page.keyboard.type("chgdir")
    await expect(node(page, /^wheel: function/)).toHaveCount(0)
    await diagram(page).getByRole("button", {name: "Tidy up"}).click()
    await expect.poll(async () => (await seen()).moved).toBe(true)
    await atRest(page, seen)
    expect(await seen()).toMatchObject({between: [], animations: []})
    await learner.stops()
  })
})

interface SeenMotion {
  /// Functions, and whether edges and blocks, that were lit.
  readonly functions: readonly string[]
  readonly edges: boolean
  readonly blocks: boolean
  /// Whether a node went to another place; places between two of its places; animations that took time.
  readonly moved: boolean
  readonly between: readonly string[]
  readonly animations: readonly string[]
}

/// Runs in the page: looks at diagram and blocks in every frame.
function watchMotion(): void {
  const functions = new Set<string>()
  const animations = new Set<string>()
  const between = new Set<string>()
  const places = new Map<string, Set<string>>()
  let [edges, blocks, moved] = [false, false, false]
  const numbers = (transform: string) =>
    (transform.match(/-?[\d.]+/g) ?? [])
      .slice(-2)
      .map(one => Number(one).toFixed(1))
      .join(" ")
  const look = () => {
    for (const group of document.querySelectorAll<SVGGElement>("svg.diagram .node")) {
      const id = group.dataset["node"] ?? ""
      if (group.matches(".function.lit")) functions.add(group.querySelector(".name")?.textContent ?? "")
      const known = places.get(id) ?? new Set()
      places.set(id, known.add(numbers(group.style.transform)))
      if (known.size > 1) moved = true
      const at = numbers(getComputedStyle(group).transform)
      if (!known.has(at)) between.add(`${id}: ${at}`)
    }
    edges ||= document.querySelector("svg.diagram .edge.lit") !== null
    blocks ||= document.querySelector(".rosyFired") !== null
    for (const animation of document.getAnimations()) {
      const {effect} = animation
      const target = effect instanceof KeyframeEffect ? effect.target : null
      const time = Number(effect?.getComputedTiming().duration)
      if (time > 1 && target?.closest(".region.diagram, .region.blocks"))
        animations.add(`${target.getAttribute("class")}: ${time} ms`)
    }
    requestAnimationFrame(look)
  }
  requestAnimationFrame(look)
  const seen = () => ({
    functions: [...functions],
    edges,
    blocks,
    moved,
    between: [...between],
    animations: [...animations],
  })
  Object.assign(window, {seen})
}
