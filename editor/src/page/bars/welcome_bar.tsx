/// Welcome bar of a first visit: four ways to begin, each in one sentence; while the demonstration is shown, what it shows; after the first run an
/// invitation to change something.

import type {VNode} from "preact"
import {isActive} from "../../state/runs/run_state.ts"
import {useController, usePageState} from "../../ui/app_context.ts"
import {CloseIcon} from "../../ui/icons.tsx"
import {words} from "../../words/index.ts"

/// The first lesson of the first course.
const firstLesson = "hello-robot"

export function WelcomeBar(): VNode | null {
  const controller = useController()
  const step = usePageState(s => s.demonstration)
  const isAsking = usePageState(s => s.welcoming && !s.embedded)
  const {title, show, lesson, example, empty, steps, stop} = words.welcome
  if (step !== null)
    return (
      <section class="welcome" aria-label={show.name}>
        <p aria-live="polite" data-testid="demonstration">
          {steps[step]}
        </p>
        <button type="button" class="plain" onClick={controller.demonstrate}>
          {stop}
        </button>
      </section>
    )
  if (!isAsking) return <Invitation />
  const choices = [
    {...show, choose: () => controller.demonstrate()},
    {...lesson, choose: () => controller.openLesson(firstLesson)},
    {...example, choose: () => controller.openGallery()},
    {...empty, choose: () => controller.newProgram()},
  ]
  return (
    <section class="welcome" aria-label={title}>
      <h2>{title}</h2>
      <ul>
        {choices.map(({name, description, choose}) => (
          <li key={name}>
            <button type="button" onClick={choose}>
              <b>{name}</b>
              <span>{description}</span>
            </button>
          </li>
        ))}
      </ul>
      <button
        type="button"
        class="plain icon"
        aria-label={words.close}
        onClick={() => controller.store.dispatch({kind: "welcoming", welcoming: false})}
      >
        <CloseIcon />
      </button>
    </section>
  )
}

/// Invitation after the first run of a new learner, until the next one: what to try next.
function Invitation(): VNode | null {
  const {change, from, to, into, after} = words.invite
  const isShown = usePageState(
    s =>
      s.welcome === "ran" &&
      s.room.goals.length === 0 &&
      (isActive(s.run) || s.run.kind === "ended") &&
      s.room.source?.includes(` ${from} `) === true,
  )
  if (!isShown) return null
  return (
    <section class="welcome" aria-label={words.run}>
      <p aria-live="polite">
        {change} <code>{from}</code> {to} <code>{into}</code> {after}
      </p>
    </section>
  )
}
