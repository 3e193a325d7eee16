/// Forms for the checks of a draft's step: what pupils read, the arguments, the hints.

import type {VNode} from "preact"
import {initialArguments, specsOf} from "../../lesson_files/check_arguments.ts"
import {
  type DraftCheck,
  type DraftStep,
  mostChecks,
  mostWrong,
  replaced,
  withCheck,
  withHint,
  withText,
  wrongCount,
} from "../../lesson_files/draft.ts"
import {type CheckKind, checkKinds} from "../../lesson_files/lesson_file.ts"
import {useController} from "../../ui/app_context.ts"
import {words} from "../../words/index.ts"
import {ArgumentField} from "./argument_field.tsx"
import {Choice, DraftText} from "./draft_fields.tsx"
import {useStepChange} from "./edited_draft.ts"

interface Props {
  readonly step: DraftStep
  /// The place of the step, from 0.
  readonly at: number
}

export function CheckList({step, at}: Props): VNode {
  const change = useStepChange(at)
  const w = words.lessonEditor
  const kinds = checkKinds.map(kind => [kind, w.checks[kind]] as const)
  const add = (kind: CheckKind) => change((one, draft) => withCheck(draft, one, kind, initialArguments(kind)))
  return (
    <>
      {step.checks.map((check, i) => (
        <Check key={check.id} step={step} at={at} check={check} place={i + 1} />
      ))}
      {step.checks.length < mostChecks && (
        <Choice
          label={w.addCheck}
          value=""
          options={[["", "…"], ...kinds]}
          set={kind => kind !== "" && add(kind)}
        />
      )}
    </>
  )
}

const hintNames = ["question", "pointer", "piece"] as const

interface CheckProps extends Props {
  readonly check: DraftCheck
  /// Its place, from 1.
  readonly place: number
}

function Check(props: CheckProps): VNode {
  const {step, at, check, place} = props
  const change = useStepChange(at)
  const w = words.lessonEditor
  const set = (by: (old: DraftCheck, language: string) => DraftCheck) =>
    change((one, draft) => ({
      ...one,
      checks: replaced(one.checks, check.id, old => by(old, draft.language)),
    }))
  return (
    <fieldset class="draft-part">
      <legend>
        {w.check(place)}: {w.checks[check.kind]}
      </legend>
      {specsOf(check.kind).map(([name, spec]) => (
        <ArgumentField
          key={name}
          label={w.arguments[name]}
          spec={spec}
          value={check.arguments[name]}
          set={value =>
            set(old => {
              const {[name]: _, ...others} = old.arguments
              return {...old, arguments: value === undefined ? others : {...others, [name]: value}}
            })
          }
        />
      ))}
      <DraftText
        label={w.checkText}
        texts={check.text}
        set={text => set((old, language) => ({...old, text: withText(old.text, language, text)}))}
      />
      {hintNames.map((hint, i) => (
        <DraftText
          key={hint}
          label={w.hints[hint]}
          texts={check.hints[i] ?? {}}
          set={text => set((old, language) => withHint(old, i, language, text))}
        />
      ))}
      <WrongAttempts
        check={check}
        isFull={wrongCount(step) >= mostWrong}
        name={`${w.check(place)}: ${w.addWrong}`}
        set={by => set(old => ({...old, wrong: by(old.wrong)}))}
      />
      <button
        type="button"
        class="link"
        onClick={() => change(one => ({...one, checks: one.checks.filter(other => other.id !== check.id)}))}
      >
        {w.removeCheck(place)}
      </button>
    </fieldset>
  )
}

interface WrongProps {
  readonly check: DraftCheck
  readonly isFull: boolean
  /// Of the button that adds one.
  readonly name: string
  readonly set: (by: (wrong: readonly string[]) => readonly string[]) => void
}

/// Programs that fail the check; the rehearsal of the lesson makes sure of it.
function WrongAttempts({check, isFull, name, set}: WrongProps): VNode {
  const {lessonEditor} = useController()
  const w = words.lessonEditor
  return (
    <>
      {check.wrong.map((program, i) => (
        // By their place: two attempts may be the same text.
        <div class="draft-buttons" key={i}>
          <span>{w.wrong(i + 1)}</span>
          <button
            type="button"
            class="plain"
            aria-label={`${w.wrong(i + 1)}: ${w.showStart}`}
            onClick={() => lessonEditor.show(program)}
          >
            {w.showStart}
          </button>
          <button
            type="button"
            class="link"
            onClick={() => set(wrong => wrong.filter((_, place) => place !== i))}
          >
            {w.removeWrong(i + 1)}
          </button>
        </div>
      ))}
      {!isFull && (
        <button
          type="button"
          class="plain"
          aria-label={name}
          onClick={() => {
            const program = lessonEditor.program()
            set(wrong => [...wrong, program])
          }}
        >
          {w.addWrong}
        </button>
      )}
    </>
  )
}
