/// The first hour: small programs built from an empty page by mouse, by touch and by keyboard. Each story prints the number of
/// actions that it took; mouse and touch keep within the goal. All three build the same text, so what the program does is watched once,
/// after the mouse.

import {expect, type Page} from "@playwright/test"
import {Builder, type Input} from "./actions.ts"
import {until} from "./learner.ts"
import {test} from "./story.ts"

interface Story {
  readonly title: string
  /// The most actions; `null` for a story without a goal.
  readonly goal: number | null
  /// The goal is one for the keyboard as well.
  readonly isForKeys?: boolean
  /// The Haskell that is built.
  readonly program: string
  readonly build: (by: Builder) => Promise<void>
  readonly behaves: (by: Builder) => Promise<void>
}

const forwards = [(speed: number) => speed > 0.15]
const backwards = [(speed: number) => speed < -0.15]

async function choosesRoom(page: Page, name: string): Promise<void> {
  await page.locator(".room-choice").click()
  await page.locator("dialog[open]").getByRole("button", {name}).first().click()
  await expect(page.getByRole("button", {name: `Room to drive in: ${name}`})).toBeVisible()
}

/// The program runs in the room in which it was built, and in two others.
async function inThreeRooms(by: Builder, does: (by: Builder) => Promise<void>): Promise<void> {
  const {learner, page} = by
  await page.getByLabel("Speed", {exact: true}).selectOption("4")
  await does(by)
  for (const room of ["A slippery room, like a real one", "Two rooms and a door"]) {
    await learner.stops()
    await choosesRoom(page, room)
    await Promise.all([does(by), learner.runs()])
  }
}

const stories: readonly Story[] = [
  {
    title: "drive forward",
    goal: 3,
    program: `
driveOn :: Velocity
driveOn = Velocity 0.2 0

main :: IO ()
main = simulate driveOn
`,
    async build(by) {
      await by.offers()
      await by.takes(/^driveOn/, "drive straight on")
    },
    async behaves({learner}) {
      // It drives to the wall; how fast it was may be over when the story looks.
      await until(learner.robot("x"), x => x > 1.7)
    },
  },
  {
    title: "a sound on a bump",
    goal: 6,
    program: `
complain :: Bumper -> Maybe Sound
complain (Bumper _ Pressed) = Just ErrorSound
complain (Bumper _ Released) = Nothing

main :: IO ()
main = simulate complain
`,
    async build(by) {
      await by.offers()
      await by.takes(/^complain/, "complain")
    },
    behaves: ({learner}) => learner.stops(),
  },
  {
    title: "bounce between walls with a priority",
    goal: 7,
    program: `
driveOn :: Velocity
driveOn = Velocity 0.2 0

backOff :: Bumper -> Maybe Velocity
backOff (Bumper _ Pressed) = Just (Velocity (-0.2) 2)
backOff (Bumper _ Released) = Nothing

main :: IO ()
main = simulate (priority 1 backOff driveOn)
`,
    async build(by) {
      await by.offers()
      await by.takes(/^driveOn/, "drive straight on")
      await by.drawer("Ready-made")
      await by.takes(/^backOff/, "back off at a bump")
      await by.writes(/turning, radians a second, number/, "2")
    },
    async behaves({learner, page}) {
      await page.getByLabel("Speed", {exact: true}).selectOption("8")
      await page.getByRole("tab", {name: "Console"}).click()
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
    title: "back off at the wall",
    goal: 6,
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
      await by.offers()
      await by.takes(/^driveOn/, "drive straight on")
      await by.drawer("Ready-made")
      await by.takes(/^backOff/, "back off at a bump")
    },
    behaves: by =>
      inThreeRooms(by, ({learner}) =>
        until(learner.robot("speed"), ...forwards, ...backwards, ...forwards, ...backwards),
      ),
  },
  {
    title: "until the wall, then backwards",
    goal: 6,
    program: `
main :: IO ()
main = simulate $ do
  driveUntilBump
  forever (driveBack 1)
`,
    async build(by) {
      await by.offers()
      await by.takes(/^drive until.*bump/, "drive until a bump", true)
      await by.takes(/^forever,/, "drive backwards, on and on")
    },
    behaves: by =>
      inThreeRooms(by, async ({learner}) => {
        await until(learner.robot("speed"), ...forwards, ...backwards)
        // Half a metre is further than a step back of some seconds.
        const wall = Number(await learner.robot("x").textContent())
        await until(learner.robot("x"), x => x < wall - 0.5)
      }),
  },
  {
    title: "a sound at a button and a light at an edge",
    goal: 8,
    program: `
buttonSound :: Button -> Maybe Sound
buttonSound (Button Button0 Pressed) = Just ButtonSound
buttonSound _ = Nothing

edgeLight :: Cliff -> Led1
edgeLight (Cliff _ Hole) = Led1 Red
edgeLight (Cliff _ Floor) = Led1 Black

main :: IO ()
main = simulate (buttonSound, edgeLight)
`,
    async build(by) {
      await by.offers()
      await by.takes(/^buttonSound/, "beep at a button")
      await by.drawer("Ready-made")
      await by.takes(/^edgeLight/, "light up at an edge")
    },
    behaves: by =>
      inThreeRooms(by, async ({learner, page}) => {
        await expect(learner.runButton()).toHaveText("Stop")
        await page.getByRole("button", {name: "Button 0"}).click({delay: 300})
        await expect(learner.console()).toContainText("plays ButtonSound")
      }),
  },
  {
    title: "wander with a random turn",
    goal: 8,
    program: `
wander :: Task ()
wander = forever $ do
  driveUntilBump
  driveBack 1
  turnBetween 90 270

main :: IO ()
main = simulate wander
`,
    async build(by) {
      await by.offers()
      await by.takes(/^wander/, "each wall")
    },
    behaves: by =>
      inThreeRooms(by, async ({learner}) => {
        const heading = Number.parseFloat((await learner.robot("heading").textContent()) ?? "")
        await until(learner.robot("speed"), ...forwards, ...backwards)
        await until(learner.robot("speed"), ...forwards)
        const turned = Number.parseFloat((await learner.robot("heading").textContent()) ?? "") - heading
        expect(Math.cos((turned * Math.PI) / 180)).toBeLessThan(0.1)
      }),
  },
  {
    title: "a square",
    goal: 7,
    program: `
main :: IO ()
main =
  simulate
    (replicateM_ 4 $ do
      drive 50
      turn 90)
`,
    async build(by) {
      await by.offers()
      await by.takes(/^repeat/, "repeat", true)
      await by.takes(/^drive, 50/, "drive 50 cm", true)
      await by.takes(/^turn, 90/, "turn 90 degrees")
    },
    async behaves({learner}) {
      await until(learner.robot("heading"), degrees => Math.abs(degrees) > 80)
    },
  },
  {
    title: "an own event and a function that reacts to it",
    goal: 10,
    isForKeys: true,
    program: `
onBump :: Bumper -> Maybe Knock
onBump (Bumper _ Pressed) = Just Knock
onBump _ = Nothing

data Knock = Knock

onEvent :: Knock -> Sound
onEvent Knock = ErrorSound

main :: IO ()
main = simulate (onBump, onEvent)
`,
    async build(by) {
      await by.offers()
      await by.drawer("When it senses")
      await by.takes(/^onBump/, "when the bumper is pressed", true)
      await by.offers()
      await by.takes(/Knock/, "own event: something", true)
      await by.drawer("Own types")
      // It takes the program's only event.
      await by.takes(/^onEvent/, "when an own event happens", true)
      await by.offers()
      await by.takes(/^sound, error/i, "play a sound")
    },
    behaves: ({learner}) => learner.stops(),
  },
  {
    title: "count bumps",
    goal: null,
    program: `
countBumps :: Bumper -> Memory Int -> Memory Int
countBumps (Bumper _ Pressed) (Memory n) = Memory (n + 1)
countBumps (Bumper _ Released) (Memory n) = Memory n

main :: IO ()
main = simulate countBumps
`,
    async build(by) {
      await by.offers()
      await by.takes(/^countBumps/, "count bumps")
    },
    behaves: ({learner}) => learner.stops(),
  },
]

const inputs: readonly Input[] = ["mouse", "touch", "keyboard"]

const pairs = inputs.flatMap(input => stories.map(story => ({...story, input})))

for (const {title, goal, isForKeys = false, program, build, behaves, input} of pairs)
  test.describe(input, () => {
    test.use({hasTouch: input === "touch"})
    test(`${title} by ${input}`, async ({page}) => {
      const by = new Builder(page, input)
      await by.begins()
      await build(by)
      await expect.poll(() => by.learner.haskellText()).toBe(program.trim())
      await by.runs()
      const goalSaid = goal === null ? "" : ` (goal ${goal})`
      console.log(`${title} by ${input}: ${by.actions} actions${goalSaid}`)
      await (input === "mouse" ? behaves(by) : by.learner.stops())
      if (goal !== null && (input !== "keyboard" || isForKeys)) expect(by.actions).toBeLessThanOrEqual(goal)
    })
  })
