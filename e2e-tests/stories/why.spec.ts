/// Questions about a run: why, one step further back, and why not; the answer in sentences, diagram, blocks, text and time line.

import {AxeBuilder} from "@axe-core/playwright"
import {expect, type Page} from "@playwright/test"
import {Floor} from "./floor.ts"
import {Learner} from "./learner.ts"
import {test} from "./story.ts"

const answer = (page: Page) => page.getByTestId("why-answer")
/// A coordinate of the robot, as its readout says it.
const metres = async (learner: Learner, what: "x" | "y") =>
  Number.parseFloat((await learner.robot(what).textContent()) ?? "")
const time = String.raw`\d+\.\d\d s`

test("the robot backs off from a wall: why, and one step back to the bumper", async ({page}) => {
  const learner = new Learner(page)
  await learner.opens("forwardBackward")
  await page.getByRole("button", {name: "Diagram", exact: true}).click()
  await learner.runs()
  await expect(page.getByTestId("console")).toContainText("Bumper CenterBumper Pressed")
  await page.getByRole("button", {name: "Pause", exact: true}).click()
  await page.getByRole("button", {name: "Why does the robot move like this?"}).click()

  // The sentences.
  await expect(answer(page)).toContainText(new RegExp(`^At ${time} forwardBackward sent Velocity`))
  await expect(answer(page)).toContainText(
    new RegExp(`Memory Hit was True since ${time}: bump remembered it\\.`),
  )
  await expect(answer(page)).toContainText("In forwardBackward the guard hit held.")
  // The path in the blocks, the text, the diagram, and on the time line.
  const blocks = page.locator(".rosyWhy")
  await expect(blocks).toHaveCount(2)
  await expect(page.locator(".hs-why").filter({hasText: "forwardBackward ("})).toHaveCount(1)
  await expect(page.locator(".hs-why").filter({hasText: "bump _ ="})).toHaveCount(1)
  const nodes = page.locator("svg.diagram .node.why")
  await expect(nodes).toHaveCount(6)
  await expect(page.locator(".why-marks i").first()).toBeAttached()
  await learner.keeps("why")
  const {violations} = await new AxeBuilder({page}).include(".region.room").analyze()
  expect(violations).toEqual([])

  // One step further back.
  await answer(page).getByRole("button", {name: "bump", exact: true}).first().click()
  await expect(answer(page)).toContainText(
    new RegExp(`bump ran at ${time} because the centre bumper was (pressed|released)\\.`),
  )
  await expect(page.locator(".hs-why").filter({hasText: "forwardBackward ("})).toHaveCount(0)
  await expect(blocks).toHaveCount(1)
  // And to the question before.
  await page.getByTestId("why").getByRole("button", {name: "Back"}).click()
  await expect(blocks).toHaveCount(2)
  await page.keyboard.press("Escape")
  await expect(page.getByTestId("why")).toHaveCount(0)
  await expect(blocks).toHaveCount(0)

  // In the picture of the room: a point of the trail and the robot by mouse, both by key.
  const heading = page.getByTestId("why").getByRole("heading")
  const floor = new Floor(page, [5, 4])
  const [x, y] = await floor.pixel(2.5, 2)
  await page.mouse.click(x, y)
  await expect(heading).toHaveText(new RegExp(`^Why was the robot there at ${time}\\?$`))
  await expect(answer(page)).toContainText(/forwardBackward/)
  await expect(blocks.first()).toBeVisible()
  await learner.keeps("why-trail")
  await page.keyboard.press("Escape")
  await expect(heading).toHaveCount(0)
  await floor.canvas().focus()
  await page.keyboard.press("w")
  await expect(heading).toHaveText(/^Why does it move like this/)
  await page.keyboard.press("p")
  await expect(heading).toHaveText(/^Why was the robot there/)
  await page.keyboard.press("Escape")
  await page.mouse.click(...(await floor.pixel(await metres(learner, "x"), await metres(learner, "y"))))
  await expect(heading).toHaveText(/^Why does it move like this/)
  // The diagram's list form tells the path, too.
  await expect(nodes).toHaveCount(6)
  await page.getByRole("button", {name: "As a list"}).click()
  const told = page.locator(".diagram-list").getByRole("button", {name: /; part of the answer$/})
  await expect(told).toHaveCount(6)
  await told.first().focus()
  await page.keyboard.press("ArrowDown")
  await expect(told.nth(1)).toBeFocused()
  await learner.stops()
})

test("a function that waits for a bumper: why did it not run, and why was no sound played", async ({
  page,
}) => {
  const learner = new Learner(page)
  await learner.opens("accelerateAndPlay")
  // Slow enough that the robot is paused before it comes to a wall.
  await page.getByLabel("Speed", {exact: true}).selectOption("0.1")
  await learner.runs()
  await expect(learner.robot("time")).not.toHaveText("0.00")
  await page.getByRole("button", {name: "Pause", exact: true}).click()
  await learner.definition("play").click({button: "right", position: {x: 8, y: 8}})
  await page.getByRole("menuitem", {name: "Why did play not run?"}).click()
  await expect(answer(page)).toHaveText(
    new RegExp(`^play takes a Bumper; none came between ${time} and ${time}\\. None had come before\\.$`),
  )
  await expect(page.locator(".rosyWhy")).toHaveCount(1)
  await page.getByTestId("why").getByRole("button", {name: "Why no Sound?"}).click()
  await expect(page.getByTestId("why").getByRole("heading")).toHaveText("Why did play send no Sound?")
  await expect(answer(page)).toContainText("play takes a Bumper; none came")
  await learner.stops()
})

test("shown values ask why: in the text, on blocks, in the diagram, and by key; so does a command in an answer", async ({
  page,
}) => {
  const learner = new Learner(page)
  await learner.opens("forwardBackward")
  await page.getByRole("button", {name: "Diagram", exact: true}).click()
  await page.getByRole("button", {name: "Trail, picture and film"}).click()
  await page.getByRole("checkbox", {name: "Show values in the program"}).check()
  await page.keyboard.press("Escape")
  await learner.runs()
  await expect(page.getByTestId("console")).toContainText("Bumper CenterBumper Pressed")
  await page.getByRole("button", {name: "Pause", exact: true}).click()
  const heading = page.getByTestId("why").getByRole("heading")
  const asks = async (question: string, ask: () => Promise<void>) => {
    await ask()
    await expect(heading).toHaveText(question)
    await page.getByRole("button", {name: "Close the answer"}).click()
    await expect(heading).toHaveCount(0)
  }
  const inText = (line: string) => page.locator(".cm-line", {hasText: line}).locator(".hs-value")
  const memory = "Why does Memory Hit have its value?"
  await asks(memory, () => inText("type Hit").click())
  await asks("Why did bump run?", () => inText("bump ::").click())
  await asks(memory, () => learner.definition("Hit").locator("> .rosyValue").click())
  await asks("Why did bump run?", () => learner.definition("bump").locator("> .rosyValue").click())
  const diagram = page.locator("svg.diagram")
  await asks(memory, () => diagram.locator(".node.store text.value").click())
  await asks("What happened with Bumper?", () => diagram.locator(".node.event text.value").click())
  await asks("Why does it move like this?", () => diagram.locator(".node.state text.value").click())
  await learner.findsInHaskell("bump _")
  await asks("Why did bump run?", () => page.keyboard.press("Shift+Alt+W"))

  // A type does not run; a value of it can be asked about.
  await learner.definition("Hit").click({button: "right", position: {x: 8, y: 8}})
  await expect(page.getByRole("menuitem", {name: "Why does it have this value?"})).toBeVisible()
  await expect(page.getByRole("menuitem", {name: /Hit .*run/})).toHaveCount(0)
  await asks(memory, () => page.getByRole("menuitem", {name: "Why does it have this value?"}).click())

  // A node under the pointer or with the keyboard tells its type and its last value.
  const told = (kind: string) => diagram.locator(`.node.${kind} > title`)
  await diagram.locator(".node.function").first().hover()
  await expect(told("function").first()).toHaveText(
    /^bump\ntype Bumper -> Memory Hit\nlast: Bumper CenterBumper (Pressed|Released) → Memory True/,
  )
  await diagram.locator(".node.command").focus()
  await expect(told("command")).toHaveText(/^Velocity\ntype Velocity\nlast: Velocity /)

  // One step further back by a command in the answer.
  await asks("Why did forwardBackward run?", () => inText("forwardBackward ::").click())
  await inText("forwardBackward ::").click()
  await answer(page)
    .getByRole("button", {name: /^Velocity/})
    .click()
  await expect(heading).toHaveText(/^Why Velocity \S+ \S+\?$/)
  await expect(answer(page)).toContainText(new RegExp(`^At ${time} forwardBackward sent Velocity`))
  await learner.stops()
})
