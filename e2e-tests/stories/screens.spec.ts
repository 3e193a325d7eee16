/// Screens of the first hour in four sizes, light and dark: first visit, new program, My programs, Share and print. A picture of each is in
/// `test-results`.

import {expect, type Page} from "@playwright/test"
import {wholeChromium} from "../../editor/test/chromium.ts"
import {languages} from "./languages.ts"
import {Learner} from "./learner.ts"
import {covered, crowded, cutBlocks, excessWidth, faults, places, wrappedLines} from "./page_faults.ts"
import {test} from "./story.ts"

/// The headless shell draws letters a little wider than the browser that people have.
test.use({
  launchOptions: async ({launchOptions}, use) => use({...launchOptions, executablePath: wholeChromium}),
})

const sizes = [
  {width: 1440, height: 900},
  {width: 1024, height: 768},
  {width: 820, height: 1180},
  {width: 390, height: 844},
] as const

const more = (page: Page) => page.getByRole("button", {name: "More", exact: true})

/// Each screen is opened from the one before; the answer closes it again.
const screens: Readonly<Record<string, (page: Page) => Promise<() => Promise<void>>>> = {
  async "first visit"(page) {
    await page.goto("/")
    await expect(page.locator(".blocklyBlockCanvas > .blocklyDraggable").first()).toBeVisible()
    await expect(page.getByTestId("run")).toHaveText("Run")
    return async () => {}
  },
  async "new program"(page) {
    await more(page).click()
    await page.getByText("New program").click()
    await expect(page.locator(".blocklyBlockCanvas > .blocklyDraggable")).toHaveCount(1)
    return async () => {}
  },
  async "my programs"(page) {
    // An example that was changed is a program of one's own.
    const learner = new Learner(page)
    await learner.opens("accelerateAndPlay")
    await page.getByRole("textbox", {name: "Name of the program"}).fill("walk")
    await page.getByRole("textbox", {name: "Name of the program"}).press("Enter")
    const button = page.getByRole("button", {name: "My programs"})
    // A narrow bar has no place for the button; the menu has it, too.
    if (!(await button.isVisible())) await more(page).click()
    await button.click()
    await expect(page.locator("dialog[open] .program-card .block-picture path").first()).toBeVisible()
    return () => page.keyboard.press("Escape")
  },
  async share(page) {
    await more(page).click()
    await page.getByText("Share or print…").click()
    await expect(page.getByRole("img", {name: "QR code"})).toBeVisible()
    return () => page.keyboard.press("Escape")
  },
  async print(page) {
    await page.evaluate(() => window.dispatchEvent(new Event("beforeprint")))
    await page.emulateMedia({media: "print"})
    await expect(page.locator(".print-sheet pre")).toContainText("simulate")
    return async () => {
      await page.evaluate(() => window.dispatchEvent(new Event("afterprint")))
      await page.emulateMedia({media: "screen"})
    }
  },
}

/// What axe looks at, where it is not the whole page: what lies behind a dialog was looked at before.
const parts: {readonly [screen: string]: string} = {
  "my programs": "dialog[open]",
  share: "dialog[open]",
  print: ".print-sheet",
}

/// Waits until the page has its colours and nothing fades any more.
async function atRest(page: Page, colorScheme: string): Promise<void> {
  await expect(page.locator("html")).toHaveAttribute("data-theme", colorScheme)
  await page.evaluate(async () => {
    const finite = document.getAnimations().filter(one => one.effect?.getTiming().iterations !== Infinity)
    await Promise.allSettled(finite.map(one => one.finished))
  })
}

for (const size of sizes)
  test(`the screens of the first hour at ${size.width} by ${size.height}`, async ({page}, info) => {
    await page.setViewportSize(size)
    await page.emulateMedia({reducedMotion: "reduce"})
    for (const [name, open] of Object.entries(screens)) {
      const close = await open(page)
      for (const colorScheme of ["light", "dark"] as const) {
        await page.emulateMedia({colorScheme})
        await atRest(page, colorScheme)
        await page.screenshot({path: info.outputPath(`${name}-${colorScheme}.png`)})
        const where = `${name}, ${colorScheme}`
        expect(await faults(page, parts[name]), where).toEqual([])
        expect(await covered(page), where).toEqual([])
        expect(await excessWidth(page), where).toBe(0)
      }
      await close()
    }
  })

test("the examples of the first level fit into a window of 1440 by 900, and no line of their Haskell is wrapped", async ({
  page,
}) => {
  const learner = new Learner(page)
  await page.goto("/")
  await expect(page.locator(".blocklyBlockCanvas > .blocklyDraggable").first()).toBeVisible()
  await expect.poll(() => cutBlocks(page), "first visit").toEqual([])
  const all: readonly {readonly name: string; readonly level: string}[] = await (
    await page.request.get("/api/examples")
  ).json()
  const first = all.filter(example => example.level === "start")
  expect(first.length).toBeGreaterThan(3)
  for (const {name} of first) {
    await learner.opens(name)
    await expect.poll(() => cutBlocks(page), name).toEqual([])
    // The font of the Haskell may come later than its text.
    await expect.poll(() => wrappedLines(page), name).toEqual([])
  }
})

test("on a small laptop nothing is cut off or covered in every language, and a run moves nothing", async ({
  browser,
}, info) => {
  for (const language of languages) {
    // A program that is opened again has the place and size of before.
    const context = await browser.newContext({
      viewport: {width: 1366, height: 768},
      reducedMotion: "reduce",
      baseURL: info.project.use.baseURL!,
    })
    const page = await context.newPage()
    const looks = async (when: string) => {
      await page.screenshot({path: info.outputPath(`${language}-${when}.png`)})
      await expect.poll(() => cutBlocks(page), `${language} ${when}`).toEqual([])
      await expect.poll(() => crowded(page), `${language} ${when}`).toEqual([])
    }
    await page.goto(`/?lang=${language}&example=accelerateAndPlay`)
    await expect(page.locator(".blocklyBlockCanvas > .blocklyDraggable").first()).toBeVisible()
    await expect(page.getByTestId("run")).toBeEnabled()
    await looks("ready")
    const before = await places(page)
    await page.getByTestId("run").click()
    await expect(page.getByTestId("console")).toContainText("ErrorSound")
    await looks("running")
    expect(await places(page), language).toEqual(before)
    await page.getByTestId("run").click()
    await expect(page.locator(".state.stopped")).toBeVisible()
    await looks("stopped")
    expect(await places(page), language).toEqual(before)
    await context.close()
  }
})
