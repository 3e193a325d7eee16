/// Panel of the lesson editor, in the place of the lesson: texts, room and programs, blocks, steps, and the ways out.

import type {VNode} from "preact"
import {useEffect, useState} from "preact/hooks"
import {languagesOf} from "../../lesson_files/draft_file.ts"
import {type DraftMistake, mistakesOf} from "../../lesson_files/draft_mistakes.ts"
import {editedDraft} from "../../state/lesson_state.ts"
import {useController, usePageState} from "../../ui/app_context.ts"
import {IconButton} from "../../ui/controls.tsx"
import {Copied} from "../../ui/copied.tsx"
import {CloseIcon} from "../../ui/icons.tsx"
import {RehearsalReport} from "../../ui/rehearsal_report.tsx"
import {words} from "../../words/index.ts"
import {languages} from "../../words/language_choice.ts"
import {BlockChoice} from "./block_choice_form.tsx"
import {Choice, DraftText} from "./draft_fields.tsx"
import {DraftContext, useEditedDraft} from "./edited_draft.ts"
import {Materials} from "./material_form.tsx"
import {StepList} from "./step_form.tsx"

export function LessonEditorPanel(): VNode | null {
  const {lessonEditor} = useController()
  const draft = usePageState(s => editedDraft(s.lessons))
  if (draft === null) return null
  return (
    <DraftContext.Provider value={draft}>
      <aside class="lesson lesson-editor" aria-label={words.lessonEditor.panel} key={draft.name}>
        <header>
          <h2>{words.lessonEditor.write}</h2>
          <IconButton label={words.lessonEditor.close} onClick={lessonEditor.close}>
            <CloseIcon />
          </IconButton>
        </header>
        <Texts />
        <Materials />
        <BlockChoice />
        <StepList />
        <Finish />
      </aside>
    </DraftContext.Provider>
  )
}

export const languageName = (tag: string): string =>
  Object.entries(languages).find(([language]) => language === tag)?.[1] ?? tag

function Texts(): VNode {
  const {lessonEditor} = useController()
  const draft = useEditedDraft()
  const tags = [...new Set([...Object.keys(languages), draft.language, ...languagesOf(draft)])]
  const w = words.lessonEditor
  return (
    <>
      <Choice
        label={w.language}
        value={draft.language}
        options={tags.map(tag => [tag, languageName(tag)])}
        set={language => lessonEditor.edit({kind: "language", language})}
      />
      {(["title", "idea", "learned"] as const).map(field => (
        <DraftText
          key={field}
          label={w[field]}
          texts={draft[field]}
          set={text => lessonEditor.edit({kind: "said", field, text})}
        />
      ))}
    </>
  )
}

function Finish(): VNode {
  const {lessonEditor} = useController()
  const draft = useEditedDraft()
  const mistakes = mistakesOf(draft)
  const w = words.lessonEditor
  const isReady = mistakes.length === 0
  return (
    <section class="draft-finish">
      <div aria-live="polite">
        {!isReady && (
          <>
            <h3>{w.missing}</h3>
            <ul class="draft-mistakes">
              {mistakes.map(mistake => (
                <li key={JSON.stringify(mistake)}>{mistakeText(mistake)}</li>
              ))}
            </ul>
          </>
        )}
      </div>
      <button type="button" class="go" disabled={!isReady} onClick={lessonEditor.tryOut}>
        {w.tryOut}
      </button>
      {isReady && <RehearsalReport draft={draft} />}
      <button type="button" class="plain" disabled={!isReady} onClick={lessonEditor.save}>
        {w.save}
      </button>
      {isReady && <PupilLink />}
    </section>
  )
}

function PupilLink(): VNode | null {
  const {lessonEditor} = useController()
  const draft = useEditedDraft()
  const [address, setAddress] = useState<string | null>(null)
  // Another draft has another link.
  useEffect(() => {
    let isCurrent = true
    void lessonEditor.link(draft).then(link => isCurrent && setAddress(link))
    return () => {
      isCurrent = false
    }
  }, [lessonEditor, draft])
  return address === null ? null : <Copied label={words.lessonEditor.link} text={address} />
}

function mistakeText(mistake: DraftMistake): string {
  const w = words.lessonEditor.mistakes
  switch (mistake.kind) {
    case "no-title":
      return w[mistake.kind](languageName(mistake.language))
    case "no-steps":
      return w[mistake.kind]
    case "no-step-text":
      return w[mistake.kind](mistake.step, languageName(mistake.language))
    case "few-answers":
    case "no-right":
    case "no-checks":
      return w[mistake.kind](mistake.step)
    case "no-answer-text":
      return w[mistake.kind](mistake.step, mistake.answer, languageName(mistake.language))
    case "no-check-text":
      return w[mistake.kind](mistake.step, mistake.check, languageName(mistake.language))
    case "no-place":
    case "empty-check":
      return w[mistake.kind](mistake.step, mistake.check)
  }
}
