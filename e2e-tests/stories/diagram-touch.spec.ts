/// The diagram with fingers on a tablet: wires are dragged, also downwards out of a palette; a node is opened with a tap; two fingers zoom.

import {expect, type Locator, type Page} from "@playwright/test"
import {boxAtRest, drawn} from "./at_rest.ts"
import {diagram, node} from "./diagram_page.ts"
import {Finger, type Spot} from "./finger.ts"
import {Learner} from "./learner.ts"
import {test} from "./story.ts"

test.use({viewport: {width: 820, height: 1180}, hasTouch: true, isMobile: true})

/// CSS pixels: the smallest thing that a finger takes or presses.
const smallest = 44

async function middle(end: Locator): Promise<Spot> {
  const box = await boxAtRest(end)
  return {x: box.x + box.width / 2, y: box.y + box.height / 2}
}

async function drags(finger: Finger, from: Locator, to: Locator): Promise<void> {
  const end = await middle(to)
  await finger.takesUp(await middle(from))
  await finger.movesTo(end)
  await finger.letsGo()
}

/// Two fingers that go apart, around the middle of the drawing.
async function spreads(page: Page, around: Spot): Promise<void> {
  const session = await page.context().newCDPSession(page)
  const touch = async (type: "touchStart" | "touchMove" | "touchEnd", apart: number) => {
    const touchPoints =
      type === "touchEnd"
        ? []
        : [
            {x: around.x - apart, y: around.y, id: 0},
            {x: around.x + apart, y: around.y, id: 1},
          ]
    await session.send("Input.dispatchTouchEvent", {type, touchPoints})
    await drawn(page)
  }
  await touch("touchStart", 40)
  for (const apart of [55, 70, 85]) await touch("touchMove", apart)
  await touch("touchEnd", 85)
}

test("with fingers: two wires, the node of one of them, and a larger drawing", async ({page}) => {
  const learner = new Learner(page)
  await learner.opens("move")
  await page.getByRole("button", {name: "More", exact: true}).tap()
  await page.getByText("New program").tap()
  await page.getByRole("button", {name: "Diagram", exact: true}).tap()
  await expect(diagram(page)).toContainText("The program simulates nothing yet.")
  const finger = await Finger.on(page)
  const offered = (side: "sensors" | "actuators", name: string) =>
    diagram(page)
      .locator(`.diagram-palette.of-${side}`)
      .getByRole("listitem")
      .filter({hasText: new RegExp(`^${name}$`)})
  for (const end of [offered("sensors", "tick"), offered("actuators", "Velocity")])
    expect((await boxAtRest(end)).height).toBeGreaterThanOrEqual(smallest)
  await drags(finger, offered("sensors", "tick"), offered("actuators", "Velocity"))
  await expect(node(page, /^driveOn: function/)).toBeVisible()
  await drags(finger, offered("sensors", "Bumper"), offered("actuators", "Velocity"))
  const backOff = node(page, /^backOff: function/)
  await expect(backOff).toBeVisible()
  await learner.keeps("diagram-touch")

  const wide = (await boxAtRest(backOff)).width
  await spreads(page, await middle(diagram(page).locator(".diagram-host")))
  expect((await boxAtRest(backOff)).width).toBeGreaterThan(1.2 * wide)

  await backOff.tap()
  const actions = diagram(page).getByRole("group", {name: "What can be done with backOff"})
  await expect(actions).toBeVisible()
  for (const button of await actions.getByRole("button").all())
    expect((await boxAtRest(button)).height).toBeGreaterThanOrEqual(smallest)
})
