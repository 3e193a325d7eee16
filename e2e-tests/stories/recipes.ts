/// How programs of the examples are put together from an empty page, block by block, whoever's hands do it.

import type {Hands} from "./hands.ts"

const field = {
  name: /^Edit name of the definition/,
  type: /^Edit type of/,
  x: /name: x$/,
  m: /name: m$/,
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

  await hands.takesUp("definition of drawSquare")
  await hands.throws(/one after the other, say/)
  await hands.stacks("repeat a number of times", "do these steps")
  await hands.stacks("do one thing", "times")
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

  await hands.takesUp("the program: simulate")
  await hands.puts("drawSquare")
}
