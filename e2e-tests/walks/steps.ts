/// Steps of a walk: what a hand does with mouse and keyboard at random places, and what that must leave of the text.

import {expect, type Page} from "@playwright/test"
import type {Dice} from "../../codegen/test/generate/random.ts"
import {drawn} from "../stories/at_rest.ts"
import {type Target, type TargetKind, targets} from "./targets.ts"
import {longText, snippets} from "./texts.ts"

/// What a step has done, in words with which it can be repeated by hand; and what holds of the text afterwards.
export interface Done {
  readonly step: string
  /// `insertion`: these letters came in at one place, and what was selected there went. `remarks`: no comment is gone. `same`: the text is as before.
  readonly holds?:
    | {readonly kind: "insertion"; readonly text: string}
    | {readonly kind: "remarks"}
    | {readonly kind: "same"}
}

export type StepKind = keyof typeof steps

/// A place in the room, where nothing is explained.
const aside = {x: 1200, y: 400}

const undone: Done = {step: "nothing"}

async function pick(page: Page, dice: Dice, kind: TargetKind): Promise<Target | undefined> {
  const found = await targets(page, kind)
  return found.length === 0 ? undefined : dice.pick(found)
}

/// Presses a key that ends what the last step may have left open: a field, a menu, a list.
export async function closes(page: Page): Promise<void> {
  await page.keyboard.press("Escape")
  await drawn(page)
}

async function drags(page: Page, from: Target, dice: Dice): Promise<string> {
  const hole = dice.once(3) ? undefined : await pick(page, dice, "hole")
  const over = dice.once(3) ? await pick(page, dice, "block") : undefined
  const to = over ?? hole ?? {x: 260 + dice.below(400), y: 120 + dice.below(700)}
  const {mouse} = page
  await mouse.move(from.x, from.y)
  await mouse.down()
  await mouse.move(from.x + 12, from.y)
  await drawn(page)
  await mouse.move(to.x + 40, to.y + 30)
  await mouse.move(to.x + 3, to.y + 1)
  await mouse.move(to.x, to.y)
  await drawn(page)
  await mouse.up()
  await drawn(page)
  const where = "words" in to ? `${to.block} “${to.words}”` : "a free place"
  return `from ${from.x},${from.y} to ${to.x},${to.y}: ${from.block} “${from.words}” to ${where}`
}

/// Writes into the field that a press opens.
async function writes(page: Page, at: Target, text: string): Promise<boolean> {
  await page.mouse.click(at.x, at.y)
  await drawn(page)
  const input = page.locator(".blocklyHtmlInput")
  if ((await input.count()) === 0) return false
  await input.fill(text)
  await drawn(page)
  // A change that would lose unfinished text is refused at its first letter, which closes the field.
  if ((await input.count()) > 0) await page.keyboard.press("Enter")
  return true
}

/// Presses a button of the page so many times, or as often as it can be pressed; the result is how often.
async function presses(page: Page, name: string, times: number): Promise<number> {
  const button = page.getByRole("button", {name, exact: true})
  // What is explained at the pointer may stand before the button.
  await page.mouse.move(aside.x, aside.y)
  for (let pressed = 0; pressed < times; pressed++) {
    if (await button.isDisabled()) return pressed
    await button.click()
    await drawn(page)
  }
  return times
}

/// Puts the cursor into the text.
async function enters(page: Page, dice: Dice): Promise<string | undefined> {
  const line = await pick(page, dice, "line")
  if (line === undefined) return undefined
  const x = line.x - 30 + dice.below(220)
  await page.mouse.click(x, line.y)
  await closes(page)
  // What is explained at the pointer may stand before the line.
  const focused = await page.getByTestId("haskell").evaluate(pane => pane.contains(document.activeElement))
  if (!focused) return undefined
  return `“${line.words}” at ${x}`
}

export const steps = {
  /// A block of the drawer.
  async drawer(page: Page, dice: Dice): Promise<Done> {
    const category = await pick(page, dice, "category")
    if (category === undefined) return undone
    await page.mouse.click(category.x, category.y)
    await drawn(page)
    const offered = await pick(page, dice, "offered")
    if (offered === undefined) return undone
    return {step: `drag out of the drawer ${category.words} ${await drags(page, offered, dice)}`}
  },
  async move(page: Page, dice: Dice): Promise<Done> {
    const block = await pick(page, dice, "block")
    return block === undefined ? undone : {step: `drag ${await drags(page, block, dice)}`}
  },
  async delete(page: Page, dice: Dice): Promise<Done> {
    const block = await pick(page, dice, "block")
    if (block === undefined) return undone
    await page.mouse.click(block.x, block.y)
    await closes(page)
    await page.keyboard.press("Delete")
    return {step: `delete ${block.block} “${block.words}”`}
  },
  async copy(page: Page, dice: Dice): Promise<Done> {
    const block = await pick(page, dice, "block")
    if (block === undefined) return undone
    await page.mouse.click(block.x, block.y)
    await closes(page)
    await page.keyboard.press("Control+d")
    return {step: `copy ${block.block} “${block.words}”`, holds: {kind: "remarks"}}
  },
  async entry(page: Page, dice: Dice): Promise<Done> {
    const field = await pick(page, dice, "entry")
    if (field === undefined) return undone
    const text = dice.pick(["7", "0.25", "-3", "1e3", "4711", "x", "", "wall"])
    const written = await writes(page, field, text)
    if (!written) return undone
    return {step: `write ${text} for “${field.words}” in ${field.block}`, holds: {kind: "remarks"}}
  },
  async menu(page: Page, dice: Dice): Promise<Done> {
    const field = await pick(page, dice, "menu")
    if (field === undefined) return undone
    await page.mouse.click(field.x, field.y)
    await drawn(page)
    const items = page.locator(".blocklyDropDownDiv .blocklyMenuItem")
    const count = await items.count()
    if (count === 0) return undone
    const words = await items.allTextContents()
    const chosen = dice.below(count)
    for (let down = 0; down <= chosen; down++) await page.keyboard.press("ArrowDown")
    await page.keyboard.press("Enter")
    return {
      step: `choose ${words[chosen]} or near it for “${field.words}” in ${field.block}`,
      holds: {kind: "remarks"},
    }
  },
  async name(page: Page, dice: Dice): Promise<Done> {
    const field = await pick(page, dice, "name")
    if (field === undefined) return undone
    const text = `n${dice.below(20)}`
    if (!(await writes(page, field, text))) return undone
    return {step: `name “${field.words}” in ${field.block} ${text}`, holds: {kind: "remarks"}}
  },
  async button(page: Page, dice: Dice): Promise<Done> {
    const button = await pick(page, dice, "button")
    if (button === undefined) return undone
    await page.mouse.click(button.x, button.y)
    return {step: `press “${button.words}” on ${button.block}`}
  },
  async rename(page: Page, dice: Dice): Promise<Done> {
    const at = await enters(page, dice)
    if (at === undefined) return undone
    await page.keyboard.press("F2")
    await drawn(page)
    const field = page.getByLabel(/^New name for /)
    if ((await field.count()) === 0) return undone
    const text = `r${dice.below(20)}`
    await field.fill(text)
    await page.keyboard.press("Enter")
    await drawn(page)
    await closes(page)
    return {step: `rename what is in ${at} to ${text}`, holds: {kind: "remarks"}}
  },
  async type(page: Page, dice: Dice): Promise<Done> {
    const at = await enters(page, dice)
    if (at === undefined) return undone
    const text = dice.pick(snippets)
    if (text.startsWith("\n")) await page.keyboard.press("End")
    await page.keyboard.insertText(text)
    return {step: `type ${JSON.stringify(text)} in ${at}`, holds: {kind: "insertion", text}}
  },
  async erase(page: Page, dice: Dice): Promise<Done> {
    const at = await enters(page, dice)
    if (at === undefined) return undone
    const times = 1 + dice.below(6)
    const key = dice.pick(["Backspace", "Delete", "Control+Backspace"])
    for (let time = 0; time < times; time++) await page.keyboard.press(key)
    return {step: `${times} times ${key} in ${at}`}
  },
  async undo(page: Page, dice: Dice): Promise<Done> {
    return {step: `${await presses(page, "Undo", 1 + dice.below(3))} times Undo`}
  },
  async redo(page: Page, dice: Dice): Promise<Done> {
    return {step: `${await presses(page, "Redo", 1 + dice.below(3))} times Redo`}
  },
  /// There and back again.
  async undoAndRedo(page: Page, dice: Dice): Promise<Done> {
    const times = await presses(page, "Undo", 1 + dice.below(10))
    await presses(page, "Redo", times)
    return {step: `${times} times Undo, and as often Redo`, holds: {kind: "same"}}
  },
  async paste(page: Page, dice: Dice): Promise<Done> {
    const at = await enters(page, dice)
    if (at === undefined) return undone
    await page.keyboard.press(dice.pick(["Control+End", "Control+Home", "End"]))
    const {name, text} = longText(dice)
    await pastes(page, text)
    return {step: `paste ${name} in ${at}`, holds: {kind: "insertion", text}}
  },
  async views(page: Page, dice: Dice): Promise<Done> {
    const shown: string[] = []
    for (const name of [dice.pick(["Blocks", "Haskell"]), "Blocks + Haskell"]) {
      await page.getByRole("button", {name, exact: true}).click()
      await drawn(page)
      shown.push(name)
    }
    return {step: `show ${shown.join(", then ")}`, holds: {kind: "same"}}
  },
} satisfies Record<string, (page: Page, dice: Dice) => Promise<Done>>

/// Replaces what is selected in the Haskell, which has the focus.
export async function pastes(page: Page, text: string): Promise<void> {
  await page.getByTestId("haskell").evaluate((pane, words) => {
    const clipboardData = new DataTransfer()
    clipboardData.setData("text/plain", words)
    const target = pane.matches(".cm-content") ? pane : (pane.querySelector(".cm-content") ?? pane)
    target.dispatchEvent(new ClipboardEvent("paste", {clipboardData, bubbles: true, cancelable: true}))
  }, text)
}

/// Reloads the page, and waits until its program is open: it may have no blocks.
export async function reloads(page: Page): Promise<void> {
  await page.reload()
  await expect(page.getByTestId("run")).toBeEnabled()
}
