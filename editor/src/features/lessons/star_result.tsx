/// Result of a run in a challenge: its stars, what is missing for the next one, and the stars of the best run.

import type {VNode} from "preact"
import type {Step} from "../../lesson_files/lesson.ts"
import {earnedStars, nextStar, starIds} from "../../lesson_files/stars.ts"
import type {OpenLesson} from "../../state/lesson_state.ts"
import {usePageState} from "../../ui/app_context.ts"
import {TextWithCode} from "../../ui/controls.tsx"
import {words} from "../../words/index.ts"
import {StarRow} from "./star_row.tsx"

export function StarResult({open, step}: {open: OpenLesson; step: Step}): VNode {
  const done = usePageState(s => s.lessons.progress[open.lesson.name]) ?? []
  const all = step.checks.length
  const best = starIds(all).filter(star => done.includes(star)).length
  const result = open.checks
  const {challenges} = words
  const isOver = result !== null && result.run !== null && result.over
  const earned = isOver ? earnedStars(step, result) : 0
  const next = isOver ? nextStar(step, result) : null
  return (
    <div class="star-result">
      <p>
        {challenges.best} <StarRow earned={best} all={all} />
      </p>
      <p aria-live="polite" data-testid="star-result">
        {isOver && (
          <>
            <b>{challenges.thisRun(earned, all)}</b>{" "}
            {next === null ? (
              challenges.allStars
            ) : (
              <TextWithCode text={challenges.next(next.text)} strong={null} />
            )}
          </>
        )}
      </p>
    </div>
  )
}
