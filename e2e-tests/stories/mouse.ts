/// Building by mouse: every block is dragged, every socket is found by eye. The keyboard only types words.

import {expect, type Locator, type Page} from "@playwright/test"
import {boxAtRest, drawn} from "./at_rest.ts"
import type {Hands, Of} from "./hands.ts"

interface Spot {
  readonly x: number
  readonly y: number
}

/// An empty socket.
interface Gap extends Spot {
  readonly block: string | null | undefined
  readonly pattern: boolean
}

/// Pixels. Where new blocks are let go: right of the toolbox, with room below.
const freeGap = 34
const workbench = {top: 90, bottom: 420}
/// Pixels from the left edge of a block that a hand takes it at.
const grip = 9
/// Pixels that a place which is pressed keeps from the right edge of the blocks' region.
const margin = 120
/// Pixels between the left edge of a socket and of the line that lights up around it.
const nearby = 12

export class Mouse implements Hands {
  private readonly page: Page
  private root: string | undefined
  /// The last block that was stacked, and the last that was put.
  private stacked: string | undefined
  private last: string | undefined

  constructor(page: Page) {
    this.page = page
  }

  async begins(): Promise<void> {
    await this.page.getByRole("button", {name: "More", exact: true}).click()
    await this.page.getByText("New program").click()
    await this.page.getByRole("button", {name: "Blocks", exact: true}).click()
    await expect(this.page.locator(".blocklySvg .blocklyBlockCanvas > .blocklyDraggable")).toHaveCount(1)
    const smaller = this.page.getByRole("button", {name: "Zoom out"})
    await smaller.click()
    await smaller.click()
    await drawn(this.page)
  }

  async starts(found: string): Promise<void> {
    let lowest = await this.lowest()
    if (lowest.y > workbench.bottom) {
      await this.page.mouse.move(lowest.x + 400, lowest.y - 10)
      await this.page.mouse.wheel(0, lowest.y - workbench.top)
      await drawn(this.page)
      lowest = await this.lowest()
    }
    const before = await this.tops()
    await this.drags(await this.finds(found), {x: lowest.x + grip, y: lowest.y + freeGap + 12})
    const [made] = (await this.tops()).filter(id => !before.includes(id))
    if (made === undefined) throw new Error(`expected ${found} to stand on the workspace`)
    this.root = made
    this.stacked = this.last = undefined
  }

  async takesUp(called: string): Promise<void> {
    const id = await this.page
      .locator(`.blocklySvg .blocklyBlockCanvas .blocklyDraggable:has(> [aria-roledescription="${called}"])`)
      .last()
      .getAttribute("data-id")
    this.root = id ?? undefined
    const top = (await boxAtRest(this.block())).y
    if (top > workbench.top && top < workbench.bottom) return
    await this.page.mouse.move(900, 300)
    await this.page.mouse.wheel(0, top - workbench.top - 40)
    await drawn(this.page)
  }

  async puts(...found: readonly string[]): Promise<void> {
    for (const words of found) {
      const binder = this.block().locator(".rosyBinder", {hasText: new RegExp(`^\\s*${escaped(words)}\\s*$`)})
      await this.scrollsTo((await this.gap()).x)
      const gap = await this.gap()
      if (!gap.pattern && (await binder.count()) > 0) {
        const box = await boxAtRest(binder.first())
        await this.drags({x: box.x + box.width / 2, y: box.y + box.height / 2}, gap, {gap, grip: 24})
      } else {
        await this.page.mouse.click(gap.x + 4, gap.y)
        const from = await this.finds(words)
        const to = await this.gap()
        await this.drags(from, to, {gap: to, grip})
      }
      this.last = await this.chosen()
      const into = await this.block("last").evaluate(block => block.parentElement?.getAttribute("data-id"))
      if (into !== gap.block) throw new Error(`expected ${words} to snap into its socket`)
    }
  }

  async stacks(found: string, under?: string): Promise<void> {
    const from = await this.finds(found)
    const to = await this.page.evaluate(
      ([root, before, words]) => {
        const within = `.blocklySvg .blocklyBlockCanvas [data-id="${words === undefined ? before : root}"]`
        if (words === undefined) {
          const box = document.querySelector(`${within} > .blocklyPath`)!.getBoundingClientRect()
          return {x: box.left, y: box.bottom}
        }
        // The mouth of a stack is below its words.
        const labels = [...document.querySelectorAll(`${within} .blocklyLabelField`)]
        const [at] = labels
          .filter(label => label.textContent?.replace(/\s+/g, " ").trim() === words)
          .slice(-1)
          .map(label => [label, label.parentElement!].map(part => part.getBoundingClientRect()))
        if (at === undefined) throw new Error(`expected an empty stack under ${words}`)
        return {x: at[1]!.left + 18, y: at[0]!.bottom + 10}
      },
      [this.root, this.stacked, under] as const,
    )
    await this.drags(from, {x: to.x + grip, y: to.y + 12})
    this.stacked = this.last = await this.chosen()
  }

  async throws(label: RegExp, of?: Of): Promise<void> {
    const target = this.labelled(label, of)
    await this.scrollsTo((await boxAtRest(target)).x)
    const box = await boxAtRest(target)
    const at = {x: box.x + Math.min(10, box.width / 2), y: box.y + Math.min(12, box.height / 2)}
    await this.page.mouse.click(at.x, at.y, {button: "right"})
    await this.page.locator(".blocklyContextMenu .blocklyMenuItem", {hasText: /^Delete/}).click()
    await drawn(this.page)
  }

  async writes(label: RegExp, text: string, of?: Of): Promise<void> {
    await this.labelled(label, of).click()
    const input = this.page.locator(".blocklyHtmlInput")
    await input.fill(text)
    await input.press("Enter")
    await drawn(this.page)
  }

  async chooses(label: RegExp, option: string, of?: Of): Promise<void> {
    await this.labelled(label, of).click()
    await this.page.locator(".blocklyDropDownDiv .blocklyMenuItem", {hasText: option}).first().click()
    await drawn(this.page)
  }

  async presses(label: RegExp, times = 1, of?: Of): Promise<void> {
    for (let time = 0; time < times; time++) {
      await this.labelled(label, of).click()
      await drawn(this.page)
    }
  }

  async asks(entry: string, of?: Of): Promise<void> {
    const box = await boxAtRest(this.block(of).locator("> .blocklyPath").first())
    const at = {x: box.x + grip, y: box.y + Math.min(box.height / 2, 14)}
    await this.page.mouse.click(at.x, at.y, {button: "right"})
    await this.page.locator(".blocklyContextMenu .blocklyMenuItem", {hasText: entry}).first().click()
    await drawn(this.page)
  }

  async remarks(text: string): Promise<void> {
    await this.asks("Add Comment")
    await this.page.locator(".blocklyBubble textarea").last().fill(text)
    await this.block().locator("> .blocklyCommentIcon").click()
    await drawn(this.page)
  }

  private block(of: Of = "whole"): Locator {
    const id = of === "last" ? this.last : this.root
    return this.page.locator(`.blocklySvg .blocklyBlockCanvas [data-id="${id}"]`)
  }

  private labelled(label: RegExp, of?: Of): Locator {
    return this.block(of).getByLabel(label).last()
  }

  /// The empty sockets of the block in hand, as one reads.
  private gaps(): Promise<Gap[]> {
    return this.page.evaluate(root => {
      const found = [
        ...document.querySelectorAll<SVGPathElement>(
          `.blocklySvg .blocklyBlockCanvas [data-id="${root}"] .blocklyOutlinePath`,
        ),
      ]
      const spots = found.map(path => {
        const box = path.getBoundingClientRect()
        const block = path.closest(".blocklyDraggable")?.getAttribute("data-id")
        // What must be filled is drawn dashed; a pattern may stay empty.
        const pattern = !path.classList.contains("rosyHole")
        return {x: box.left, y: box.top + box.height / 2, block, pattern}
      })
      // Sockets of one row have nearly one middle.
      return spots.sort((a, b) => (Math.abs(a.y - b.y) > 9 ? a.y - b.y : a.x - b.x))
    }, this.root)
  }

  /// Scrolls to the right until a place (x in CSS pixels of the page) that is outside of the blocks' region is well inside.
  private async scrollsTo(x: number): Promise<void> {
    const region = await boxAtRest(this.page.locator(".blocklySvg").first())
    const beyond = x + margin - (region.x + region.width)
    if (beyond <= 0) return
    await this.page.mouse.move(region.x + region.width / 2, 300)
    await this.page.mouse.wheel(beyond, 0)
    await drawn(this.page)
  }

  private async gap(): Promise<Gap> {
    const [first] = await this.gaps()
    if (first === undefined) throw new Error("expected an empty socket, found none")
    return first
  }

  /// Types into the search and answers where the first block found can be taken.
  private async finds(words: string): Promise<Spot> {
    await this.page.locator(".rosySearch").click()
    await this.page.keyboard.insertText(words)
    await drawn(this.page)
    const box = await boxAtRest(this.page.locator(".blocklyFlyout .blocklyDraggable > .blocklyPath").first())
    return {x: box.x + grip, y: box.y + Math.min(box.height / 2, 12)}
  }

  /// `into`: the socket that the block is for, and how far right of its left edge the hand lets go. A learner lets go when
  /// that socket lights up, and looks again where it is when it does not: blocks grow when something has come in.
  private async drags(
    from: Spot,
    to: Spot,
    into?: {readonly gap: Gap; readonly grip: number},
  ): Promise<void> {
    const {mouse} = this.page
    await mouse.move(from.x, from.y)
    await mouse.down()
    await mouse.move(from.x + 12, from.y)
    await drawn(this.page)
    if (into === undefined) {
      await mouse.move(to.x + 3, to.y + 1)
      await mouse.move(to.x, to.y)
      await drawn(this.page)
    } else {
      await expect(async () => {
        const gap = await this.gap()
        // From inside: Blockly holds on to the place that came near first, and the outer socket begins a little to the left.
        await mouse.move(gap.x + into.grip + 60, gap.y + 40)
        await mouse.move(gap.x + into.grip + 3, gap.y + 1)
        await mouse.move(gap.x + into.grip, gap.y)
        await drawn(this.page)
        const lit = await this.lit()
        expect({block: gap.block, near: Math.abs(lit.x - gap.x) < nearby}).toEqual({
          block: lit.block,
          near: true,
        })
      }).toPass({intervals: [0, 50, 200]})
    }
    await mouse.up()
    await drawn(this.page)
  }

  /// The socket that is lit up for what is being dragged.
  private lit(): Promise<{readonly x: number; readonly block: string | null | undefined}> {
    return this.page.evaluate(() => {
      const found = document.querySelector(
        ".blocklySvg .blocklyBlockCanvas .blocklyHighlightedConnectionPathVisible",
      )
      const block = found?.closest(".blocklyDraggable")?.getAttribute("data-id")
      return {x: found?.getBoundingClientRect().left ?? Number.NEGATIVE_INFINITY, block}
    })
  }

  private tops(): Promise<string[]> {
    return this.page
      .locator(".blocklySvg .blocklyBlockCanvas > .blocklyDraggable")
      .evaluateAll(blocks => blocks.map(block => block.getAttribute("data-id") ?? ""))
  }

  private lowest(): Promise<Spot> {
    return this.page.locator(".blocklySvg .blocklyBlockCanvas > .blocklyDraggable").evaluateAll(blocks => {
      const boxes = blocks.map(block => block.querySelector(".blocklyPath")!.getBoundingClientRect())
      return {
        x: Math.min(...boxes.map(box => box.left)),
        y: Math.max(...boxes.map(box => box.bottom)),
      }
    })
  }

  private chosen(): Promise<string> {
    return this.page
      .locator(".blocklySvg .blocklyBlockCanvas .blocklySelected")
      .last()
      .evaluate(path => path.closest(".blocklyDraggable")?.getAttribute("data-id") ?? "")
  }
}

function escaped(words: string): string {
  return words.replace(/[.*+?^${}()|[\]\\]/g, "\\$&")
}
