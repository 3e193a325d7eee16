/// List of the challenges, each with the stars of the best run.

import type {VNode} from "preact"
import type {LessonEntry} from "../../lesson_files/lesson.ts"
import {useController, usePageState} from "../../ui/app_context.ts"
import {TextWithCode} from "../../ui/controls.tsx"
import {words} from "../../words/index.ts"
import {StarRow} from "./star_row.tsx"

export function ChallengeList(): VNode {
  const controller = useController()
  const list = usePageState(s => s.lessons.challenges)
  if (list.kind === "failed")
    return (
      <p>
        {words.challenges.failed}{" "}
        <button type="button" class="link" onClick={() => controller.openChallenges()}>
          {words.again}
        </button>
      </p>
    )
  if (list.kind !== "there") return <p class="quiet late">{words.challenges.loading}</p>
  return (
    <ol class="cards lessons">
      {list.lessons.map(challenge => (
        <ChallengeCard key={challenge.name} challenge={challenge} />
      ))}
    </ol>
  )
}

function ChallengeCard({challenge}: {challenge: LessonEntry}): VNode {
  const controller = useController()
  const {name, number, title, idea, steps} = challenge
  const done = usePageState(s => s.lessons.progress[name]) ?? []
  const current = usePageState(s => s.lessons.open?.lesson.name === name)
  const earned = steps.filter(star => done.includes(star)).length
  return (
    <li class={`card ${earned === steps.length ? "finished" : ""}`} aria-current={current}>
      <button type="button" class="opens" onClick={() => controller.openLesson(name)}>
        <b>
          {number}. {title}
        </b>
        <span>
          <TextWithCode text={idea} strong={null} />
        </span>
        <StarRow earned={earned} all={steps.length} />
      </button>
    </li>
  )
}
