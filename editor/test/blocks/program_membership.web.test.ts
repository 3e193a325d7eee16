/// What is taken from the toolbox belongs to the program: it joins `simulate` by itself, and comes out again with one action.

import {afterAll, beforeAll, describe, expect, inject, test} from "vitest"
import {drag, openStage, type Spot, type Stage, settled, socket} from "./browser.ts"
import {Keys} from "./keyboard_user.ts"

let stage: Stage
beforeAll(async () => {
  stage = await openStage(inject("stage"))
})
afterAll(() => stage.close())

/// What `simulate` runs, as one line.
const runs = async (keys: Keys): Promise<string> => {
  const line = (await keys.haskell())
    .replace(/\s+/g, " ")
    .replace(/(?<=\() | (?=[),])/g, "")
    .trim()
  return /main = simulate (.*)$/.exec(line)?.[1] ?? ""
}

/// Where a block that is searched for can be taken.
async function found(keys: Keys, words: string): Promise<Spot> {
  await keys.page.locator(".rosySearch").click()
  await keys.page.keyboard.insertText(words)
  await settled(keys.page)
  const offered = keys.page.locator(".blocklyFlyout .blocklyDraggable > .blocklyPath").first()
  const box = (await offered.boundingBox())!
  return {x: box.x + 9, y: box.y + 12}
}

const free: Spot = {x: 520, y: 420}

/// What is taken from the toolbox, one after the other, and what runs then.
const taken = [
  // What reacts goes before what would override it, whichever comes first.
  [["ready-made: drive straight on", "ready-made: back off"], "(priority 1 backOff driveOn)"],
  [["ready-made: back off", "ready-made: drive straight on"], "(priority 1 backOff driveOn)"],
  [
    ["ready-made: drive straight on", "ready-made: back off", "ready-made: stop at an edge"],
    "(priority 3600 stopAtEdge (priority 1 backOff driveOn))",
  ],
  // What stands still goes first for good, and a task before what drives at every tick.
  [["ready-made: stop at an edge", "ready-made: drive straight on"], "(priority 3600 stopAtEdge driveOn)"],
  [["ready-made: wander", "ready-made: stop at an edge"], "(priority 3600 stopAtEdge wander)"],
  [["ready-made: drive straight on", "ready-made: follow a wall"], "(priority 3600 followWall driveOn)"],
  [["ready-made: drive straight on", "ready-made: go to a place"], "(priority 3600 goToPlace driveOn)"],
  [["ready-made: flash", "ready-made: drive straight on"], "(lightShow, driveOn)"],
  [["ready-made: drive straight on", "ready-made: complain"], "(driveOn, complain)"],
  [["ready-made: drive straight on", "ready-made: get faster"], "(driveOn, faster)"],
  [["ready-made: drive straight on", "drive 50", "turn 90"], "(driveOn, do drive 50 turn 90)"],
  [["drive 50", "turn 90"], "$ do drive 50 turn 90"],
  [["forever", "drive 50"], "(forever (drive 50))"],
  [["when the bumper is pressed"], "onBump"],
  [["send always"], "move"],
  // A value has no place of its own, and a plain function is a helper of others.
  [["velocity: drive and turn"], "_"],
  [["constant"], "_"],
  [["function with an input"], "_"],
] as const

describe("joins simulate", () => {
  test.each(taken)("%j, dropped anywhere", async (names, expected) => {
    const keys = await Keys.onEmpty(stage)
    for (const name of names) {
      await drag(keys.page, await found(keys, name), free)
      await settled(keys.page)
    }
    expect(await runs(keys)).toBe(expected)
    if (expected === "_") return
    // The block and what joins it are one step.
    await keys.page.evaluate(() => window.blocks.undo())
    await settled(keys.page)
    expect(await runs(keys)).not.toBe(expected)
  })

  test("by Enter in the search, and the next empty place is that of the new block", async () => {
    const keys = await Keys.onEmpty(stage)
    await keys.press("w", "t")
    await keys.page.keyboard.insertText("when the bumper is pressed")
    await settled(keys.page)
    await keys.press("Enter")
    expect(await runs(keys)).toBe("onBump")
    await keys.press("e")
    expect(await keys.heard()).toMatch(/^just: value/)
  })

  test("when its first row lies over a place, wherever it is held", async () => {
    const keys = await Keys.onEmpty(stage)
    await keys.page.evaluate(() => {
      window.blocks.load({
        blocks: {
          languageVersion: 0,
          blocks: [
            {id: "main", type: "main", x: 60, y: 20},
            {
              id: "go",
              type: "define",
              x: 60,
              y: 300,
              extraState: {name: "goFarAndFurther", arity: 0, equations: [{}], signature: "Velocity"},
              inputs: {E0_0: {block: {type: "construct", extraState: {con: "Velocity", args: 2}}}},
            },
          ],
        },
      } as unknown as Parameters<typeof window.blocks.load>[0])
    })
    await settled(keys.page)
    const place = await socket(keys.page, "main", "R0")
    const box = (await keys.page.locator('[data-id="go"] > .blocklyPath').boundingBox())!
    // Held at its foot, so that pointer and corner are both away from the place.
    const held = {x: box.x + 6, y: box.y + box.height - 8}
    const corner = {x: place.x - 40, y: place.y - 4}
    await drag(keys.page, held, {x: corner.x + held.x - box.x, y: corner.y + held.y - box.y})
    await settled(keys.page)
    expect(await runs(keys)).toBe("goFarAndFurther")
  })
})

describe("comes out of simulate", () => {
  test("with Shift+R, at the definition or at its name, and goes in again", async () => {
    const keys = await Keys.onEmpty(stage)
    await keys.take("ready-made: drive straight on")
    await keys.press("w")
    await keys.take("ready-made: back off")
    expect(await runs(keys)).toBe("(priority 1 backOff driveOn)")
    await keys.choose("driveOn")
    await keys.press("Shift+R")
    expect(await runs(keys)).toBe("backOff")
    await keys.press("Shift+R")
    expect(await runs(keys)).toBe("(priority 1 backOff driveOn)")
    await keys.choose("simulate")
    await keys.goTo(/^what goes first/)
    await keys.press("Shift+R")
    expect(await runs(keys)).toBe("driveOn")
    expect(await keys.haskell()).toContain("backOff ::")
  })

  test("with its menu", async () => {
    const keys = await Keys.onEmpty(stage)
    await keys.take("ready-made: drive straight on")
    const body = keys.page.locator(".blocklyBlockCanvas > .blocklyDraggable").last()
    const box = (await body.boundingBox())!
    for (const [entry, expected] of [
      ["Take it out of the program", "_"],
      ["Run it in the program", "driveOn"],
    ] as const) {
      await keys.page.mouse.click(box.x + 8, box.y + 10, {button: "right"})
      await keys.page.getByRole("menuitem", {name: entry}).click()
      await settled(keys.page)
      expect(await runs(keys)).toBe(expected)
    }
  })
})
