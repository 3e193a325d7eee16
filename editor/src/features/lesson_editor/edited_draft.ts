/// Access of the editor's components to the draft that is shown.

import {createContext} from "preact"
import {useContext} from "preact/hooks"
import type {DraftStep, LessonDraft} from "../../lesson_files/draft.ts"
import {useController} from "../../ui/app_context.ts"

export const DraftContext = createContext<LessonDraft | null>(null)

export function useEditedDraft(): LessonDraft {
  const draft = useContext(DraftContext)
  if (draft === null) throw new Error("expected a part of the lesson editor, found it elsewhere")
  return draft
}

/// Changes a step, as it is by then: two fields may change between two frames.
export type ChangeStep = (change: (step: DraftStep, draft: LessonDraft) => DraftStep) => void

export function useStepChange(at: number): ChangeStep {
  const {lessonEditor} = useController()
  return change => {
    const draft = lessonEditor.draft()
    const step = draft?.steps[at]
    if (draft !== null && step !== undefined)
      lessonEditor.edit({kind: "step-changed", at, step: change(step, draft)})
  }
}
