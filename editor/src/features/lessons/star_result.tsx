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
  const told = open.checks
  const w = words.challenges
  const isOver = told !== null && told.run !== null && told.over
  const earned = isOver ? earnedStars(step, told) : 0
  const next = isOver ? nextStar(step, told) : null
  return (
    <div class="star-result">
      <p>
        {w.best} <StarRow earned={best} all={all} />
      </p>
      <p aria-live="polite" data-testid="star-result">
        {isOver && (
          <>
            <b>{w.thisRun(earned, all)}</b>{" "}
            {next === null ? w.allStars : <TextWithCode text={w.next(next.text)} strong={null} />}
          </>
        )}
      </p>
    </div>
  )
}
