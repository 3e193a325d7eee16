/// How each step of the lessons is built in blocks, from the program that the step before it left: with any kind of input (`hands.ts`).
/// Several solutions are right; these are short ones.

import type {Hands} from "./hands.ts"

/// By lesson and step: `hello-robot/back`.
export type Recipes = {readonly [step: string]: (hands: Hands) => Promise<void>}

const field = {
  name: /^Edit name of the definition/,
  type: /^Edit type of/,
  speed: /speed, metres a second, number/,
  turning: /turning, radians a second, number/,
  operator: /^operator/,
}

const simulate = "the program: simulate"

/// Writes into the fields of the velocity that is in hand or was put last.
async function velocity(hands: Hands, speed: string, turning?: string): Promise<void> {
  await hands.puts("velocity:")
  await hands.writes(field.speed, speed, "last")
  if (turning !== undefined) await hands.writes(field.turning, turning, "last")
}

const drive: Recipes = {
  async "hello-robot/back"(hands) {
    await hands.takesUp(simulate)
    await hands.writes(field.speed, "-0.2")
  },
  async "hello-robot/ring"(hands) {
    await hands.takesUp(simulate)
    await hands.writes(field.speed, "0.4")
  },
  async "turn-on-the-spot/other-way"(hands) {
    await hands.takesUp(simulate)
    await hands.writes(field.turning, "-0.2")
  },
  async "turn-on-the-spot/door"(hands) {
    await hands.takesUp(simulate)
    await hands.writes(field.turning, "0.39")
  },
  async "round-the-box/right"(hands) {
    await hands.takesUp(simulate)
    await hands.writes(field.turning, "-0.3")
  },
  async "round-the-box/round"(hands) {
    await hands.takesUp(simulate)
    await hands.writes(field.turning, "0.2")
  },
  async "light-and-motion/colour"(hands) {
    await hands.takesUp(simulate)
    await hands.chooses(/colour: red$/, "orange")
  },
  async "light-and-motion/both"(hands) {
    await hands.takesUp(simulate)
    await hands.chooses(/colour: orange$/, "green")
    await hands.presses(/^run one more$/)
    await hands.puts("Led2")
    await hands.chooses(/colour: orange$/, "red", "last")
  },
  async "faster/top"(hands) {
    await hands.takesUp("definition of faster")
    await hands.writes(/number: 0.002$/, "0.02")
  },
  async "faster/back"(hands) {
    await hands.takesUp("definition of faster")
    await hands.chooses(field.operator, "-")
  },
  async "stop-in-time/near"(hands) {
    await hands.takesUp("definition of go")
    await hands.writes(/number: 1$/, "1.5")
  },
  async "stop-in-time/far"(hands) {
    await hands.takesUp("definition of go")
    await hands.writes(/number: 1.5$/, "2.1")
  },
}

const react: Recipes = {
  async "bump/tone"(hands) {
    await hands.takesUp("definition of bump")
    await hands.chooses(/^sound: error$/, "button")
  },
  async "bump/once"(hands) {
    await hands.takesUp("definition of bump")
    await hands.writes(field.type, "Bumper -> (Velocity, Maybe Sound)")
    await hands.throws(/^input 1, any thing/)
    await hands.puts("bumper event")
    await hands.throws(/^part 2, Sound/)
    await hands.puts("just:", "Sound: play")
    await hands.presses(/^one more case$/)
    await hands.puts("any, whatever", "several at once")
    await velocity(hands, "-0.3")
    await hands.puts("nothing: no value")
  },
  async "which-side/left"(hands) {
    await hands.takesUp("definition of light")
    await hands.throws(/^Bumper: side, any side/)
    await hands.puts("left bumper")
  },
  async "which-side/both"(hands) {
    await hands.starts("when the bumper is pressed")
    await hands.writes(field.name, "right")
    await hands.throws(/^Bumper: side, any side/)
    await hands.puts("left bumper")
    await hands.chooses(/^side: left$/, "right", "last")
    await hands.puts("just:", "Led2")
    await hands.presses(/^one more case$/)
    await hands.puts("any, whatever", "nothing: no value")
    await hands.takesUp(simulate)
    await hands.presses(/^run one more$/)
    await hands.puts("right")
  },
  async "two-wills/once"(hands) {
    await hands.takesUp("definition of go")
    await hands.writes(field.type, "RobotStatus -> Velocity")
    await hands.presses(/^one more input$/)
    await hands.puts("any, whatever")
    await hands.takesUp("definition of back")
    await hands.writes(field.speed, "-0.1")
  },
  async "remote-control/stop"(hands) {
    await hands.takesUp("definition of remote")
    await remoteButton(hands, "third", "0")
  },
  async "remote-control/three"(hands) {
    await hands.takesUp("definition of remote")
    await remoteButton(hands, "second", "0.5")
  },
  async "one-or-the-other/hole"(hands) {
    await hands.takesUp("definition of back")
    await hands.writes(field.type, "Cliff -> Velocity")
  },
  async "one-or-the-other/both"(hands) {
    await hands.takesUp("definition of back")
    await hands.writes(field.type, "Either Bumper Cliff -> Velocity")
  },
  async "lift-me/halt"(hands) {
    await hands.takesUp("definition of lift")
    await hands.writes(field.type, "Wheel -> (Led1, Velocity)")
    for (const [light, colour] of [
      [/^what to send, case 1, Led1/, "red"],
      [/^what to send, case 2, Led1/, "off"],
    ] as const) {
      await hands.throws(light)
      await hands.puts("several at once", "Led1")
      await hands.chooses(/colour: orange$/, colour, "last")
      await velocity(hands, "0")
    }
  },
  async "lift-me/safe"(hands) {
    await hands.takesUp("definition of lift")
    await hands.throws(/^what to send, case 2/)
    await hands.puts("several at once", "Led1")
    await hands.chooses(/colour: orange$/, "off", "last")
    await velocity(hands, "0.2")
  },
  async "stop-before-the-wall/near"(hands) {
    await hands.takesUp("definition of go")
    await hands.writes(/number: 1$/, "0.5")
  },
  async "stop-before-the-wall/slower"(hands) {
    await hands.takesUp("definition of go")
    await hands.throws(/number: 0.3$/)
    await hands.puts("minus", "distance", "0.5")
  },
}

/// The last case becomes one for another button; the rest follows below it.
async function remoteButton(hands: Hands, button: string, speed: string): Promise<void> {
  await hands.throws(/^input 1 of case \d, any thing/)
  await hands.puts("button event")
  await hands.chooses(/^button: first$/, button, "last")
  await hands.throws(/^what to send, case \d, nothing/)
  await hands.puts("just:")
  await velocity(hands, speed)
  await hands.presses(/^one more case$/)
  await hands.puts("any, whatever", "nothing: no value")
}

const remember: Recipes = {
  async "count-the-bumps/count"(hands) {
    await hands.starts("when the bumper is pressed")
    await hands.writes(field.name, "count")
    await hands.writes(field.type, "Bumper -> Memory Int -> Memory Int")
    await hands.presses(/^one more input$/)
    await hands.puts("what is remembered")
    await hands.writes(/name: m$/, "n", "last")
    await hands.puts("Memory:", "plus", "n", "1")
    await hands.presses(/^one more case$/)
    await hands.puts("any, whatever", "memory", "memory")
    await hands.takesUp("definition of say")
    await hands.writes(field.type, "Bumper -> Memory Int -> Maybe Say")
    await hands.presses(/^one more input$/)
    await hands.puts("what is remembered")
    await hands.writes(/name: m$/, "n", "last")
    await hands.throws(/^Say: text/)
    await hands.puts("show", "n", "any, whatever")
    await hands.takesUp(simulate)
    await hands.presses(/^run one more$/)
    await hands.puts("count")
  },
  async "there-and-back/back"(hands) {
    await hands.takesUp("definition of drive")
    await hands.throws(/^input 1, any thing/)
    await hands.puts("what is remembered")
    await hands.throws(/name: m$/, "last")
    await hands.puts("true false")
    await hands.writes(field.speed, "-0.3")
    await hands.presses(/^one more case$/)
    await hands.puts("any, whatever")
    await velocity(hands, "0.3")
  },
  async "a-mode-of-my-own/machine"(hands) {
    await hands.takesUp("type Mode")
    await hands.presses(/^one more case$/)
    await hands.writes(/name of case 3/, "Turn")
    await hands.takesUp("definition of next")
    await hands.throws(/^what to send, case 2/)
    await hands.puts("Memory:", "Turn")
    await hands.throws(/^input 1 of case 3/)
    await hands.puts("button event")
    await hands.throws(/input 2 of case 3, name/)
    await hands.puts("what is remembered")
    await hands.throws(/name: m$/, "last")
    await hands.puts("Turn")
    await hands.throws(/^what to send, case 3/)
    await hands.puts("Memory:", "Go")
    await hands.presses(/^one more case$/)
    await hands.puts("any, whatever", "mode", "mode")
    await hands.takesUp("definition of drive")
    await hands.presses(/^one more case$/)
    await hands.puts("what is remembered")
    await hands.throws(/name: m$/, "last")
    await hands.puts("Turn")
    await velocity(hands, "0", "0.5")
  },
  async "for-one-second/turn"(hands) {
    await hands.takesUp("definition of drive")
    await hands.presses(/^add a condition$/)
    await hands.puts("and &&", ">", "end", "0", "<", "now", "plus", "end", "2")
    await velocity(hands, "0", "0.8")
  },
  async "my-own-event/two-senders"(hands) {
    await hands.starts("when there is a hole")
    await hands.writes(field.name, "cliff")
    await hands.puts("just:", "Blocked")
    await hands.presses(/^one more case$/)
    await hands.puts("any, whatever", "nothing: no value")
    await hands.takesUp(simulate)
    await hands.presses(/^run one more$/)
    await hands.puts("cliff")
  },
  async "chance/clean"(hands) {
    await hands.takesUp("definition of bump")
    await hands.writes(field.type, "Bumper -> Seconds -> StdGen -> Memory Mode")
    await hands.presses(/^one more input$/)
    await hands.puts("gen")
    await hands.asks("Add own definitions")
    await hands.stacks("take a value apart", "where")
    await hands.takesUp("definition of several names")
    await hands.writes(/name: a$/, "time")
    await hands.writes(/name: b$/, "more")
    await hands.puts("a random number in a range")
    await hands.writes(/number: 0$/, "1", "last")
    await hands.throws(/^part 2, pi/, "last")
    await hands.puts("5", "gen")
    await hands.takesUp("definition of bump")
    await hands.throws(/number: 3.14$/)
    await hands.puts("number as seconds", "time")
  },
}

/// A new task without the step that is an example.
async function newTask(hands: Hands, name: string): Promise<void> {
  await hands.starts("a task of several steps")
  await hands.writes(field.name, name)
  await hands.throws(/one after the other, say/)
}

/// The program runs another task.
async function runsInstead(hands: Hands, before: string, task: string): Promise<void> {
  await hands.takesUp(simulate)
  await hands.throws(new RegExp(`^what to run, ${before}`))
  await hands.puts(task)
}

const tasks: Recipes = {
  async "a-recipe/there-back"(hands) {
    await hands.takesUp("definition of go")
    await hands.throws(/one after the other, drive/)
    await hands.stacks("drive 50", "do these steps")
    await hands.stacks("drive 50")
    await hands.writes(/number: 50$/, "-50", "last")
  },
  async "a-recipe/flag"(hands) {
    await hands.takesUp("definition of go")
    await hands.throws(/one after the other, drive/)
    await hands.throws(/one after the other, drive/)
    await hands.stacks("drive 50", "do these steps")
    await hands.writes(/number: 50$/, "100", "last")
    await hands.stacks("turn 90")
    await hands.stacks("drive 50")
    await hands.writes(/number: 50$/, "100", "last")
  },
  async "four-times/square"(hands) {
    await newTask(hands, "square")
    await hands.stacks("repeat a number of times", "do these steps")
    await hands.stacks("do one thing", "×")
    await hands.puts("side")
    await runsInstead(hands, "side", "square")
  },
  async "look-inside/then-back"(hands) {
    await newTask(hands, "go")
    await hands.stacks("do one thing", "do these steps")
    await hands.puts("untilBump")
    await hands.stacks("drive 50")
    await hands.writes(/number: 50$/, "-50", "last")
    await runsInstead(hands, "untilBump", "go")
  },
  async "a-task-that-answers/tell"(hands) {
    await hands.takesUp("definition of measure")
    await hands.throws(/^text, /)
    await hands.puts("show", "round", "distance")
  },
  async "at-the-same-time/give-up"(hands) {
    await runsInstead(hands, "go", "race")
    await hands.puts("do these steps")
    await hands.stacks("drive 50", "do these steps")
    await hands.writes(/number: 50$/, "500", "last")
    await hands.takesUp(simulate)
    await hands.puts("do these steps")
    await hands.stacks("wait", "do these steps")
    await hands.writes(/number: 1$/, "4", "last")
  },
  async "the-papers-robot/safe"(hands) {
    await hands.starts("when there is a hole")
    await hands.writes(field.name, "cliff")
    await hands.writes(field.type, "Cliff -> Maybe ChgDir")
    await hands.puts("just:", "ChgDir")
    await hands.presses(/^one more case$/)
    await hands.puts("any, whatever", "nothing: no value")
    await hands.takesUp("definition of spin")
    // It backs off while it turns.
    await hands.throws(/^what to send if condition 1/)
    await hands.puts("left:")
    await velocity(hands, "-0.1")
    await hands.throws(field.turning, "last")
    await hands.puts("speed")
    await hands.takesUp(simulate)
    await hands.presses(/^run one more$/)
    await hands.puts("cliff")
  },
}

export const recipes: Recipes = {...drive, ...react, ...remember, ...tasks}
