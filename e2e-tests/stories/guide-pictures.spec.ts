/// Pictures of the guide: each is taken from the running page and compared with the file in `docs/pictures`. `./rosy guide-pictures` takes all of them anew.
///
/// A picture shows a program of the guide at one time of its run with a fixed seed, so it depends on nothing but the product and the browser. Another version of Chromium
/// draws letters and lines a little differently; pictures are compared with the version that made them only (`made-with.json`).

import {readFileSync, writeFileSync} from "node:fs"
import {fileURLToPath} from "node:url"
import {type Browser, expect, type Page} from "@playwright/test"
import {wholeChromium} from "../../editor/test/chromium.ts"
import {classPictures} from "./class_pictures.ts"
import {withPalette} from "./palette_png.ts"
import {test} from "./story.ts"

interface Picture {
  readonly name: string
  /// The page of the guide, and which of its programs is opened.
  readonly page: string
  readonly program: number
  /// The moment of the run that is shown, in seconds.
  readonly time: number
  /// The program ends by itself.
  readonly ends?: boolean
  /// What else is opened.
  readonly open?: (page: Page) => Promise<void>
}

const pictures: readonly Picture[] = [
  {name: "first-drive", page: "tutorial-drive", program: 0, time: 5},
  {name: "stopped", page: "tutorial-functions", program: 1, time: 6},
  {name: "backing-off", page: "tutorial-events", program: 2, time: 12},
  {
    name: "diagram",
    page: "tutorial-memory",
    program: 1,
    time: 4,
    async open(page) {
      await page.getByRole("button", {name: "Diagram", exact: true}).click()
      await expect(page.locator("svg.diagram .node")).not.toHaveCount(0)
    },
  },
  {name: "modes", page: "tutorial-own-event", program: 1, time: 18},
  {name: "task", page: "how-to-tasks", program: 0, time: 8.4, ends: true},
  {name: "time-line", page: "tutorial-memory", program: 0, time: 9},
]

const folder = fileURLToPath(new URL("../../docs/pictures/", import.meta.url))
const madeWith = `${folder}made-with.json`

/// 1,500 pixels for the 750 that a page of the guide has. In the whole browser: its headless shell draws letters a little differently.
test.use({
  viewport: {width: 1200, height: 720},
  deviceScaleFactor: 1.25,
  launchOptions: async ({launchOptions}, use) => use({...launchOptions, executablePath: wholeChromium}),
})

const isUpdate = (info: {readonly config: {readonly updateSnapshots: string}}) =>
  info.config.updateSnapshots === "all"

/// Pictures that one story takes.
interface Series {
  readonly name: string
  take(page: Page, browser: Browser, shoot: (page: Page, name: string) => Promise<void>): Promise<void>
}

const ofPrograms = pictures.map(
  (picture): Series => ({
    name: picture.name,
    async take(page, _, shoot) {
      await page.emulateMedia({colorScheme: "light", reducedMotion: "reduce"})
      await opensProgram(page, picture)
      await runsUntil(page, picture)
      await picture.open?.(page)
      await page.mouse.move(0, 0)
      await shoot(page, picture.name)
    },
  }),
)
const series: readonly Series[] = [
  ...ofPrograms,
  {name: "class", take: (_, browser, shoot) => classPictures(browser, shoot)},
]

for (const {name, take} of series)
  test(`the picture ${name} of the guide is what the page shows`, async ({page, browser}, info) => {
    const {chromium} = JSON.parse(readFileSync(madeWith, "utf8")) as {readonly chromium: string}
    test.skip(
      !isUpdate(info) && chromium !== browser.version(),
      `The pictures were made with Chromium ${chromium}.`,
    )
    await take(page, browser, async (shown, file) => {
      await expect(shown).toHaveScreenshot(`${file}.png`, {scale: "device", maxDiffPixelRatio: 0.03})
      if (isUpdate(info)) {
        const path = `${folder}${file}.png`
        writeFileSync(path, withPalette(readFileSync(path)))
        writeFileSync(madeWith, `${JSON.stringify({chromium: browser.version()})}\n`)
      }
    })
  })

/// By the link below the program in the guide, with the seed in the address.
async function opensProgram(page: Page, {page: name, program}: Picture): Promise<void> {
  await page.goto(`/guide/${name}.html`)
  const link = page.locator(".program").nth(program).getByRole("link", {name: "Open in Rosy"})
  const address = (await link.getAttribute("href")) ?? ""
  await page.goto(address.replace("../", "/?seed=1"))
  await expect(page.getByTestId("haskell")).toContainText("simulate")
  await expect(page.locator(".blocklyBlockCanvas > .blocklyDraggable").first()).toBeVisible()
  await expect(page.getByTestId("run")).toHaveText("Run")
}

/// Runs a little longer, stops, and looks back at the moment.
async function runsUntil(page: Page, {time, ends = false}: Picture): Promise<void> {
  const line = page.getByRole("slider", {name: "Look back in the run"})
  const last = async () => Number(await line.getAttribute("max"))
  await page.getByRole("combobox", {name: "Speed"}).selectOption("8")
  await page.getByTestId("run").click()
  await expect.poll(last).toBeGreaterThan(time)
  if (!ends) await page.getByTestId("run").filter({hasText: "Stop"}).click()
  await expect(page.getByTestId("run")).toHaveText(/Run/)
  await line.fill(String(time))
}
