/// Five tasks of the first hour in the diagram, by mouse, from an empty program: each takes at most as many actions as in blocks. What the robot then does is watched. A drag, a press, a
/// turn of the wheel and a typed word are one action each.

import {expect, type Locator, type Page} from "@playwright/test"
import {boxAtRest} from "./at_rest.ts"
import {beginsInDiagram, diagram, drags, node} from "./diagram_page.ts"
import type {Learner} from "./learner.ts"
import {test} from "./story.ts"

interface Task {
  readonly title: string
  /// The most actions in blocks, with the press of Run, as `first-hour.spec.ts` counts them.
  readonly inBlocks: number
  readonly program: string
  readonly build: (by: Newcomer) => Promise<void>
  readonly behaves: (learner: Learner) => Promise<void>
}

/// Someone at the diagram who counts.
class Newcomer {
  actions = 0
  readonly page: Page

  constructor(page: Page) {
    this.page = page
  }

  async drags(from: Locator, to: Locator): Promise<void> {
    for (const end of [from, to]) {
      await expect(end).toBeVisible()
      await this.scrollsTo(end)
    }
    await drags(this.page, from, to)
    this.actions++
  }

  async presses(button: Locator): Promise<void> {
    await button.click()
    this.actions++
  }

  /// Turns the wheel over a palette until all of an entry is seen.
  private async scrollsTo(end: Locator): Promise<void> {
    const list = end.locator("xpath=ancestor::div[contains(@class, 'diagram-palette')]")
    if ((await list.count()) === 0) return
    const [entry, seen] = [await boxAtRest(end), await boxAtRest(list)]
    const hidden = entry.y + entry.height - (seen.y + seen.height)
    if (hidden <= 0) return
    await this.page.mouse.move(seen.x + seen.width / 2, seen.y + seen.height / 2)
    await this.page.mouse.wheel(0, hidden)
    await expect.poll(async () => (await boxAtRest(end)).y).toBeLessThan(entry.y)
    this.actions++
  }

  offered(side: "sensors" | "actuators" | "steps", name: string): Locator {
    return diagram(this.page)
      .locator(`.diagram-palette.of-${side}`)
      .getByRole("listitem")
      .filter({hasText: new RegExp(`^${name}$`)})
  }

  node(name: RegExp): Locator {
    return node(this.page, name)
  }
}

const forwards = (speed: number) => speed > 0.15
const backwards = (speed: number) => speed < -0.05

const tasks: readonly Task[] = [
  {
    title: "drive",
    inBlocks: 3,
    program: `
driveOn :: Velocity
driveOn = Velocity 0.2 0

main :: IO ()
main = simulate driveOn
`,
    build: by => by.drags(by.offered("sensors", "tick"), by.offered("actuators", "Velocity")),
    behaves: learner => learner.runsUntil("speed", forwards),
  },
  {
    title: "back off at a wall",
    inBlocks: 6,
    program: `
driveOn :: Velocity
driveOn = Velocity 0.2 0

backOff :: Bumper -> Maybe Velocity
backOff (Bumper _ Pressed) = Just (Velocity (-0.2) 0)
backOff (Bumper _ Released) = Nothing

main :: IO ()
main = simulate (priority 1 backOff driveOn)
`,
    async build(by) {
      await by.drags(by.offered("sensors", "tick"), by.offered("actuators", "Velocity"))
      await by.drags(by.offered("sensors", "Bumper"), by.node(/^Velocity: command/))
      await by.presses(by.node(/^Velocity: command;.*several functions are in conflict over it/))
      await by.presses(diagram(by.page).getByRole("button", {name: "Let backOff go first, for 1 s"}))
    },
    behaves: learner => learner.runsUntil("speed", forwards, backwards, forwards),
  },
  {
    title: "remember a bump",
    // Of *count bumps*, which is one ready-made block.
    inBlocks: 3,
    program: `
onBumper :: Bumper -> Maybe (Memory Bool)
onBumper (Bumper _ Pressed) = Just (Memory True)
onBumper _ = Nothing

onBool :: Memory Bool -> Velocity
onBool (Memory True) = Velocity (-0.2) 0
onBool (Memory False) = Velocity 0.2 0

main :: IO ()
main = simulate (onBumper, onBool)
`,
    async build(by) {
      await by.drags(by.offered("sensors", "Bumper"), by.offered("actuators", "New memory"))
      await by.drags(by.node(/^Memory Bool: memory/), by.offered("actuators", "Velocity"))
    },
    behaves: learner => learner.runsUntil("speed", forwards, backwards),
  },
  {
    title: "an own event between two functions",
    inBlocks: 10,
    program: `
onBumper :: Bumper -> Maybe (Led1, FromOnBumper)
onBumper (Bumper _ Pressed) = Just (Led1 Red, FromOnBumper)
onBumper _ = Nothing

driveOn :: FromOnBumper -> Velocity
driveOn FromOnBumper = Velocity 0.2 0

data FromOnBumper = FromOnBumper

main :: IO ()
main = simulate (onBumper, driveOn)
`,
    async build(by) {
      await by.drags(by.offered("sensors", "Bumper"), by.offered("actuators", "Led1"))
      await by.drags(by.offered("sensors", "tick"), by.offered("actuators", "Velocity"))
      await by.drags(by.node(/^onBumper: function/), by.node(/^driveOn: function/))
    },
    behaves: learner => learner.runs(),
  },
  {
    title: "two states",
    inBlocks: 6,
    program: `
main :: IO ()
main = simulate (forever $ do
  driveUntilBump
  driveBack 1)
`,
    async build(by) {
      await by.drags(
        by.offered("steps", "driveUntilBump"),
        diagram(by.page).locator("[data-free-space]:visible"),
      )
      await by.drags(by.offered("steps", "driveBack"), by.node(/^driveUntilBump: step/))
      await by.drags(by.node(/^driveBack 1: step/), by.node(/^driveUntilBump: step/))
      await by.presses(diagram(by.page).getByRole("button", {name: "Repeat for ever"}))
    },
    behaves: learner => learner.runsUntil("speed", forwards, backwards, forwards),
  },
]

test("five tasks of the first hour take no more actions than in blocks", async ({page}) => {
  const learner = await beginsInDiagram(page)
  await page.getByLabel("Speed", {exact: true}).selectOption("4")
  const counts: string[] = []
  for (const {title, inBlocks, program, build, behaves} of tasks) {
    await page.getByRole("button", {name: "More", exact: true}).click()
    await page.getByText("New program").click()
    await expect(diagram(page)).toContainText("The program simulates nothing yet.")
    const by = new Newcomer(page)
    await build(by)
    await expect.poll(() => learner.haskellText()).toBe(program.trim())
    await behaves(learner)
    await learner.stops()
    const actions = by.actions + 1
    counts.push(`${title} in the diagram: ${actions} actions (the goal in blocks: ${inBlocks})`)
    expect(actions).toBeLessThanOrEqual(inBlocks)
  }
  console.log(counts.join("\n"))
})
