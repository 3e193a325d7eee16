/// How programs of the examples are put together from an empty page, block by block, with any kind of input.

import type {Hands} from "./hands.ts"

const field = {
  name: /^Edit name of the definition/,
  type: /^Edit type of/,
  x: /name: x$/,
  m: /name: m$/,
  just: /^just/,
  typeName: /^Edit name of the type/,
  operator: /^operator/,
  speed: /speed, metres a second, number/,
  turning: /turning, radians a second, number/,
}

/// A function's name, type and number of inputs, before anybody says what it does.
async function begin(hands: Hands, name: string, type: string, inputs: number): Promise<void> {
  await hands.starts(inputs === 0 ? "constant" : "function with an input")
  await hands.writes(field.name, name)
  await hands.writes(field.type, type)
  await hands.throws(inputs === 0 ? /number: 0.5$/ : field.x)
  if (inputs > 1) await hands.presses(/^one more input$/, inputs - 1)
}

export async function drawSquare(hands: Hands): Promise<void> {
  await hands.begins()
  await declareSquare(hands)
  await fillSquare(hands)
  await fillTurn(hands)
}

/// Types and signatures of the square.
async function declareSquare(hands: Hands): Promise<void> {
  await hands.starts("another name for a type")
  await hands.writes(/new name/, "Side")
  await hands.writes(/type: Bool/, "Either Degrees Degrees")
  await hands.remarks("Degrees to the left, or to the right.")

  await hands.starts("own type with cases, data")
  await hands.writes(field.typeName, "Direction")
  await hands.writes(/name of case 1/, "Forward")
  await hands.presses(/one more part of Forward/)
  await hands.writes(/type of part 1 of Forward/, "Centimeters")
  await hands.writes(/name of case 2/, "Backward")
  await hands.presses(/one more part of Backward/)
  await hands.writes(/type of part 1 of Backward/, "Centimeters")

  await hands.starts("a task of several steps")
  await hands.writes(field.name, "drawSquare")
  await begin(hands, "move", "Direction -> Task ()", 1)
  await begin(hands, "drive", "Double -> Centimeters -> Task ()", 2)
  await begin(hands, "startMove", "Position -> Memory Position", 0)
  await begin(
    hands,
    "runMove",
    "Double -> Centimeters -> Memory Position -> Position -> Either Velocity (Done ())",
    4,
  )
  await begin(hands, "gone", "Position -> Position -> Meters", 2)
  await hands.remarks("How far it is from one place to another, in metres.")
  await begin(hands, "turn", "Side -> Task ()", 1)
  await begin(hands, "startTurn", "Side -> Orientation -> Memory Orientation", 2)
  await begin(hands, "runTurn", "Memory Orientation -> Orientation -> Either Velocity (Done ())", 2)
}

/// What the square, a move and its parts do.
async function fillSquare(hands: Hands): Promise<void> {
  await hands.takesUp("definition of drawSquare")
  await hands.throws(/one after the other, say/)
  await hands.stacks("repeat a number of times", "do these steps")
  await hands.stacks("do one thing", "×")
  await hands.puts("move", "Forward", "50")
  await hands.stacks("do one thing")
  await hands.puts("turn", "left:", "90")

  await hands.takesUp("definition of move")
  await hands.presses(/^one more case$/)
  await hands.puts("Forward", "distance", "drive", "0.2", "distance")
  await hands.puts("Backward", "distance", "drive", "-0.2", "distance")

  await hands.takesUp("definition of drive")
  await hands.puts("speed", "distance", "task:", "startMove")
  await hands.presses(/one input less/, 1, "last")
  await hands.puts("runMove")
  await hands.presses(/one input less/, 2, "last")
  await hands.puts("speed", "distance")

  await hands.takesUp("definition of startMove")
  await hands.puts("Memory as a function")

  await hands.takesUp("definition of runMove")
  await hands.presses(/^add a condition$/)
  await hands.puts("speed", "distance", "what is remembered")
  await hands.writes(field.m, "start", "last")
  await hands.puts("here", "<", "gone", "start", "here", "centimetres as metres")
  await hands.throws(/number: 50$/, "last")
  await hands.puts("distance", "left:", "velocity:")
  await hands.throws(field.speed, "last")
  await hands.puts("speed", "right:", "Done:")

  await hands.takesUp("definition of gone")
  await hands.puts("start", "here", "magnitudeVec", "add or subtract arrows")
  await hands.chooses(field.operator, "subVec", "last")
  await hands.puts("positionToVec", "here", "positionToVec", "start")
}

/// What a turn and its parts do.
async function fillTurn(hands: Hands): Promise<void> {
  await hands.takesUp("definition of turn")
  await hands.puts("side", "task:", "startTurn")
  await hands.presses(/one input less/, 1, "last")
  await hands.puts("side", "runTurn")
  await hands.presses(/one input less/, 2, "last")

  await hands.takesUp("definition of startTurn")
  await hands.presses(/^one more case$/)
  for (const [pattern, operator] of [
    ["left pattern", "plus"],
    ["right pattern", "minus"],
  ] as const) {
    await hands.puts(pattern)
    await hands.writes(field.x, "angle", "last")
    await hands.puts("here", "Memory:", operator, "here", "degrees as an orientation")
    await hands.throws(/number: 90$/, "last")
    await hands.puts("angle")
  }

  await hands.takesUp("definition of runTurn")
  await hands.presses(/^add a condition$/, 2)
  await hands.puts("what is remembered")
  await hands.writes(field.m, "goal", "last")
  await hands.puts("here")
  await hands.asks("Add own definitions")
  await hands.stacks("constant", "where")
  await hands.writes(field.name, "rest", "last")
  await hands.takesUp("definition of rest")
  await hands.throws(/number: 0.5$/)
  await hands.puts("shortest turn", "minus", "goal", "here")
  await hands.takesUp("definition of runTurn")
  await hands.puts("<", "abs", "rest", "0.02", "right:", "Done:")
  await hands.puts(">", "rest", "0", "left:", "velocity:")
  await hands.writes(field.speed, "0", "last")
  await hands.writes(field.turning, "0.5", "last")
  await hands.puts("left:", "velocity:")
  await hands.writes(field.speed, "0", "last")
  await hands.writes(field.turning, "-0.5", "last")
}

/// A type with one constructor of the same name.
async function single(hands: Hands, name: string, part?: string): Promise<void> {
  await hands.starts("own type with cases, data")
  await hands.writes(field.typeName, name)
  await hands.presses(/^remove the last case$/)
  await hands.writes(/name of case 1/, name)
  if (part === undefined) return
  await hands.presses(new RegExp(`one more part of ${name}$`))
  await hands.writes(new RegExp(`type of part 1 of ${name}`), part)
  await hands.asks("Make it a newtype")
}

export async function mux(hands: Hands): Promise<void> {
  await hands.begins()

  await single(hands, "M1", "a")
  await hands.asks("Add a parameter")
  await hands.remarks("Messages of the first kind are more important than those of the second.")
  await single(hands, "M2", "a")
  await hands.asks("Add a parameter")
  await single(hands, "M", "Seconds")
  await hands.remarks("Until then, only important messages pass.")

  await begin(hands, "mux", "Seconds -> Memory M -> Either (M1 a) (M2 a) -> Maybe (a, Memory M)", 3)
  await hands.presses(/^one more case$/)
  await hands.presses(/^add a condition, case 2$/)
  await hands.puts("now", "any, whatever", "left pattern")
  await hands.throws(field.x, "last")
  await hands.puts("M1", "message")
  await hands.puts("just:", "several at once", "message", "Memory:", "M", "plus", "now", "1")
  await hands.puts("now", "what is remembered")
  await hands.throws(field.m, "last")
  await hands.puts("M", "end", "right pattern")
  await hands.throws(field.x, "last")
  await hands.puts("M2", "message", ">", "now", "end")
  await hands.puts("just:", "several at once", "message", "Memory:", "M", "end", "nothing: no value")

  const type = "Seconds -> Memory M -> Either (M1 Velocity) (M2 Velocity) -> Maybe (Velocity, Memory M)"
  await begin(hands, "muxVelocity", type, 0)
  await hands.puts("mux")

  await hands.starts("when a button is pressed")
  await hands.writes(field.name, "button")
  await answersAnew(hands)
  await hands.throws(/button: 0$/)
  await hands.puts("any, whatever", "just:", "M1", "velocity:")
  await hands.writes(field.speed, "0", "last")
  await hands.writes(field.turning, "1", "last")
  await hands.presses(/^one more case$/)
  await hands.puts("button event")
  await hands.throws(/button: 0$/, "last")
  await hands.chooses(/status: pressed$/, "released", "last")
  await hands.puts("any, whatever", "nothing: no value")

  await begin(hands, "circle", "Position -> M2 Velocity", 1)
  await hands.puts("any, whatever", "M2", "velocity:")
  await hands.writes(field.speed, "0.2", "last")
  await hands.writes(field.turning, "0.2", "last")

  // The reaction runs since it was made.
  await hands.takesUp("the program: simulate")
  await hands.presses(/^run one more$/, 2)
  await hands.puts("circle", "muxVelocity")
}

export async function randomWalk(hands: Hands): Promise<void> {
  await hands.begins()

  await hands.starts("own type with cases, data")
  await hands.presses(/^one more case$/)
  await hands.writes(/name of case 3/, "Turn")
  await hands.presses(/one more part of Turn/, 2)
  await hands.writes(/type of part 2 of Turn/, "Seconds")
  await hands.remarks("What the robot is doing. A turn has a speed and a time when it ends.")
  await single(hands, "ChgDir")
  await hands.remarks("Sent when something is in the way.")

  for (const [ready, name, light, again, status] of [
    ["when the bumper is pressed", "bumper", "Led1", "bumper event", ["pressed", "released"]],
    ["when there is a hole", "cliff", "Led2", "cliff event", ["hole", "floor"]],
  ] as const) {
    await hands.starts(ready)
    await hands.writes(field.name, name)
    await answersAnew(hands)
    await hands.puts("several at once", light, "just:", "ChgDir")
    await hands.presses(/^one more case$/)
    await hands.puts(again)
    await hands.chooses(new RegExp(`status: ${status[0]}$`), status[1], "last")
    await hands.puts("several at once", light)
    await hands.chooses(/colour: orange$/, "off", "last")
    await hands.puts("nothing: no value")
  }

  await hands.starts("when a wheel leaves the ground")
  await hands.writes(field.name, "wheel")
  await answersAnew(hands)
  for (const [colour, mode] of [
    ["red", "Stop"],
    ["off", "Go"],
  ] as const) {
    await hands.puts("three at once")
    for (const light of ["Led1", "Led2"]) {
      await hands.puts(light)
      await hands.chooses(/colour: orange$/, colour, "last")
    }
    await hands.puts("Memory:", mode)
    if (colour === "off") break
    await hands.presses(/^one more case$/)
    await hands.puts("wheel event")
    await hands.chooses(/status: in the air$/, "on the ground", "last")
  }

  await changeOfDirection(hands)

  await begin(hands, "spin", "Memory Mode -> Seconds -> Either Velocity (Memory Mode)", 2)
  await hands.presses(/^one more case$/, 2)
  await hands.presses(/^add a condition, case 3$/)
  for (const mode of ["Go", "Stop"]) {
    await hands.puts("what is remembered")
    await hands.throws(field.m, "last")
    await hands.puts(mode, "any, whatever", "left:", "velocity:")
    if (mode === "Stop") await hands.writes(field.speed, "0", "last")
  }
  await hands.puts("what is remembered")
  await hands.throws(field.m, "last")
  await hands.puts("Turn", "speed", "end", "now", "<", "now", "end", "left:", "velocity:")
  await hands.writes(field.speed, "0", "last")
  await hands.throws(field.turning, "last")
  await hands.puts("speed", "right:", "Memory:", "Go")

  // The three reactions run since they were made.
  await hands.takesUp("the program: simulate")
  await hands.presses(/^run one more$/, 2)
  await hands.puts("chgdir", "spin")
}

/// Empties a ready function that answers one input only: it is to answer the others as well.
async function answersAnew(hands: Hands): Promise<void> {
  await hands.presses(/^remove the last case$/)
  await hands.throws(field.just)
}

/// Turns a random walk after it has hit something.
async function changeOfDirection(hands: Hands): Promise<void> {
  await begin(hands, "chgdir", "ChgDir -> StdGen -> Seconds -> Memory Mode", 3)
  await hands.remarks("Picks an angle up to half a turn, and a side.")
  await hands.puts("ChgDir", "gen", "now")
  await hands.asks("Add own definitions")
  await hands.stacks("take a value apart", "where")
  await hands.takesUp("definition of several names")
  await hands.writes(/name: a$/, "angle")
  await hands.writes(/name: b$/, "more")
  await hands.puts("a random number in a range", "gen")
  await hands.stacks("take a value apart")
  await hands.takesUp("definition of several names")
  await hands.writes(/name: a$/, "left")
  await hands.throws(/name: b$/)
  await hands.puts("any, whatever", "a random value", "more")
  await hands.stacks("constant")
  await hands.takesUp("definition of speed")
  await hands.throws(/number: 0.5$/)
  await hands.puts("if then else", "left", "1", "-1")
  await hands.takesUp("definition of chgdir")
  await hands.puts("Memory:", "Turn", "speed", "plus", "now", "number as seconds", "angle")
}
