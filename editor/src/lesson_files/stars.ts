/// Stars of a challenge: a step each of whose checks is a star. The first is the goal: a run without it has none. Pure.
///
/// The progress of a learner holds an id for each star of the best run, as it holds the ids of the steps of a lesson.

import type {ChecksShown} from "../wire/page/programs.generated.ts"
import type {Check, Step} from "./lesson.ts"

/// What the service says about a run; `run` is `null` before the first.
type Judgement = Pick<ChecksShown, "run" | "over" | "checks">

/// The ids of so many stars, in the progress.
export const starIds = (count: number): readonly string[] =>
  Array.from({length: count}, (_, i) => `star-${i + 1}`)

export const hasStars = (step: Step): boolean => step.watched?.stars === true

/// How many stars a run has earned so far; 0 until its goal is reached.
export function earnedStars(step: Step, {run, over, checks}: Judgement): number {
  const isDone = ({id}: Check) => checks.some(one => one.id === id && one.state === "done")
  const [goal] = step.checks
  if (run === null || !over || goal === undefined || !isDone(goal)) return 0
  return step.checks.filter(isDone).length
}

/// What a run lacks for one more star; `null` when it has them all.
export function nextStar(step: Step, {checks}: Judgement): Check | null {
  return step.checks.find(({id}) => checks.find(one => one.id === id)?.state !== "done") ?? null
}
