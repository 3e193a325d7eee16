/// Panel of the open lesson: its steps, the question or the checks of the shown step, hints, and the way on.

import type {VNode} from "preact"
import {useEffect, useMemo, useState} from "preact/hooks"
import {guidePageOfCourse} from "../../help/guide_links.ts"
import type {Lesson, Step} from "../../lesson_files/lesson.ts"
import {seenText} from "../../lesson_files/seen_text.ts"
import {hasStars} from "../../lesson_files/stars.ts"
import {currentStep, editedDraft, isDone, type OpenLesson, shownHints} from "../../state/lesson_state.ts"
import {compiled} from "../../state/visible_findings.ts"
import {useController, usePageState} from "../../ui/app_context.ts"
import {IconButton, TextWithCode} from "../../ui/controls.tsx"
import {CloseIcon} from "../../ui/icons.tsx"
import {RehearsalReport} from "../../ui/rehearsal_report.tsx"
import type {Verdict} from "../../wire/verdict.generated.ts"
import {words} from "../../words/index.ts"
import {type Hint, hintedChecks, hintsOf} from "./hints.ts"
import {StarResult} from "./star_result.tsx"

export function LessonPanel(): VNode | null {
  const controller = useController()
  const open = usePageState(s => s.lessons.open)
  const isTrial = usePageState(s => s.lessons.writing?.mode === "trying")
  if (open === null) return null
  const {lesson} = open
  const more = guidePageOfCourse(lesson.course)
  const kind = isChallenge(lesson) ? words.challenges : words.lessons
  return (
    <aside class="lesson" aria-label={words.lessons.panel}>
      {isTrial && <Trial />}
      <header>
        <p class="quiet">{lesson.number === null ? words.lessons.panel : kind.number(lesson.number)}</p>
        {!isTrial && (
          <IconButton label={kind.leave} onClick={() => controller.leaveLesson()}>
            <CloseIcon />
          </IconButton>
        )}
        <h2>{lesson.title}</h2>
        <p class="idea">
          <TextWithCode text={lesson.idea} strong={null} />
        </p>
      </header>
      <ol class="steps">
        {lesson.steps.map((step, i) => (
          <StepLine key={step.id} open={open} step={step} place={i} />
        ))}
      </ol>
      <WayOn open={open} />
      {more !== undefined && (
        <p>
          <a class="link" target="_blank" rel="noopener" href={more}>
            {words.guide.more}
          </a>
        </p>
      )}
      {lesson.file !== null && !isTrial && <LessonLink file={lesson.file} />}
    </aside>
  )
}

/// The way from a draft, as pupils see it, back to the editor.
function Trial(): VNode {
  const {lessonEditor} = useController()
  const draft = usePageState(s => editedDraft(s.lessons))
  const w = words.lessonEditor
  return (
    <div class="trial">
      <p class="quiet">{w.trial}</p>
      <button type="button" class="plain" onClick={lessonEditor.back}>
        {w.back}
      </button>
      {draft !== null && draft.solution !== null && (
        <button type="button" class="plain" onClick={lessonEditor.trySolution}>
          {w.trySolution}
        </button>
      )}
      {draft !== null && <RehearsalReport draft={draft} />}
    </div>
  )
}

/// The lesson as a link, to pass on.
function LessonLink({file}: {file: string}): VNode | null {
  const controller = useController()
  const [address, setAddress] = useState<string | null>(null)
  useEffect(() => {
    void controller.lessonLink(file).then(setAddress)
  }, [controller, file])
  if (address === null) return null
  return (
    <p>
      <a class="link" href={address}>
        {words.lessons.link}
      </a>{" "}
      <button type="button" class="link" onClick={() => controller.lessonEditor.openFile(file)}>
        {words.lessonEditor.change}
      </button>
    </p>
  )
}

function StepLine({open, step, place}: {open: OpenLesson; step: Step; place: number}): VNode {
  const controller = useController()
  const done = usePageState(s => isDone(s.lessons, step))
  const isCurrent = place === open.at
  return (
    <li
      class={`step ${done ? "done" : ""} ${isCurrent ? "now" : ""}`}
      aria-current={isCurrent ? "step" : undefined}
    >
      <button type="button" class="step-title" onClick={() => controller.goToStep(place)}>
        <span class="dot" aria-hidden="true">
          {done ? "✓" : place + 1}
        </span>
        <span>
          <b>{words.lessons.kinds[step.kind]}:</b> <TextWithCode text={step.say} strong={null} />
          {done && <span class="hidden-text"> ({words.lessons.done})</span>}
        </span>
      </button>
      {isCurrent && <StepBody open={open} step={step} done={done} />}
    </li>
  )
}

function StepBody({open, step, done}: {open: OpenLesson; step: Step; done: boolean}): VNode {
  return (
    <div class="step-body">
      {step.answers.length > 0 ? (
        <Question open={open} step={step} done={done} />
      ) : (
        <Checks open={open} step={step} />
      )}
      {done && step.after !== "" && (
        <p class="after">
          <TextWithCode text={step.after} strong={null} />
        </p>
      )}
      {hasStars(step) && <StarResult open={open} step={step} />}
      {step.checks.length > 0 && (!done || hasStars(step)) && <Hints open={open} step={step} />}
    </div>
  )
}

function Question({open, step, done}: {open: OpenLesson; step: Step; done: boolean}): VNode {
  const {store} = useController()
  const chosen = open.answers[step.id]
  const reply = step.answers.find(answer => answer.id === chosen)?.reply ?? ""
  return (
    <>
      <ul class="answers">
        {step.answers.map(answer => (
          <li key={answer.id}>
            <button
              type="button"
              class="plain"
              aria-pressed={answer.id === chosen}
              onClick={() => store.dispatch({kind: "lesson", event: {kind: "answered", answer: answer.id}})}
            >
              <TextWithCode text={answer.text} strong={null} />
            </button>
          </li>
        ))}
      </ul>
      <p class={`reply ${done && step.kind === "investigate" ? "right" : ""}`} aria-live="polite">
        <TextWithCode text={reply} strong={null} />
      </p>
    </>
  )
}

/// The guess of the step before, and the checks with what was seen.
function Checks({open, step}: {open: OpenLesson; step: Step}): VNode {
  const broken = usePageState(s => compiled(s).some(f => f.severity === "error"))
  const guess = guessBefore(open)
  const told = open.checks
  const hasRun = told !== null && told.run !== null
  const verdict = (id: string) => told?.checks.find(one => one.id === id) ?? null
  return (
    <>
      {step.kind === "run" && guess !== null && <p class="guess">{words.lessons.yourGuess(guess)}</p>}
      {step.checks.length > 0 && (
        <ul class="checks" aria-live="polite">
          {step.checks.map(check => (
            <CheckLine
              key={check.id}
              text={check.text}
              verdict={verdict(check.id)}
              hasRun={hasRun}
              marks={hasStars(step) ? stars : marks}
            />
          ))}
        </ul>
      )}
      {broken ? (
        <p class="note">{words.lessons.mendFirst}</p>
      ) : !hasRun ? (
        <p class="note">{step.kind === "run" ? "" : words.lessons.pressRun}</p>
      ) : told.passed ? null : (
        <LastRun seconds={step.watched?.seconds ?? 0} over={told.over} checks={told.checks} />
      )}
    </>
  )
}

function LastRun(props: {seconds: number; over: boolean; checks: readonly Verdict[]}): VNode | null {
  const isOpen = props.checks.length === 0 || props.checks.some(check => check.state === "open")
  return props.over && !isOpen ? null : <p class="note">{words.lessons.letItRun(props.seconds)}</p>
}

const marks = {done: "✓", missed: "✗", open: "·"} as const
const stars = {done: "★", missed: "☆", open: "☆"} as const

function CheckLine(props: {
  text: string
  verdict: Verdict | null
  hasRun: boolean
  marks: {readonly [state in Verdict["state"]]: string}
}): VNode {
  const {verdict, hasRun} = props
  // Before a run only what is done is known: nothing has been tried yet.
  const state = verdict === null || (!hasRun && verdict.state !== "done") ? "open" : verdict.state
  const seen = state === "missed" && verdict !== null ? verdict.seen : null
  return (
    <li class={`check ${state}`} data-check-state={state}>
      <span class="mark" aria-hidden="true">
        {props.marks[state]}
      </span>
      <span>
        <TextWithCode text={props.text} strong={null} />
        <span class="hidden-text"> ({words.lessons[state]})</span>
        {seen !== null && (
          <span class="seen">
            <TextWithCode text={seenText(seen)} strong={null} />
          </span>
        )}
      </span>
    </li>
  )
}

/// The hints about one check, one after the other.
function Hints({open, step}: {open: OpenLesson; step: Step}): VNode | null {
  const {store} = useController()
  const text = usePageState(s => s.document.program.text)
  const declared = usePageState(s => s.declared)
  const watched = useMemo(() => hintedChecks(step.watched?.checks ?? []), [step])
  const found = hintsOf(step.checks, open.checks, {text, declared}, watched)
  if (found === null) return null
  const {check, hints} = found
  const shown = hints.slice(0, shownHints(open, check))
  return (
    <div class="hints">
      <div aria-live="polite">
        {shown.map(hint => (
          <HintLine hint={hint} key={JSON.stringify(hint)} />
        ))}
      </div>
      {shown.length < hints.length && (
        <button
          type="button"
          class="link hint"
          // The button pulses once after a while without progress; progress makes it a new one.
          key={`${open.at} ${check} ${shown.length} ${open.checks?.checks.map(one => one.state).join()}`}
          onClick={() => store.dispatch({kind: "lesson", event: {kind: "hint-wanted", check}})}
        >
          {shown.length === 0 ? words.lessons.hint : words.lessons.moreHint}
        </button>
      )}
    </div>
  )
}

function HintLine({hint}: {hint: Hint}): VNode {
  if (hint.kind === "piece")
    return (
      <pre class="piece" dir="ltr">
        {hint.text}
      </pre>
    )
  return (
    <p>
      <TextWithCode text={hintText(hint)} strong={null} />
    </p>
  )
}

function hintText(hint: Hint): string {
  switch (hint.kind) {
    case "not-run":
      return words.lessons.notRun(hint.name)
    case "not-taken":
      return words.lessons.notTaken(hint.type)
    case "not-given":
      return words.lessons.notGiven(hint.type)
    case "text":
    case "piece":
      return hint.text
  }
}

function WayOn({open}: {open: OpenLesson}): VNode | null {
  const controller = useController()
  const step = currentStep(open)
  const done = usePageState(s => step !== undefined && isDone(s.lessons, step))
  const all = usePageState(s => open.lesson.steps.every(one => isDone(s.lessons, one)))
  const {lesson, at} = open
  const again = (
    <button type="button" class="link restart" onClick={() => controller.restartStep()}>
      {words.lessons.again}
    </button>
  )
  if (!done) return step?.watched != null ? again : null
  if (at + 1 < lesson.steps.length)
    return (
      <button type="button" class="go" onClick={() => controller.goToStep(at + 1)}>
        {words.lessons.go}
      </button>
    )
  const {next} = lesson
  const challenge = isChallenge(lesson)
  return (
    <div class="lesson-end">
      {challenge && again}
      {all && !challenge && (
        <>
          <h3>{words.lessons.wellDone}</h3>
          {lesson.learned !== "" && (
            <p>
              <b>{words.lessons.learned}:</b> <TextWithCode text={lesson.learned} strong={null} />
            </p>
          )}
        </>
      )}
      {next !== null && (
        <button type="button" class="go" onClick={() => controller.openLesson(next)}>
          {challenge ? words.challenges.nextChallenge : words.lessons.nextLesson}
        </button>
      )}
      <button type="button" class="plain" onClick={() => controller.leaveLesson()}>
        {words.lessons.freePlay}
      </button>
    </div>
  )
}

const isChallenge = ({steps}: Lesson): boolean => steps.some(hasStars)

function guessBefore({lesson, at, answers}: OpenLesson): string | null {
  const before = lesson.steps.slice(0, at).findLast(step => step.kind === "predict")
  return before?.answers.find(answer => answer.id === answers[before.id])?.text ?? null
}
