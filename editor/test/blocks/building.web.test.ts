/// The paper's first programs, built from an empty workspace with the real language.

import {existsSync, readdirSync, readFileSync} from "node:fs"
import {afterAll, beforeAll, describe, expect, inject, test} from "vitest"
import {drag, openStage, type Stage, settled, socket} from "./browser.ts"
import {Keys} from "./keyboard_user.ts"

let stage: Stage
beforeAll(async () => {
  stage = await openStage(inject("stage"))
})
afterAll(() => stage.close())

/// The example as it stands in `examples/`, without its comments, which are not built from blocks.
function example(name: string): string {
  const text = readFileSync(new URL(`../../../examples/${name}/Main.hs`, import.meta.url), "utf8")
  return text
    .split("\n")
    .filter(line => !line.startsWith("--"))
    .join("\n")
    .trim()
}

async function accelerate(keys: Keys): Promise<void> {
  await keys.take("when it has a velocity")
  await keys.goTo("what to send")
  await keys.take("velocity drive and turn")
  await keys.goTo(/number: 0\.5$/)
  // The empty socket that is left is chosen.
  await keys.press("Delete")
  await keys.take("plus")
  await keys.fill("vl")
  await keys.fill("0.5")
  await keys.goTo(/number: 0$/)
  await keys.press("Delete")
  await keys.take("va")
}

describe("by mouse", () => {
  test("move: a ready function dragged from the toolbox", async () => {
    const keys = await Keys.onEmpty(stage)
    const {page} = keys
    await page.locator(".blocklyToolboxCategory", {hasText: "Tell the robot"}).click()
    const offered = page.locator(".blocklyFlyout .blocklyDraggable", {hasText: "move"}).first()
    const box = (await offered.boundingBox())!
    await drag(page, {x: box.x + 12, y: box.y + box.height - 6}, {x: 500, y: 320})
    await settled(page)
    expect((await keys.haskell()).trim()).toBe(example("move"))
  })

  test("move by a click: a ready function lies below the others and runs; a place that is pressed later is offered what fits", async () => {
    const keys = await Keys.onEmpty(stage)
    const {page} = keys
    await page.locator(".blocklyToolboxCategory", {hasText: "Tell the robot"}).click()
    const offered = (words: string) =>
      page.locator(".blocklyFlyout .blocklyDraggable", {hasText: words}).first()
    const box = (await offered("move").boundingBox())!
    await page.mouse.click(box.x + 12, box.y + box.height - 6)
    await settled(page)
    expect((await keys.haskell()).trim()).toBe(example("move"))
    await page.evaluate(() => window.Blockly.getMainWorkspace().getBlocksByType("name")[0]?.dispose())
    // What was searched before was for another place.
    await page.getByRole("searchbox").fill("bumper")
    await offered("bumper").waitFor()
    await page.mouse.click(1060, 700)
    await settled(page)
    const gap = await socket(page, "main", "R0")
    await page.mouse.click(gap.x + 8, gap.y + 6)
    await settled(page)
    await page.getByText("Fits here").waitFor()
    expect(await page.getByRole("searchbox").inputValue()).toBe("")
    await offered("move").click({position: {x: 8, y: 8}})
    await settled(page)
    expect((await keys.haskell()).trim()).toBe(example("move"))
  })
})

test("every example comes out of the blocks as it went in, with nothing left out, raw or wrong, and read again it replaces no block", async () => {
  const page = await stage.open("empty")
  const folder = new URL("../../../examples/", import.meta.url)
  const names = readdirSync(folder).filter(name => existsSync(new URL(`${name}/program.rosy`, folder)))
  expect(names.length).toBeGreaterThanOrEqual(4)
  for (const name of names) {
    const read = (file: string) => readFileSync(new URL(`${name}/${file}`, folder), "utf8")
    const shown = await page.evaluate(text => {
      const outcome = window.codegen.parseProject(text)
      if (!outcome.ok) return outcome.message
      const read = () => structuredClone(window.codegen.openProject(outcome.project).workspace)
      const {left} = window.blocks.load(read())
      const blocks = window.Blockly.getMainWorkspace().getAllBlocks(false)
      const kinds = blocks.map(block => block.type)
      window.blocks.load(read())
      return {
        replaced: blocks.filter(block => block.disposed).map(block => block.type),
        text: window.codegen.toHaskell(window.blocks.save()).text,
        left,
        raw: kinds.filter(kind => kind.startsWith("raw")),
        problems: window.blocks.inference().problems,
      }
    }, read("program.rosy"))
    expect(shown, name).toEqual({text: read("Main.hs"), left: [], replaced: [], raw: [], problems: []})
  }
})

test("a level filters and orders what the toolbox offers", async () => {
  const page = await stage.open("example=move")
  const offered = async () =>
    (await page.locator(".blocklyToolboxCategoryLabel").allTextContents()).filter(name =>
      ["When it senses", "Tasks"].includes(name),
    )
  expect((await offered())[0]).toBe("When it senses")
  await page.locator(".rosyLevel select").selectOption("tasks")
  await settled(page)
  expect((await offered())[0]).toBe("Tasks")
  expect(await page.locator(".rosyLevel select").inputValue()).toBe("tasks")
})

describe("by keyboard alone", () => {
  test("F offers what fits in the next empty place, and Enter puts the first at once", async () => {
    const keys = await Keys.onEmpty(stage)
    // Keys can be quicker than the drawer.
    await keys.page.keyboard.press("f")
    await keys.page.keyboard.press("Enter")
    await settled(keys.page)
    expect(await keys.haskell()).toContain("simulate driveOn")
    // Nothing is empty any more: a key that does nothing says why.
    await keys.press("f")
    await keys.page.locator(".blocklyToast", {hasText: "No empty place is left"}).waitFor()
  })

  test("Shift+Enter puts what is found and searches for the next empty place", async () => {
    const keys = await Keys.onEmpty(stage)
    await keys.press("f")
    for (const words of ["repeat", "drive 50 cm", "turn 90 degrees"]) {
      await keys.page.keyboard.insertText(words)
      await settled(keys.page)
      await keys.press("Shift+Enter")
    }
    const text = await keys.haskell()
    for (const line of ["replicateM_ 4 $ do", " drive 50", " turn 90"]) expect(text).toContain(line)
    // A step is followed by another.
    expect(await keys.page.evaluate(() => document.activeElement?.className)).toContain("rosySearch")
  })

  test("a case, an input or a run that is removed takes its blocks along, and undo brings them back", async () => {
    for (const [taken, stack, button, gone] of [
      ["ready-made: complain", "complain", /remove the last case/, "complain (Bumper _ Released) = Nothing"],
      ["ready-made: remember a number", "countBumps", /^one input less/, "(Memory n)"],
      ["ready-made: complain", "simulate", /^run one less/, ", complain)"],
    ] as const) {
      const keys = await Keys.onEmpty(stage)
      await keys.take("ready-made: get faster")
      await keys.take(taken)
      const before = await keys.haskell()
      expect(before).toContain(gone)
      const stacks = await keys.page.evaluate(
        () => window.Blockly.getMainWorkspace().getTopBlocks(false).length,
      )
      await keys.choose(stack)
      await keys.goTo(button)
      await keys.press("Enter")
      expect(await keys.haskell()).not.toContain(gone)
      expect(
        await keys.page.evaluate(() => window.Blockly.getMainWorkspace().getTopBlocks(false).length),
      ).toBe(stacks)
      await keys.page.evaluate(() => window.blocks.undo())
      await settled(keys.page)
      expect(await keys.haskell()).toBe(before)
    }
  })

  test("R makes one more place in simulate, V goes to numbers, and a number is typed where it belongs", async () => {
    const keys = await Keys.onEmpty(stage)
    await keys.press("r")
    await keys.page.keyboard.insertText("drive straight on")
    await settled(keys.page)
    await keys.press("Enter", "v")
    const first = await keys.heard()
    await keys.press("v")
    const second = await keys.heard()
    expect(second).not.toBe(first)
    await keys.press("Shift+V")
    expect(await keys.heard()).toBe(first)
    await keys.page.keyboard.type("0.75")
    await keys.press("Enter")
    expect(await keys.haskell()).toContain("driveOn = Velocity 0.75 0")
    // The empty place that is left takes a number as well.
    await keys.goTo(/number: 0$/)
    await keys.press("Delete")
    await keys.page.keyboard.type("0.25")
    await settled(keys.page)
    await keys.press("Enter")
    expect(await keys.haskell()).toContain("driveOn = Velocity 0.75 0.25")
    await keys.press("r")
    await keys.page.keyboard.insertText("back off")
    await settled(keys.page)
    await keys.press("Enter")
    expect(await keys.haskell()).toContain("simulate (priority 1 backOff driveOn)")
  })

  test("move", async () => {
    const keys = await Keys.onEmpty(stage)
    await keys.take("send always")
    expect((await keys.haskell()).trim()).toBe(example("move"))
  })

  test("accelerate", async () => {
    const keys = await Keys.onEmpty(stage)
    await accelerate(keys)
    expect((await keys.haskell()).trim()).toBe(example("accelerate"))
  })

  test("accelerateAndPlay", async () => {
    const keys = await Keys.onEmpty(stage)
    await accelerate(keys)
    await keys.take("when the bumper is pressed")
    await keys.goTo("Edit name of the definition: onBump")
    await keys.write("play")
    await keys.choose("play")
    await keys.goTo("just: value")
    await keys.take("play a sound")
    await keys.choose("play")
    await keys.goTo("remove the last case")
    await keys.press("Enter")
    await keys.choose("play")
    await keys.goTo("one more case")
    await keys.press("Enter")
    await keys.choose("play")
    await keys.goTo("input 1 of case 2")
    await keys.take("bumper event")
    await keys.goTo("status: pressed")
    await keys.press("Enter", "ArrowDown", "Enter")
    await keys.choose("play")
    await keys.fill("nothing no value")
    expect((await keys.haskell()).trim()).toBe(example("accelerateAndPlay"))
  })

  test("a task of steps, with steps inside a step", async () => {
    const keys = await Keys.onEmpty(stage)
    await keys.take("a task of several steps")
    await keys.press("ArrowDown", "ArrowDown")
    await keys.take("repeat a number of times")
    await keys.press("ArrowDown")
    await keys.take("wait some seconds")
    await keys.take("say")
    expect((await keys.haskell()).split("\n\n")[0]).toBe(
      [
        "myTask :: Task ()",
        "myTask = do",
        '  say "go"',
        "  replicateM_ 4 $ do",
        "    wait 1",
        '    say "done"',
      ].join("\n"),
    )
  })
})
