/// Note about a preview: a line over the room with the differences, and a sentence for screen readers once the learner pauses.

import type {VNode} from "preact"
import {useEffect, useState} from "preact/hooks"
import {lacksPreview} from "../../reducers/preview_requests.ts"
import {usePageState} from "../../ui/app_context.ts"
import {measures, words} from "../../words/index.ts"
import {type Comparison, compare} from "./comparison.ts"
import {previewSentence} from "./sentence.ts"

/// Milliseconds without a newer preview before it is read aloud: numbers that are dragged change ten times a second.
const calm = 700

export function PreviewNote(): VNode {
  // A text, so that the note is drawn again only when it says something else.
  const told = usePageState(s => JSON.stringify(compare(s)))
  const comparison = JSON.parse(told) as Comparison | null
  const unrepeatable = usePageState(s => s.room.preview.answer?.unrepeatable === true)
  const isShared = usePageState(lacksPreview)
  const sentence = isShared
    ? words.companions.noPreview
    : unrepeatable
      ? words.preview.unrepeatable
      : comparison === null
        ? ""
        : previewSentence(comparison, words.preview, measures)
  const isPlain = isShared || unrepeatable
  const [spoken, speak] = useState("")
  useEffect(() => {
    const timer = setTimeout(() => speak(sentence), sentence === "" ? 0 : calm)
    return () => clearTimeout(timer)
  }, [sentence])
  return (
    <>
      {sentence !== "" && (
        <p
          class={isPlain || comparison?.current === true ? "preview-note" : "preview-note old"}
          aria-hidden="true"
          data-testid="preview"
        >
          {!isPlain && <span class="preview-line" />}
          {sentence}
        </p>
      )}
      <p class="hidden-text" aria-live="polite" data-testid="preview-spoken">
        {spoken}
      </p>
    </>
  )
}
