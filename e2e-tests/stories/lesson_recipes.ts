/// How each step of the lessons that `every-lesson.spec.ts` follows in blocks is built, from the program that the step before it left: with any kind
/// of input (`hands.ts`). Several solutions are right; these are short ones.

import type {Hands} from "./hands.ts"

/// By lesson and step: `hello-robot/back`.
export type Recipes = {readonly [step: string]: (hands: Hands) => Promise<void>}

const field = {
  speed: /speed, metres a second, number/,
}

const simulate = "the program: simulate"

export const recipes: Recipes = {
  async "hello-robot/back"(hands) {
    await hands.takesUp(simulate)
    await hands.writes(field.speed, "-0.2")
  },
  async "hello-robot/ring"(hands) {
    await hands.takesUp(simulate)
    await hands.writes(field.speed, "0.4")
  },
}
