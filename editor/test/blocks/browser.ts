/// The block view in the system's Chromium, for tests that need hands: a served page and a few gestures.

import {
  type Browser,
  type BrowserContext,
  type BrowserContextOptions,
  type CDPSession,
  chromium,
  type Page,
} from "playwright-core"
import {whileFingerMoves} from "../long_press.ts"
import type {StageAddress} from "./browser_setup.ts"

export interface Stage {
  /// A page with the block view as it is at first; `query` as `dev/blocks.ts` reads it. The same query gets the same
  /// page within a test file, put back to its beginning: opening a page costs more than most stories.
  open(query?: string): Promise<Page>
  /// A page that no other story has.
  openOwn(query?: string): Promise<Page>
  /// A page on a phone or a tablet, of the width given.
  openForFingers(query: string, width: number): Promise<Page>
  close(): Promise<void>
}

/// The connection to the shared browser, for all test files of this process.
const shared = new Map<string, Promise<Browser>>()

function sharedBrowser(endpoint: string): Promise<Browser> {
  const known = shared.get(endpoint)
  if (known !== undefined) return known
  const opened = chromium.connect(endpoint, {timeout: 0})
  shared.set(endpoint, opened)
  return opened
}

/// A test file's own view of the shared page server and browser: `openStage(inject("stage"))`.
export async function openStage({address, endpoint}: StageAddress): Promise<Stage> {
  const browser = sharedBrowser(endpoint)
  const pages = new Map<string, Page>()
  const own: BrowserContext[] = []
  const openWith = async (query: string, options: BrowserContextOptions) => {
    const context = await (await browser).newContext({
      viewport: {width: 1100, height: 800},
      reducedMotion: "reduce",
      ...options,
    })
    context.setDefaultTimeout(0)
    own.push(context)
    const page = await context.newPage()
    page.on("pageerror", error => {
      throw error
    })
    await page.goto(`${address}dev/blocks.html?${query}`)
    // Not `window.blocks`: that is the element with this id until the view is there.
    await page.waitForFunction("window.reset !== undefined && document.fonts.status === 'loaded'")
    return page
  }
  return {
    openOwn: (query = "") => openWith(query, {}),
    openForFingers: (query, width) =>
      openWith(query, {viewport: {width, height: 800}, hasTouch: true, isMobile: true}),
    async open(query = "") {
      const known = pages.get(query)
      if (known === undefined) {
        const page = await openWith(query, {})
        pages.set(query, page)
        return page
      }
      await known.mouse.move(1, 799)
      await known.evaluate(() => window.reset())
      await settled(known)
      return known
    },
    async close() {
      await Promise.all(own.map(context => context.close()))
    },
  }
}

export interface Spot {
  readonly x: number
  readonly y: number
}

/// A point on the words of a block, near its left edge.
export function grip(page: Page, id: string): Promise<Spot> {
  return page.evaluate(block => {
    const svg = window.Blockly.getMainWorkspace().getBlockById(block) as import("blockly/core").BlockSvg
    const box = svg.pathObject.svgPath.getBoundingClientRect()
    return {x: box.left + 9, y: box.top + Math.min(14, box.height / 2)}
  }, id)
}

/// The middle of an empty socket.
export function socket(page: Page, id: string, input: string): Promise<Spot> {
  return page.evaluate(
    ([block, name]) => {
      const svg = window.Blockly.getMainWorkspace().getBlockById(block!) as import("blockly/core").BlockSvg
      const connection = svg.getInput(name!)!.connection as import("blockly/core").RenderedConnection
      const at = window.Blockly.utils.svgMath.wsToScreenCoordinates(
        svg.workspace,
        new window.Blockly.utils.Coordinate(connection.x, connection.y),
      )
      return {x: at.x, y: at.y}
    },
    [id, input],
  )
}

/// Drags from one spot to another, in steps as a hand does, and lets go unless told to hold.
export async function drag(page: Page, from: Spot, to: Spot, hold = false): Promise<void> {
  await page.mouse.move(from.x, from.y)
  await page.mouse.down()
  await page.mouse.move(from.x + 8, from.y + 8, {steps: 2})
  // A hand is slower than a frame.
  await page.evaluate(() => new Promise(requestAnimationFrame))
  await page.mouse.move(to.x, to.y, {steps: 8})
  if (!hold) await page.mouse.up()
}

/// One finger on the glass.
export class Finger {
  private readonly page: Page
  private readonly session: CDPSession

  private constructor(page: Page, session: CDPSession) {
    this.page = page
    this.session = session
  }

  static async on(page: Page): Promise<Finger> {
    return new Finger(page, await page.context().newCDPSession(page))
  }

  async down(at: Spot): Promise<void> {
    await this.session.send("Input.dispatchTouchEvent", {type: "touchStart", touchPoints: [at]})
  }

  async move(to: Spot): Promise<void> {
    await this.session.send("Input.dispatchTouchEvent", {type: "touchMove", touchPoints: [to]})
  }

  async up(): Promise<void> {
    await this.session.send("Input.dispatchTouchEvent", {type: "touchEnd", touchPoints: []})
  }

  /// Takes something and carries it there, without a rest: a finger that rests on a block opens its menu.
  async carry(from: Spot, to: Spot): Promise<void> {
    await whileFingerMoves(this.page, async () => {
      await this.down(from)
      for (let step = 1; step <= fingerSteps; step++) {
        const part = step / fingerSteps
        await this.move({x: from.x + (to.x - from.x) * part, y: from.y + (to.y - from.y) * part})
        await this.page.evaluate(() => new Promise(requestAnimationFrame))
      }
    })
  }

  async drag(from: Spot, to: Spot): Promise<void> {
    await this.carry(from, to)
    await this.up()
  }
}

const fingerSteps = 8

/// Waits until Blockly has drawn, told its events, and the view has answered.
export async function settled(page: Page): Promise<void> {
  await page.evaluate(async () => {
    await window.Blockly.renderManagement.finishQueuedRenders()
    await new Promise(done => setTimeout(done, 0))
    await new Promise(done => requestAnimationFrame(() => setTimeout(done, 0)))
  })
}

/// Waits until a screen reader has been told these words. Blockly tells a moment later, and several things at once.
export async function told(page: Page, words: string): Promise<void> {
  await page.locator("[aria-live]").filter({hasText: words}).first().waitFor({state: "attached"})
}

/// The blocks as nested lists of kinds, without ids and places: what a test is usually about.
export function tree(page: Page): Promise<unknown> {
  return page.evaluate(() => {
    type Saved = import("@rosy/codegen").SavedBlock
    const bare = (block: Saved): unknown => ({
      [block.type]: Object.fromEntries([
        ...Object.entries(block.inputs ?? {}).map(([name, input]) => [
          name,
          input.block ? bare(input.block) : null,
        ]),
        ...(block.next?.block === undefined ? [] : [["next", bare(block.next.block)]]),
      ]),
    })
    return window.blocks.save().blocks.blocks.map(bare)
  })
}
