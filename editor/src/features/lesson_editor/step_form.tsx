/// Forms for the steps of a draft: their order, kind, texts, answers or checks.

import type {VNode} from "preact"
import {useState} from "preact/hooks"
import {
  type DraftAnswer,
  type DraftStep,
  isQuestion,
  longestWatch,
  mostAnswers,
  mostSteps,
  replaced,
  withAnswer,
  withoutAnswer,
  withText,
} from "../../lesson_files/draft.ts"
import type {StepKind} from "../../lesson_files/lesson.ts"
import {useController} from "../../ui/app_context.ts"
import {words} from "../../words/index.ts"
import {CheckList} from "./check_form.tsx"
import {Choice, DraftText, NumberEntry} from "./draft_fields.tsx"
import {useEditedDraft, useStepChange} from "./edited_draft.ts"

const stepKinds: readonly StepKind[] = ["predict", "run", "investigate", "modify", "make"]

export function StepList(): VNode {
  const {lessonEditor} = useController()
  const {steps} = useEditedDraft()
  const w = words.lessonEditor
  return (
    <section>
      <h3>{w.steps}</h3>
      <ol class="draft-steps">
        {steps.map((step, i) => (
          <li key={step.id}>
            <Step step={step} at={i} count={steps.length} />
          </li>
        ))}
      </ol>
      {steps.length < mostSteps && (
        <div class="draft-buttons">
          <span class="quiet">{w.addStep}</span>
          {stepKinds.map(kind => (
            <button
              key={kind}
              type="button"
              class="plain"
              aria-label={`${w.addStep} ${words.lessons.kinds[kind]}`}
              onClick={() => lessonEditor.edit({kind: "step-added", step: kind})}
            >
              {words.lessons.kinds[kind]}
            </button>
          ))}
        </div>
      )}
    </section>
  )
}

interface StepProps {
  readonly step: DraftStep
  /// Its place, from 0.
  readonly at: number
}

function Step({step, at, count}: StepProps & {readonly count: number}): VNode {
  const {lessonEditor} = useController()
  const {language} = useEditedDraft()
  const change = useStepChange(at)
  const w = words.lessonEditor
  // A step that was just added is open; later the teacher decides.
  const [isOpen] = useState(Object.keys(step.say).length === 0)
  const move = (label: string, by: -1 | 1, sign: string) => (
    <button
      type="button"
      class="plain icon"
      aria-label={label}
      title={label}
      disabled={at + by < 0 || at + by >= count}
      onClick={() => lessonEditor.edit({kind: "step-moved", at, by})}
    >
      {sign}
    </button>
  )
  return (
    <details open={isOpen}>
      <summary>
        <b>
          {w.step(at + 1)}: {words.lessons.kinds[step.kind]}
        </b>{" "}
        <span class="quiet">{step.say[language] ?? ""}</span>
      </summary>
      <fieldset class="draft-body" aria-label={w.step(at + 1)}>
        <Choice
          label={w.kind}
          value={step.kind}
          options={stepKinds.map(kind => [kind, words.lessons.kinds[kind]])}
          set={kind =>
            change(one =>
              isQuestion(kind) && one.answers.length === 0
                ? withAnswer(withAnswer({...one, kind}))
                : {...one, kind},
            )
          }
        />
        <DraftText
          label={w.say}
          texts={step.say}
          set={text => change((one, draft) => ({...one, say: withText(one.say, draft.language, text)}))}
        />
        {isQuestion(step.kind) ? <Answers step={step} at={at} /> : <Watched step={step} at={at} />}
        <DraftText
          label={w.after}
          texts={step.after}
          set={text => change((one, draft) => ({...one, after: withText(one.after, draft.language, text)}))}
        />
        <ProgramOfStep step={step} at={at} />
        <div class="draft-buttons">
          {move(w.up(at + 1), -1, "↑")}
          {move(w.down(at + 1), 1, "↓")}
          <button type="button" class="plain" onClick={() => lessonEditor.edit({kind: "step-removed", at})}>
            {w.removeStep(at + 1)}
          </button>
        </div>
      </fieldset>
    </details>
  )
}

/// The program that the step begins with, in place of that of the step before.
function ProgramOfStep({step, at}: StepProps): VNode {
  const {lessonEditor} = useController()
  const change = useStepChange(at)
  const {program} = step
  const w = words.lessonEditor
  const take = () => {
    const own = lessonEditor.program()
    change(one => ({...one, program: own}))
  }
  return (
    <div class="draft-buttons">
      <label class="draft-option">
        <input
          type="checkbox"
          checked={program !== null}
          onChange={() => (program === null ? take() : change(one => ({...one, program: null})))}
        />
        <span>{w.programOfStep}</span>
      </label>
      {program !== null && (
        <>
          <button
            type="button"
            class="plain"
            aria-label={`${w.step(at + 1)}: ${w.showStart}`}
            onClick={() => lessonEditor.show(program)}
          >
            {w.showStart}
          </button>
          <button type="button" class="plain" aria-label={`${w.step(at + 1)}: ${w.useStart}`} onClick={take}>
            {w.useStart}
          </button>
        </>
      )}
    </div>
  )
}

function Watched({step, at}: StepProps): VNode {
  const change = useStepChange(at)
  return (
    <>
      <NumberEntry
        label={words.lessonEditor.seconds}
        unit="s"
        value={step.seconds}
        least={1}
        most={longestWatch}
        step={1}
        set={seconds => change(one => ({...one, seconds: seconds ?? one.seconds}))}
      />
      <CheckList step={step} at={at} />
    </>
  )
}

function Answers({step, at}: StepProps): VNode {
  const change = useStepChange(at)
  const w = words.lessonEditor
  return (
    <>
      {step.answers.map((answer, i) => (
        <Answer key={answer.id} step={step} at={at} answer={answer} place={i + 1} />
      ))}
      {step.answers.length < mostAnswers && (
        <div class="draft-buttons">
          <button type="button" class="plain" onClick={() => change(withAnswer)}>
            {w.addAnswer}
          </button>
        </div>
      )}
    </>
  )
}

function Answer(props: StepProps & {readonly answer: DraftAnswer; readonly place: number}): VNode {
  const {step, at, answer, place} = props
  const change = useStepChange(at)
  const w = words.lessonEditor
  const set = (field: "text" | "reply") => (text: string) =>
    change((one, draft) => ({
      ...one,
      answers: replaced(one.answers, answer.id, old => ({
        ...old,
        [field]: withText(old[field], draft.language, text),
      })),
    }))
  return (
    <div class="draft-part">
      <DraftText label={w.answer(place)} texts={answer.text} set={set("text")} />
      <DraftText label={w.reply(place)} texts={answer.reply} set={set("reply")} />
      <div class="draft-buttons">
        <label class="draft-option">
          <input
            type="radio"
            name={`right ${step.id}`}
            checked={step.right === answer.id}
            onChange={() => change(one => ({...one, right: answer.id}))}
          />
          <span>{w.right(place)}</span>
        </label>
        <button type="button" class="link" onClick={() => change(one => withoutAnswer(one, answer.id))}>
          {w.removeAnswer(place)}
        </button>
      </div>
    </div>
  )
}
