/// Comforts of editing, each by mouse, by keys and by finger: buttons on blocks, duplicate, copy and paste, fold, comment, take a
/// stray home, undo and redo, zoom.

import type {Page} from "playwright-core"
import {afterAll, beforeAll, describe, expect, inject, test} from "vitest"
import {Finger, grip, openStage, type Spot, type Stage, settled, tree} from "./browser.ts"

let stage: Stage
beforeAll(async () => {
  stage = await openStage(inject("stage"))
})
afterAll(() => stage.close())

/// How a thing is asked for: by its place on the page for a hand, or by the focus for the keys.
interface Hand {
  readonly page: Page
  press(spot: Spot): Promise<void>
  /// Opens the menu of the block with this id, or of the workspace.
  menu(of: string | Spot): Promise<void>
}

const free: Spot = {x: 760, y: 640}

const hands: Record<string, () => Promise<Hand>> = {
  async mouse() {
    const page = await stage.open("small")
    return {
      page,
      press: ({x, y}) => page.mouse.click(x, y),
      async menu(of) {
        const {x, y} = typeof of === "string" ? await grip(page, of) : of
        await page.mouse.click(x, y, {button: "right"})
      },
    }
  },
  async keys() {
    const page = await stage.open("small")
    return {
      page,
      press: () => page.keyboard.press("Enter"),
      async menu(of) {
        if (typeof of === "string") await page.evaluate(id => window.blocks.select(id), of)
        else {
          await page.evaluate(() => window.blocks.focus())
          await page.keyboard.press("w")
        }
        await page.keyboard.press("Shift+F10")
      },
    }
  },
  async finger() {
    const page = await stage.openForFingers("small", 1100)
    const finger = await Finger.on(page)
    return {
      page,
      async press(at) {
        await finger.down(at)
        await finger.up()
      },
      async menu(of) {
        await finger.down(typeof of === "string" ? await grip(page, of) : of)
        // A finger that stays opens the menu.
        await page.locator(".blocklyMenuItem").first().waitFor()
        await finger.up()
      },
    }
  },
}

const undo = async (page: Page) => {
  await page.evaluate(() => window.blocks.undo())
  await settled(page)
}
const redo = async (page: Page) => {
  await page.evaluate(() => window.blocks.redo())
  await settled(page)
}
const saved = (page: Page) => page.evaluate(() => JSON.stringify(window.blocks.save()))
const kinds = async (page: Page) => JSON.stringify(await tree(page))
const count = (text: string, what: string) => text.split(what).length - 1

/// Chooses an entry of the menu that is open.
async function choose(hand: Hand, by: string, entry: string): Promise<void> {
  const {page} = hand
  const item = page.locator(".blocklyMenuItem", {hasText: entry})
  await item.waitFor()
  if (by === "keys") {
    const entries = await page.locator(".blocklyMenuItem:not(.blocklyMenuItemDisabled)").allTextContents()
    const lit = page.locator(".blocklyMenuItemHighlight")
    for (const _ of entries) {
      if ((await lit.count()) > 0 && (await lit.textContent())?.includes(entry)) break
      await page.keyboard.press("ArrowDown")
    }
    await page.keyboard.press("Enter")
  } else {
    const box = (await item.boundingBox())!
    await hand.press({x: box.x + box.width / 2, y: box.y + box.height / 2})
  }
  await settled(page)
}

for (const [by, begin] of Object.entries(hands)) {
  describe(`by ${by}`, () => {
    let hand: Hand
    let page: Page
    beforeAll(async () => {
      hand = await begin()
      page = hand.page
    })
    const fresh = async () => {
      await page.evaluate(() => window.reset())
      await settled(page)
      return saved(page)
    }

    /// Does something, and sees that one undo takes all of it back and one redo brings it again.
    const andBack = async (act: () => Promise<void>, is: (now: string) => void) => {
      const before = await fresh()
      await act()
      const after = await saved(page)
      is(after)
      await undo(page)
      expect(JSON.parse(await saved(page))).toEqual(JSON.parse(before))
      await redo(page)
      expect(JSON.parse(await saved(page))).toEqual(JSON.parse(after))
    }

    test("+ and − add a place and take it away", async () => {
      const places = () =>
        page.evaluate(
          () =>
            window.Blockly.getMainWorkspace()
              .getBlockById("main")
              ?.inputList.filter(input => input.connection).length,
        )
      const button = async (sign: string) => {
        const box = (await page.locator(".rosyPress", {hasText: sign}).first().boundingBox())!
        await page.evaluate(text => {
          const fields = window.Blockly.getMainWorkspace()
            .getBlockById("main")!
            .inputList.flatMap(input => input.fieldRow)
          const found = fields.find(field => field.getText() === text)
          window.Blockly.getFocusManager().focusNode(found!)
        }, sign)
        await hand.press({x: box.x + box.width / 2, y: box.y + box.height / 2})
        await settled(page)
      }
      const before = await fresh()
      await button("+")
      expect(await places()).toBe(3)
      await button("−")
      expect(await places()).toBe(2)
      await undo(page)
      expect(await places()).toBe(3)
      await undo(page)
      expect(JSON.parse(await saved(page))).toEqual(JSON.parse(before))
    })

    test("duplicate", () =>
      andBack(
        async () => {
          await hand.menu("just")
          await choose(hand, by, "Duplicate")
        },
        after => expect(count(after, '"just"')).toBeGreaterThan(2),
      ))

    test("copy and paste, where the menu was opened", async () => {
      await fresh()
      await hand.menu("just")
      await choose(hand, by, "Copy")
      const before = await kinds(page)
      await hand.menu(free)
      await choose(hand, by, "Paste")
      expect(count(await kinds(page), "just")).toBe(count(before, "just") + 1)
      await undo(page)
      expect(await kinds(page)).toBe(before)
      // Another tab would have it too.
      expect(await page.evaluate(() => localStorage.getItem("rosy.copied"))).toContain("just")
    })

    test("fold and unfold", () =>
      andBack(
        async () => {
          await hand.menu("accelerate")
          await choose(hand, by, "Collapse Block")
        },
        after => expect(after).toContain('"collapsed":true'),
      ))

    test("a comment, open to be written at once", () =>
      andBack(
        async () => {
          await hand.menu("accelerate")
          await choose(hand, by, "Add Comment")
          const field = page.locator(".blocklyBubble textarea, .blocklyTextarea").first()
          await field.waitFor()
          await page.waitForFunction(() => document.activeElement instanceof HTMLTextAreaElement)
          await page.keyboard.type("faster")
          await page.keyboard.press("Escape")
          await settled(page)
        },
        after => expect(after).toContain("faster"),
      ))

    test("a stray comes home, and what was placed stays where it is", async () => {
      await fresh()
      await page.evaluate(() => {
        const led = window.Blockly.getMainWorkspace().getBlockById("led") as import("blockly/core").BlockSvg
        led.moveBy(9000, 9000)
      })
      await settled(page)
      const places = () =>
        page.evaluate(() =>
          window.blocks
            .save()
            .blocks.blocks.map(({id, x, y}) => [id, Math.round(x ?? 0), Math.round(y ?? 0)]),
        )
      const before = await places()
      await hand.menu(free)
      await choose(hand, by, "Bring stray blocks home")
      const after = await places()
      expect(after.filter(([id]) => id !== "led")).toEqual(before.filter(([id]) => id !== "led"))
      expect(after.find(([id]) => id === "led")).not.toEqual(before.find(([id]) => id === "led"))
      await undo(page)
      expect(await places()).toEqual(before)
    })

    test("all blocks are shown", async () => {
      await fresh()
      const scale = () =>
        page.evaluate(() => (window.Blockly.getMainWorkspace() as import("blockly/core").WorkspaceSvg).scale)
      await page.evaluate(() => {
        const workspace = window.Blockly.getMainWorkspace() as import("blockly/core").WorkspaceSvg
        workspace.setScale(2.4)
      })
      if (by === "keys") {
        await page.evaluate(() => window.blocks.focus())
        await page.keyboard.press("0")
      } else {
        const box = (await page.getByRole("button", {name: "Show all blocks"}).boundingBox())!
        await hand.press({x: box.x + 12, y: box.y + 12})
      }
      await settled(page)
      expect(await scale()).toBeLessThan(2.4)
      const out = await page.evaluate(() => {
        const pane = document.querySelector(".blocklySvg")!.getBoundingClientRect()
        return [...document.querySelectorAll(".blocklySvg .blocklyBlockCanvas > .blocklyDraggable")].filter(
          block => {
            const box = block.getBoundingClientRect()
            return (
              box.left < pane.left || box.right > pane.right || box.top < pane.top || box.bottom > pane.bottom
            )
          },
        ).length
      })
      expect(out).toBe(0)
    })
  })
}

test("two fingers look closer", async () => {
  const page = await stage.openForFingers("small", 1100)
  const scale = () =>
    page.evaluate(() => (window.Blockly.getMainWorkspace() as import("blockly/core").WorkspaceSvg).scale)
  const before = await scale()
  const session = await page.context().newCDPSession(page)
  const touch = (type: "touchStart" | "touchMove" | "touchEnd", apart: number) =>
    session.send("Input.dispatchTouchEvent", {
      type,
      touchPoints:
        type === "touchEnd" ? [] : [-1, 1].map((side, id) => ({x: 700 + side * apart, y: 600, id})),
    })
  await touch("touchStart", 40)
  for (const apart of [50, 70, 90, 110]) await touch("touchMove", apart)
  await touch("touchEnd", 0)
  expect(await scale()).toBeGreaterThan(before)
  await page.context().close()
})
