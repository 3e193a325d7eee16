/// Forms for the checks of a draft's step: what pupils read, the arguments, the hints.

import type {VNode} from "preact"
import {type CheckKind, checkKinds} from "../lessons/lesson_file.ts"
import {words} from "../words/index.ts"
import {ArgumentField} from "./argument_field.tsx"
import {initialArguments, specsOf} from "./check_arguments.ts"
import {
  type DraftCheck,
  type DraftStep,
  mostChecks,
  replaced,
  withCheck,
  withHint,
  withText,
} from "./draft.ts"
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
        <Check key={check.id} at={at} check={check} place={i + 1} />
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

function Check(props: {readonly at: number; readonly check: DraftCheck; readonly place: number}): VNode {
  const {at, check, place} = props
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
