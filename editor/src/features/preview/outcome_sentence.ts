/// The outcome of a preview, in a short sentence.

import type {words as english} from "../../words/index.ts"
import type {Measures} from "../../words/number_formats.ts"
import type {Outcome} from "./outcome.ts"
import {distanceOf} from "./sentence.ts"

export function outcomeSentence(
  outcome: Outcome,
  {outcome: words}: (typeof english)["preview"],
  measures: Measures,
): string {
  const {goals, fails} = outcome
  const parts = [motion(outcome, words, measures)]
  if (fails !== null) parts.push(words.fails(measures.seconds(fails, 1)))
  if (goals > 0) parts.push(words.goals(goals))
  return parts.join(", ")
}

function motion(
  {bumps, distance, trembles, stands, sticks, onward}: Outcome,
  words: (typeof english)["preview"]["outcome"],
  measures: Measures,
): string {
  if (trembles) return words.trembles(bumps)
  if (stands) return words.stands
  if (bumps > 0) {
    const next = sticks ? words.stays : onward === null ? null : words.onward[onward]
    return next === null ? words.bumps(bumps) : `${words.bumps(bumps)}, ${next}`
  }
  return distance < 0.03 ? words.turns : words.drives(distanceOf(distance, measures))
}
