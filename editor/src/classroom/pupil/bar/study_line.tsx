/// Line of the class bar about the study in which the class takes part: what it is, whom to ask, and the pupil's answer, which can be changed.

import type {VNode} from "preact"
import {privacyPage} from "../../../help/help_links.ts"
import {words} from "../../../words/index.ts"

interface Props {
  readonly contact: string
  /// `null` without an answer.
  readonly takesPart: boolean | null
  readonly answer: (agrees: boolean) => void
}

export function StudyLine({contact, takesPart, answer}: Props): VNode {
  const w = words.classroom.study
  return (
    <div class="class-handout" data-testid="class-study">
      <span role="status">
        {takesPart === null ? w.asked : takesPart ? w.takesPart : w.takesNoPart} {w.contact(contact)}{" "}
        <a href={privacyPage} target="_blank" rel="noreferrer">
          {words.readMore}
        </a>
      </span>
      {takesPart !== true && (
        <button type="button" class="plain" onClick={() => answer(true)}>
          {w.agree}
        </button>
      )}
      {takesPart !== false && (
        <button type="button" class="plain" onClick={() => answer(false)}>
          {takesPart === null ? w.decline : w.stop}
        </button>
      )}
    </div>
  )
}
