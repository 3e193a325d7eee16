/// Text and blocks are two views of one program: what is written in one appears in the other, and nothing is lost on the way.

import {readFileSync, writeFileSync} from "node:fs"
import {expect, type Page} from "@playwright/test"
import {isNightly} from "../../codegen/test/extent.ts"
import {boxAtRest, drawn} from "./at_rest.ts"
import {Finger} from "./finger.ts"
import {Learner} from "./learner.ts"
import {test} from "./story.ts"

const source = (example: string) =>
  readFileSync(new URL(`../../examples/${example}/Main.hs`, import.meta.url), "utf8")

// The longer one has a thousand keys more.
const typed = [
  {example: "forwardBackward", defined: ["bump", "forwardBackward"]},
  ...(isNightly ? [{example: "drawSquare", defined: ["drawSquare", "move", "turn", "runTurn", "gone"]}] : []),
]
for (const {example, defined} of typed) {
  test(`${example}, typed key by key, becomes blocks and drives`, async ({page}) => {
    test.slow()
    const learner = new Learner(page)
    await learner.opens("move")
    await learner.emptiesHaskell()
    await learner.types(source(example))
    await expect.poll(() => learner.haskellText()).toBe(source(example).trimEnd())
    for (const name of defined) await expect(learner.definition(name)).toBeVisible()
    await expect(learner.wrongBlocks()).toHaveCount(0)
    await learner.keeps(`${example}-typed`)
    await learner.runsUntil("x", x => x > 1.7)
    await learner.stops()
  })
}

test("a line ends where Enter is pressed, also when something is offered for a word that is there already", async ({
  page,
}) => {
  const learner = new Learner(page)
  await learner.opens("accelerateAndPlay")
  await learner.entersHaskell()
  await page.keyboard.press("Control+End")
  const offered = page.getByRole("listbox").getByRole("option")
  await page.keyboard.type("\nall = map")
  await expect(offered.first()).toContainText(/^map\b/)
  // A list that has just come up does not listen yet. What a key selects is marked before the press returns.
  await expect
    .poll(async () => {
      await page.keyboard.press("ArrowDown")
      return offered.nth(1).getAttribute("aria-selected")
    })
    .toBe("true")
  await page.keyboard.press("ArrowUp")
  await expect(offered.first()).toHaveAttribute("aria-selected", "true")
  await page.keyboard.press("Enter")
  await page.keyboard.press("Enter")
  await page.keyboard.type("-- next")
  await expect.poll(() => learner.haskellText()).toMatch(/\nall = map\n\n *-- next$/)
  // What only has the letters of a new name somewhere does not take its place.
  await page.keyboard.type("\nlook here")
  await expect(offered.filter({hasText: /^where/})).toBeVisible()
  await page.keyboard.press("Enter")
  await page.keyboard.type("= there")
  await expect.poll(() => learner.haskellText()).toMatch(/\n *look here\n *= there$/)
})

test("broken text keeps its blocks, dimmed, until it is mended", async ({page}) => {
  const learner = new Learner(page)
  await learner.opens("accelerateAndPlay")
  const blocks = await learner.definition("play").count()
  await learner.findsInHaskell("(Bumper _ Pressed)")
  await page.keyboard.press("ArrowRight")
  await page.keyboard.press("Backspace")
  await expect(learner.haskell()).toContainText("play (Bumper _ Pressed = Just")
  await expect(learner.dimmed()).toHaveCount(1)
  await expect(learner.definition("play")).toHaveCount(blocks)
  await learner.seesProblem(/bracket/)
  await learner.keeps("broken-text")
  // Other blocks can be changed; a change of the dimmed ones, which would lose what is typed, is refused.
  await learner.changesNumber("0.5", "0.25")
  await expect(learner.haskell()).toContainText("vl + 0.25")
  await learner.dimmed().getByText("nothing", {exact: true}).click()
  await page.keyboard.press("Escape")
  await page.keyboard.press("Delete")
  await expect(page.getByText("Not finished in the Haskell text: play.")).toBeVisible()
  await learner.keeps("unfinished-text")
  await expect(learner.haskell()).toContainText("play (Bumper _ Pressed = Just ErrorSound")
  await expect(learner.dimmed().getByText("nothing", {exact: true})).toBeVisible()
  await learner.findsInHaskell("(Bumper _ Pressed")
  await page.keyboard.press("ArrowRight")
  await page.keyboard.type(")")
  await expect(learner.haskell()).toContainText("play (Bumper _ Pressed) = Just")
  await expect(learner.dimmed()).toHaveCount(0)
  await expect(page.getByTestId("problems")).toContainText("No problems.")
})

test("a comment survives an edit of another definition in blocks", async ({page}) => {
  const learner = new Learner(page)
  await learner.opens("accelerateAndPlay")
  await learner.findsInHaskell("play :: Bumper")
  await page.keyboard.press("Home")
  await page.keyboard.type("-- Ouch!   (do not touch)")
  await page.keyboard.press("Enter")
  await page.keyboard.press("Enter")
  // The blocks follow the cursor: the definition of the number comes back into sight.
  await learner.findsInHaskell("accelerate ::")
  await learner.changesNumber("0.5", "0.25")
  await expect(learner.haskell()).toContainText("vl + 0.25")
  await expect
    .poll(() => learner.haskellText())
    .toContain("-- Ouch!   (do not touch)\n\nplay :: Bumper -> Maybe Sound\n")
})

test("undo and redo walk through the edits of both views in their order", async ({page}) => {
  const learner = new Learner(page)
  await learner.opens("accelerateAndPlay")
  const [first, second] = await learner.takesAStep()
  await learner.findsInHaskell("ErrorSound")
  // At once: a pause between two letters would begin another step.
  await page.keyboard.insertText("OnSound")
  await expect(learner.haskell()).toContainText("Just OnSound")
  await expect(learner.definition("play").getByText("switched on")).toBeVisible()
  const third = await learner.haskellText()
  await learner.changesNumber("0.25", "0.75")
  await expect(learner.haskell()).toContainText("vl + 0.75")
  const fourth = await learner.haskellText()
  const undo = page.getByRole("button", {name: "Undo"})
  await learner.comesBy(() => undo.click(), third, second, first)
  await expect(undo).toBeDisabled()
  await expect(learner.number("0.5")).toBeVisible()
  const redo = page.getByRole("button", {name: "Redo"})
  await learner.comesBy(() => redo.click(), second, third, fourth)
  await expect(learner.definition("play").getByText("switched on")).toBeVisible()
  await expect(learner.number("0.75")).toBeVisible()
})

test("a problem is mended with a button, in one step that undo takes back", async ({page}) => {
  const learner = new Learner(page)
  await learner.opens("accelerateAndPlay")
  await learner.findsInHaskell("play (Bumper _ Released) = Nothing")
  await page.keyboard.press("Backspace")
  await learner.seesProblem(/says nothing about some cases/)
  const before = await learner.haskellText()
  await page.getByRole("button", {name: "Add a case for everything else"}).click()
  await expect(learner.haskell()).toContainText("play _ = _")
  // The open place is selected: what is typed goes there. A pause between two letters would begin another step.
  await page.keyboard.insertText("Nothing")
  await expect(learner.haskell()).toContainText("play _ = Nothing")
  await expect(page.getByTestId("problems")).toContainText("No problems.")
  await page.keyboard.press("Control+z")
  await page.keyboard.press("Control+z")
  await expect.poll(() => learner.haskellText()).toBe(before)
})

test("misspelt, not imported, without a type: Ctrl and the full stop mend it where the cursor is", async ({
  page,
}) => {
  const learner = new Learner(page)
  await learner.opens("accelerateAndPlay")
  await learner.findsInHaskell("ErrorSound")
  await page.keyboard.type("ErorSound")
  await learner.seesFix("Write ErrorSound")
  await learner.haskell().focus()
  await page.keyboard.press("Escape")
  await page.keyboard.press("Control+.")
  await expect(learner.haskell()).toContainText("Just ErrorSound")
  await page.keyboard.press("Control+End")
  await page.keyboard.type('\ngreet (Bumper _ _) = Say (map toUpper "ouch"')
  await learner.seesFix("Import toUpper")
  await learner.haskell().focus()
  await page.keyboard.press("Escape")
  await page.keyboard.press("Control+.")
  await expect(learner.haskell()).toContainText("import Data.Char (toUpper)")
  await expect(page.getByTestId("problems")).toHaveText(/^greet is never used\./)
  await page.keyboard.press("Control+End")
  await page.keyboard.press("Control+.")
  await expect(learner.haskell()).toContainText("greet :: Bumper -> Say")
})

test("a name is changed everywhere it means the same, and Undo takes it back", async ({page}) => {
  const learner = new Learner(page)
  await learner.opens("accelerateAndPlay")
  const before = await learner.haskellText()
  await learner.findsInHaskell("play ::")
  await page.keyboard.press("ArrowLeft")
  await page.keyboard.press("F2")
  await page.getByLabel("New name for play").fill("accelerate")
  await page.keyboard.press("Enter")
  await expect(page.getByRole("alert")).toContainText("accelerate")
  await page.getByLabel("New name for play").fill("complain")
  await page.keyboard.press("Enter")
  await expect(learner.haskell()).toContainText("simulate (accelerate, complain)")
  await expect(learner.definition("complain")).toBeVisible()
  await page.getByRole("button", {name: "Undo"}).click()
  await expect.poll(() => learner.haskellText()).toBe(before)
})

test("while somebody writes, the text says what fits and whose input comes next", async ({page}) => {
  const learner = new Learner(page)
  await learner.opens("accelerateAndPlay")
  await learner.entersHaskell()
  await page.keyboard.press("Control+End")
  await page.keyboard.type("\nblink :: Bumper -> Led1\nblink _ = Led1 ")
  await expect(page.locator(".hs-call b")).toHaveText("LedColor")
  await page.keyboard.press("Control+Space")
  const offered = page.getByRole("listbox").getByRole("option")
  await expect(offered.filter({hasText: "Orange"})).toBeVisible()
  // The compiler's colours come first. Before its answer the list may be made again, and takes no keys meanwhile.
  await expect(offered.first()).toContainText(/^Black/)
  await page.keyboard.type("Ora")
  await expect(offered.first()).toContainText("Orange")
  await page.keyboard.press("Enter")
  await expect(learner.haskell()).toContainText("blink _ = Led1 Orange")
  await learner.haskell().getByText("ErrorSound").hover()
  await expect(page.locator(".hs-explained").last()).toContainText("ErrorSound :: Sound")
  await expect(page.getByRole("link", {name: "Read more"})).toHaveAttribute("href", /api-docs/)
})

test.describe("a block of the toolbox that is let fall on the text", () => {
  /// Drags what the search finds first to a place in the Haskell, by mouse or by finger.
  async function carries(page: Page, words: string, to: {x: number; y: number}, by: "mouse" | "touch") {
    await page.locator(".rosySearch").click()
    await page.keyboard.insertText(words)
    const found = page.locator(".blocklyFlyout .blocklyDraggable > .blocklyPath").first()
    const box = await boxAtRest(found)
    const from = {x: box.x + 9, y: box.y + Math.min(box.height / 2, 12)}
    const path = [{x: (from.x + to.x) / 2, y: to.y}, to]
    const finger = by === "touch" ? await Finger.on(page) : null
    if (finger !== null) {
      await finger.takesUp(from)
      for (const spot of path) await finger.movesTo(spot)
    } else {
      await page.mouse.move(from.x, from.y)
      await page.mouse.down()
      for (const {x, y} of [{x: from.x + 30, y: from.y}, ...path]) {
        await page.mouse.move(x, y)
        await drawn(page)
      }
    }
    await expect(page.locator(".hs-carried")).toBeVisible()
    await (finger?.letsGo() ?? page.mouse.up())
    await expect(page.locator(".hs-carried")).toBeHidden()
  }
  for (const by of ["mouse", "touch"] as const)
    test.describe(`by ${by}`, () => {
      test.use({hasTouch: by === "touch"})
      test("is there as its Haskell, and gone with one undo", async ({page}) => {
        const learner = new Learner(page)
        await learner.opens("accelerateAndPlay")
        const before = await learner.haskellText()
        const blocks = await page.locator(".blocklySvg .blocklyBlockCanvas > .blocklyDraggable").count()
        const line = await boxAtRest(page.locator(".cm-line", {hasText: "main = simulate"}))
        await carries(page, "function", {x: line.x + 60, y: line.y + line.height * 3}, by)
        await expect
          .poll(() => learner.haskellText())
          .toMatch(/\nmain = simulate \(accelerate, play\)\n\n\S.* = _$/)
        await learner.keeps(`carried-${by}`)
        await page.getByRole("button", {name: "Undo"}).click()
        await expect.poll(() => learner.haskellText()).toBe(before)
        await expect(page.locator(".blocklySvg .blocklyBlockCanvas > .blocklyDraggable")).toHaveCount(blocks)
      })
    })
})

test("what is chosen, what is wrong and what is at work is seen in both views", async ({page}) => {
  const learner = new Learner(page)
  await learner.opens("accelerateAndPlay")
  // A block is chosen: its text is marked. The cursor is put elsewhere: the block there is marked.
  await learner.definition("play").getByText("play", {exact: true}).first().click()
  await page.keyboard.press("Escape")
  await expect(page.locator(".hs-linked-line").first()).toContainText("play")
  await learner.findsInHaskell("vl + 0.5")
  await expect(learner.definition("accelerate").locator(".rosyTold").first()).toBeVisible()
  await expect(page.locator(".hs-linked").first()).toContainText("0.5")
  await learner.keeps("both-selected")
  // What is at work glows, once the robot has run into something.
  await learner.runs()
  await expect(page.locator(".hs-glowing").first()).toContainText("accelerate")
  await expect(learner.definition("accelerate").and(page.locator(".rosyFired"))).toBeVisible()
  await learner.stops()
  // What is wrong is marked on the words and on the block that says them.
  await learner.findsInHaskell("0.5")
  await page.keyboard.type("True")
  await expect(page.locator(".cm-lintRange-error", {hasText: "True"}).first()).toBeVisible()
  await expect(learner.wrongBlocks().first()).toBeVisible()
  await learner.keeps("both-wrong")
})

test("what is no program is refused with a sentence; text from elsewhere opens as it is", async ({
  page,
}, info) => {
  const learner = new Learner(page)
  await learner.opens("accelerateAndPlay")
  const before = await learner.haskellText()
  const opens = async (name: string, content: string | Uint8Array) => {
    const path = info.outputPath(name)
    writeFileSync(path, content)
    await learner.opensFile(path)
  }
  const pastes = (text: string) =>
    learner.haskell().evaluate((pane, content) => {
      const clipboardData = new DataTransfer()
      clipboardData.setData("text/plain", content)
      pane.dispatchEvent(new ClipboardEvent("paste", {clipboardData, bubbles: true, cancelable: true}))
    }, text)
  const notice = page.getByRole("alert").or(page.locator(".notice"))
  await opens("program.py", 'print("hello")\n')
  await expect(notice).toContainText("program.py is not a program.")
  await opens("huge.hs", "x = 1 -- and so on\n".repeat(250_000))
  await expect(notice).toContainText("huge.hs is too large.")
  await pastes("x = 1 -- and so on\n".repeat(20_000))
  await expect(notice).toContainText("The pasted text is too large.")
  await opens(
    "picture.hs",
    new Uint8Array([0x89, 0x50, 0x4e, 0x47, 0x0d, 0x0a, 0x1a, 0x0a, 0x00, 0x00, 0x00, 0x0d]),
  )
  await expect(notice).toContainText("picture.hs does not hold text.")
  await expect.poll(() => learner.haskellText()).toBe(before)
  await opens(
    "size.hs",
    "module Main where\r\nimport Data.List (sort)\r\n\r\n-- Größe\r\ngröße :: Double\r\ngröße = 1\r\n",
  )
  await expect(learner.definition("größe")).toBeVisible()
  await expect
    .poll(() => learner.haskellText())
    .toContain("import Data.List (sort)\n\n-- Größe\ngröße :: Double")
  await opens("tracks.lhs", "It drives.\n\n> onward :: Velocity\n> onward = Velocity 0.2 0\n\nThat is all.\n")
  await expect.poll(() => learner.haskellText()).toContain("-- It drives.\n\nonward :: Velocity\n")
  await expect(learner.definition("onward")).toBeVisible()
  await opens("document.hs", "-- 1 – 2\nsize = 2 – 1 × 3\n")
  await expect(notice).toContainText(
    "document.hs has 2 characters that look right and are not. The first: ‘–’ (en dash) for ‘-’.",
  )
  await pastes("twice = 3 − 1 -- −\n")
  await expect(notice).toContainText(
    "The pasted text has one character that looks right and is not: ‘−’ (minus sign) for ‘-’.",
  )
  await page.getByRole("button", {name: "Repair"}).click()
  await expect.poll(() => learner.haskellText()).toContain("twice = 3 - 1 -- −\n-- 1 – 2\nsize = 2 – 1 × 3")
  await expect(page.getByRole("button", {name: "Repair"})).toBeHidden()
  await page.getByRole("button", {name: "Undo"}).click()
  await expect.poll(() => learner.haskellText()).toContain("twice = 3 − 1")
  await opens("empty.hs", "")
  await expect(notice).toContainText("empty.hs is empty.")
  await expect(learner.definition("size")).toBeVisible()
})
