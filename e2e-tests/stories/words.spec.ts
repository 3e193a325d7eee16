/// The page in other languages: nothing of it stays English, it can be read from right to left, and German is spoken.
///
/// In the pseudo-locale every word of the tables has accents (`editor/src/words/pseudo_locales.ts`): plain letters on the page
/// are a word that is in no table, or the program's and the robot's own.

import {expect, type Page} from "@playwright/test"
import {knownNames, toolbox} from "@rosy/codegen"
import {boxAtRest} from "./at_rest.ts"
import {Learner} from "./learner.ts"
import {test} from "./story.ts"

const words = (text: string): readonly string[] => text.match(/[A-Za-z]{3,}/g) ?? []

/// Words that stay as they are in every language: the program's and the robot's, what lessons, challenges,
/// examples and rooms call themselves, keys and units.
async function kept(page: Page): Promise<ReadonlySet<string>> {
  const names = knownNames().flatMap(known => words(`${known.name} ${known.type}`))
  const ready = words(JSON.stringify(toolbox("haskell")))
  const content = await page.evaluate(async () => {
    const get = async (path: string) => (await fetch(path)).text()
    const rooms: readonly string[] = await (await fetch("api/worlds")).json()
    const lists = ["api/examples", "api/lessons", "api/challenges"].map(get)
    const texts = [...lists, ...rooms.map(room => get(`api/worlds/${room}`))]
    return (await Promise.all(texts)).join(" ")
  })
  const program = await new Learner(page).haskellText()
  const others = words(
    "English Deutsch Português Brasil Español Français Alt Shift Control rad accelerateAndPlay",
  )
  return new Set([...names, ...ready, ...words(content), ...words(program), ...others])
}

/// What can be seen or is read aloud, with the place it is at.
function saidOn(page: Page): Promise<readonly string[]> {
  return page.evaluate(() => {
    const attributes = [
      "aria-label",
      "title",
      "placeholder",
      "alt",
      "aria-description",
      "aria-roledescription",
      "aria-valuetext",
    ]
    const shows = (element: Element) => element.checkVisibility({visibilityProperty: true})
    const own = (element: Element) => element.closest(".cm-content, code, script, style, noscript") !== null
    const found: string[] = []
    const walker = document.createTreeWalker(document.body, NodeFilter.SHOW_ELEMENT | NodeFilter.SHOW_TEXT)
    while (walker.nextNode()) {
      const node = walker.currentNode
      const element = node instanceof Element ? node : node.parentElement
      if (element === null || own(element) || !shows(element)) continue
      if (node instanceof Element) {
        for (const name of attributes) found.push(`${name}: ${node.getAttribute(name) ?? ""}`)
      } else found.push(`text: ${node.textContent ?? ""}`)
    }
    return found
  })
}

async function speaksNoEnglish(page: Page, where: string, kept: ReadonlySet<string>): Promise<void> {
  const english = (await saidOn(page)).filter(said =>
    words(said.slice(said.indexOf(":") + 1)).some(word => !kept.has(word)),
  )
  expect([...new Set(english)], where).toEqual([])
}

test("every word of the page is in a table of words", async ({page}) => {
  await page.goto("/?example=accelerateAndPlay&lang=en-XA")
  await expect(new Learner(page).haskell()).toContainText("simulate")
  await expect(page.locator(".blocklyBlockCanvas .blocklyDraggable").first()).toBeVisible()
  const own = await kept(page)
  const look = (where: string) => speaksNoEnglish(page, where, own)
  await look("the page")

  for (const level of ["tasks", "reactions", "haskell"]) {
    await page.locator(".rosyLevel select").selectOption(level)
    for (const category of await page.locator(".blocklyToolboxCategory:not(.rosySearchRow)").all()) {
      await category.click()
      await expect(page.locator(".blocklyFlyout")).toBeVisible()
      await look(`the toolbox at ${level}: ${await category.textContent()}`)
    }
  }
  await page.locator(".rosySearch").fill("?!")
  await look("a search that finds nothing")
  await page.keyboard.press("Escape")
  await page.keyboard.press("Escape")

  for (const block of ["accelerate", "0.5", "simulate"]) {
    const at = page.locator(".blocklyBlockCanvas .blocklyFieldText").getByText(block, {exact: true}).first()
    if ((await at.count()) === 0) continue
    await at.click({button: "right"})
    await expect(page.locator(".blocklyContextMenu")).toBeVisible()
    await look(`the menu of ${block}`)
    await page.keyboard.press("Escape")
  }
  for (const menu of await page.locator(".menu > button").all()) {
    await menu.click()
    await expect(menu).toHaveAttribute("aria-expanded", "true")
    await look(`the menu ${await menu.getAttribute("title")}`)
    await page.keyboard.press("Escape")
    await expect(menu).toHaveAttribute("aria-expanded", "false")
  }

  await page.keyboard.press("F1")
  await expect(page.locator("dialog[open] kbd").first()).toBeVisible()
  await look("the keys")
  await page.keyboard.press("Escape")

  for (const [place, list] of ["the lessons", "the challenges", "the examples"].entries()) {
    await page.locator(".topbar button").nth(place).click()
    await expect(page.locator("dialog[open] li").first()).toBeVisible()
    await look(list)
    await page.keyboard.press("Escape")
  }
  await page.locator(".room-choice").click()
  await expect(page.locator("dialog[open] li").first()).toBeVisible()
  await look("the rooms")
  await page.locator("dialog[open] .pair button").first().click()
  for (const tool of await page.locator(".workshop .tools button").all()) {
    await tool.click()
    await expect(tool).toHaveAttribute("aria-pressed", "true")
    await look(`the world editor: ${await tool.textContent()}`)
  }
  await page.locator(".workshop .things button").first().click()
  await look("the start of the robot")
  await page.locator(".workshop-bar button.plain").last().click()

  await new Learner(page).runsUntil("speed", v => v > 0.3)
  for (const tab of await page.getByRole("tab").all()) {
    await tab.click()
    await expect(tab).toHaveAttribute("aria-selected", "true")
    await look(`${await tab.textContent()} while it runs`)
  }
  await page.getByTestId("run").click()
  await expect(page.locator("dialog[open]")).toHaveCount(0)
})

test("real robots, and all that the page has to say by itself, are in a table of words", async ({page}) => {
  const robot = {name: "Kitchen", holder: null, yours: true}
  const held = {
    op: "robot",
    name: "Kitchen",
    link: "connected",
    why: "",
    stopped: false,
    max_speed: 0.5,
    max_turn: 2,
  }
  // What a service with robots, or in trouble, would say besides.
  let say: (message: object) => void = () => {}
  await page.routeWebSocket(/\/api\//, socket => {
    socket.connectToServer()
    say = message => socket.send(JSON.stringify(message))
  })
  // A link that leads nowhere.
  await page.goto("/?example=nowhere&lang=en-XA")
  await expect(new Learner(page).haskell()).toContainText("simulate")
  await expect(page.getByTestId("notice")).toBeVisible()
  const own = new Set([...(await kept(page)), "Kitchen", "nowhere"])
  const look = (where: string) => speaksNoEnglish(page, where, own)
  await look("an example that is not there")
  await page.getByTestId("notice").getByRole("button").click()

  for (const state of ["restarting", "starting"]) {
    say({op: "worker", state})
    await expect(page.getByTestId("link")).toHaveCount(1)
    await look(`the worker, ${state}`)
  }
  say({op: "worker", state: "ready"})
  await expect(page.getByTestId("link")).toHaveCount(0)

  say({op: "robots", locked: true, robots: []})
  await page.getByTestId("robot-choice").click()
  await look("robots behind a code")
  say({op: "robots", locked: false, robots: [{...robot, yours: false}]})
  await expect(page.getByTestId("robot Kitchen")).toBeVisible()
  await look("robots to choose from")
  await page.keyboard.press("Escape")
  say({op: "robots", locked: false, robots: [robot]})
  for (const now of [{link: "connecting"}, {}, {stopped: true}, {link: "lost"}]) {
    say({...held, ...now})
    await expect(page.getByTestId("robotbar")).toBeVisible()
    await look(`the robot, ${JSON.stringify(now)}`)
  }
  say(held)
  for (const rules of [{on: true}, {on: true, run: 0, since: 1.5}, {on: false}]) {
    say({op: "safety", ...rules})
    await expect(page.getByTestId("safety-switch")).toHaveAttribute("aria-pressed", String(rules.on))
    await look(`safety rules, ${JSON.stringify(rules)}`)
  }
  say({...held, link: "gone"})
  await expect(page.getByTestId("notice")).toBeVisible()
  await look("the robot is gone")
})

test("from right to left a program is built by hand and runs", async ({page}) => {
  const learner = new Learner(page)
  await page.goto("/?example=accelerate&lang=ar-XB")
  await expect(learner.haskell()).toContainText("simulate")
  await page.locator(".menu > button").last().click()
  await page.getByText(/New.*program/).click()
  const blocks = page.locator(".blocklySvg .blocklyBlockCanvas > .blocklyDraggable")
  await expect(blocks).toHaveCount(1)

  // Blocks begin at their right edge, the toolbox is on the right, and Haskell still reads from the left.
  const [main, toolbox] = [await boxAtRest(blocks), await boxAtRest(page.locator(".blocklyToolbox"))]
  expect(toolbox.x).toBeGreaterThan(main.x)
  await expect(learner.haskell()).toHaveCSS("direction", "ltr")

  await page.locator(".blocklyToolboxCategory", {hasText: /Tell/}).click()
  const ready = page.locator(".blocklyFlyout .blocklyBlockCanvas > .blocklyDraggable").first()
  await drag(page, edge(await boxAtRest(ready)), {x: main.x + main.width - 8, y: main.y + main.height + 60})
  await expect(blocks).toHaveCount(2)
  await expect(learner.haskell()).toContainText("main = simulate move")

  await learner.runsUntil("speed", v => v > 0.3)
  await learner.keeps("right-to-left")
  await page.getByTestId("run").click()
})

interface Spot {
  readonly x: number
  readonly y: number
}

/// Where a block that is written from right to left begins.
const edge = ({x, y, width}: Spot & {readonly width: number}): Spot => ({x: x + width - 6, y: y + 12})

async function drag(page: Page, from: Spot, to: Spot): Promise<void> {
  await page.mouse.move(from.x, from.y)
  await page.mouse.down()
  await page.mouse.move((from.x + to.x) / 2, (from.y + to.y) / 2, {steps: 4})
  await page.mouse.move(to.x, to.y, {steps: 4})
  await page.mouse.up()
}

test("German is chosen in the menu, spoken after that, and remembered", async ({page}) => {
  await page.goto("/?example=accelerateAndPlay")
  await expect(new Learner(page).haskell()).toContainText("simulate")
  await page.locator(".menu > button").last().click()
  await page.getByRole("button", {name: "Deutsch"}).click()
  await expect(page.getByTestId("run")).toHaveText("Start")
  await expect(page.locator(".blocklyToolboxCategory", {hasText: "Sag dem Roboter"})).toBeVisible()
  await expect(page.locator("html")).toHaveAttribute("lang", "de")
  await page.goto("/?example=move")
  await expect(page.getByTestId("run")).toHaveText("Start")
  await page.getByTestId("run").click()
  await expect(page.getByRole("status").filter({hasText: "Läuft"})).toBeVisible()
  await page.getByTestId("run").click()
})

test.describe("a reader of German", () => {
  test.use({locale: "de-DE"})

  test("is shown the guide in German where it is translated, and can read it in English", async ({page}) => {
    await page.goto("/guide/why.html#not-run")
    await expect(page).toHaveURL(/\/guide\/de\/why\.html#not-run$/)
    await expect(page.getByRole("heading", {name: "Warum läuft eine Funktion nicht?"})).toBeInViewport()
    await page.getByRole("link", {name: "This page in English"}).click()
    await expect(page.getByRole("heading", {name: "Why does a function not run?"})).toBeVisible()
    await page.getByRole("link", {name: "Rosy language reference", exact: false}).first().click()
    await expect(page.getByText("gibt es nur auf Englisch")).toBeVisible()
  })

  test("can hold an animation of the guide, which stands from the start for readers with reduced motion", async ({
    page,
  }) => {
    const shown = () =>
      page.locator("picture.animation img").evaluate(image => (image as HTMLImageElement).currentSrc)
    await page.goto("/guide/de/tutorial-drive.html")
    await expect.poll(shown).toMatch(/circle-drive-(?!still)[^/]*svg$/)
    await page.getByRole("button", {name: "Animation anhalten"}).click()
    await expect.poll(shown).toMatch(/circle-drive-still/)
    await page.getByRole("button", {name: "Animation abspielen"}).click()
    await expect.poll(shown).not.toMatch(/circle-drive-still/)
    await page.emulateMedia({reducedMotion: "reduce"})
    await page.reload()
    await expect(page.getByRole("button", {name: "Animation abspielen"})).toBeVisible()
    await expect.poll(shown).toMatch(/circle-drive-still/)
  })
})
