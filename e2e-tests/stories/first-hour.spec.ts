/// The first hour: small programs built from an empty page by mouse, by touch and by keyboard. Each story prints the number of
/// actions that it took; mouse and touch keep within the goal of issue 24.

import {expect} from "@playwright/test"
import {Builder, type Input} from "./actions.ts"
import {rotated} from "./extent.ts"
import {until} from "./learner.ts"
import {test} from "./story.ts"

interface Story {
  readonly title: string
  /// The most actions; `null` for a story without a goal.
  readonly goal: number | null
  readonly build: (by: Builder) => Promise<void>
  readonly behaves: (by: Builder) => Promise<void>
}

const stories: readonly Story[] = [
  {
    title: "drive forward",
    goal: 3,
    async build(by) {
      await by.offers()
      await by.takes(/^driveOn/, "drive straight on")
      await by.runs()
    },
    async behaves({learner}) {
      // It drives to the wall; how fast it was may be over when the story looks.
      await until(learner.robot("x"), x => x > 1.7)
    },
  },
  {
    title: "a sound on a bump",
    goal: 6,
    async build(by) {
      await by.offers()
      await by.takes(/^complain/, "complain")
      await by.runs()
    },
    async behaves({learner}) {
      await expect(learner.runButton()).toHaveText("Stop")
      await expect(learner.haskell()).toContainText("complain (Bumper _ Pressed) = Just ErrorSound")
    },
  },
  {
    title: "bounce between walls with Memory",
    goal: 14,
    async build(by) {
      await by.offers()
      await by.takes(/^driveOn/, "drive straight on")
      await by.grows("run one more")
      await by.offers()
      await by.takes(/^backOff/, "back off")
      await by.writes(/turning, radians a second, number/, "2")
      await by.clicks(by.page.getByRole("tab", {name: /Problems/}))
      await by.clicks(by.page.getByRole("button", {name: /mux/}))
      await by.runs()
    },
    async behaves({learner, page}) {
      await page.getByLabel("Speed", {exact: true}).selectOption("8")
      await page.getByRole("tab", {name: "Console"}).click()
      await expect(learner.haskell()).toContainText("Memory")
      // The robot leaves the wall in front of it, and comes to another.
      await expect
        .poll(() =>
          learner
            .console()
            .getByText(/Pressed/)
            .count(),
        )
        .toBeGreaterThan(3)
    },
  },
  {
    title: "a square",
    goal: 8,
    async build(by) {
      await by.offers()
      await by.drawer("Ready-made")
      await by.takes(/^repeat/, "repeat", true)
      await by.drawer("Ready-made")
      await by.takes(/^drive, 50/, "drive 50 cm", true)
      await by.drawer("Ready-made")
      await by.takes(/^turn, 90/, "turn 90 degrees")
      await by.runs()
    },
    async behaves({learner}) {
      await until(learner.robot("heading"), degrees => Math.abs(degrees) > 80)
      await expect(learner.haskell()).toContainText("replicateM_ 4")
    },
  },
  {
    title: "an own event and a function that reacts to it",
    goal: 14,
    async build(by) {
      await by.offers()
      await by.drawer("When it senses")
      await by.takes(/^onBump/, "when the bumper is pressed", true)
      await by.offers()
      await by.takes(/Knock/, "own event: something")
      await by.grows("run one more")
      await by.offers()
      await by.drawer("Own types")
      await by.takes(/^onEvent/, "when an own event happens", true)
      await by.offersInput()
      await by.takes(/Knock/, "Knock", true)
      await by.offers()
      await by.takes(/^sound, error/i, "play a sound")
      await by.runs()
    },
    async behaves({learner}) {
      await expect(learner.runButton()).toHaveText("Stop")
      const haskell = learner.haskell()
      for (const line of [
        "data Knock = Knock",
        "onBump (Bumper _ Pressed) = Knock",
        "onEvent Knock = ErrorSound",
        "simulate (onBump, onEvent)",
      ])
        await expect(haskell).toContainText(line)
    },
  },
  {
    title: "count bumps",
    goal: null,
    async build(by) {
      await by.offers()
      await by.takes(/^countBumps/, "count bumps")
      await by.runs()
    },
    async behaves({learner}) {
      await expect(learner.runButton()).toHaveText("Stop")
      await expect(learner.haskell()).toContainText("Memory (n + 1)")
    },
  },
]

const inputs: readonly Input[] = ["mouse", "touch", "keyboard"]

/// Each story with each kind of input. Neighbours differ in both: as many days pass until a story comes again, with another input.
const pairs = inputs.flatMap((_, round) =>
  stories.map((story, i) => ({...story, input: inputs[(i + round) % inputs.length] ?? "mouse"})),
)

// One of them each day.
for (const {title, goal, build, behaves, input} of rotated(pairs, pairs.length))
  test.describe(input, () => {
    test.use({hasTouch: input === "touch"})
    test(`${title} by ${input}`, async ({page}) => {
      const by = new Builder(page, input)
      await by.begins()
      await build(by)
      const goalSaid = goal === null ? "" : ` (goal ${goal})`
      console.log(`${title} by ${input}: ${by.actions} actions${goalSaid}`)
      await behaves(by)
      if (goal !== null && input !== "keyboard") expect(by.actions).toBeLessThanOrEqual(goal)
    })
  })
