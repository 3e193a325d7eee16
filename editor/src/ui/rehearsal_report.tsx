/// Report of the rehearsal of a draft: whether the solution passes and the wrong attempts fail, or what is not so. It warns; the lesson can be saved as it is.

import type {VNode} from "preact"
import {findingsOf, isAbout, isOver, type Rehearsal, type RehearsalFinding} from "../jobs/rehearsal.ts"
import type {LessonDraft} from "../lesson_files/draft.ts"
import {seenText} from "../lesson_files/seen_text.ts"
import {words} from "../words/index.ts"
import {useController} from "./app_context.ts"
import {TextWithCode} from "./controls.tsx"

export function RehearsalReport({draft}: {readonly draft: LessonDraft}): VNode {
  const {lessonEditor} = useController()
  const rehearsal = lessonEditor.rehearsal.value
  const w = words.lessonEditor.rehearsal
  const isCurrent = rehearsal !== null && isAbout(rehearsal, draft)
  return (
    <section class="rehearsal" aria-label={w.title}>
      <div aria-live="polite">
        {rehearsal === null || !isCurrent ? (
          <p class="quiet">{rehearsal === null ? w.never : w.stale}</p>
        ) : (
          <Result rehearsal={rehearsal} />
        )}
      </div>
      {(!isCurrent || rehearsal.failure !== null) && (
        <button type="button" class="plain" onClick={lessonEditor.rehearse}>
          {w.start}
        </button>
      )}
    </section>
  )
}

function Result({rehearsal}: {readonly rehearsal: Rehearsal}): VNode {
  const {attempts, judged, failure} = rehearsal
  const findings = findingsOf(rehearsal)
  const w = words.lessonEditor.rehearsal
  return (
    <>
      {failure !== null && <p class="note">{failure.kind === "said" ? failure.message : w.lost}</p>}
      {!isOver(rehearsal) && <p class="quiet">{w.running(judged.length, attempts.length)}</p>}
      {isOver(rehearsal) && failure === null && findings.length === 0 && (
        <p class="rehearsal-good">✓ {w.good(attempts.length)}</p>
      )}
      {findings.length > 0 && (
        <ul class="draft-mistakes">
          {findings.map(finding => (
            <li key={JSON.stringify(finding)}>
              <TextWithCode text={findingText(finding)} strong={null} />
            </li>
          ))}
        </ul>
      )}
    </>
  )
}

function findingText(finding: RehearsalFinding): string {
  const w = words.lessonEditor.rehearsal.findings
  switch (finding.kind) {
    case "no-solution":
      return w[finding.kind]
    case "solution-misses": {
      const seen = finding.seen === null ? "" : ` ${seenText(finding.seen)}`
      return `${w[finding.kind](finding.step, finding.check)}${seen}`
    }
    case "solution-broken":
      return `${w[finding.kind](finding.step)} ${finding.problem}`
    case "wrong-passes":
      return w[finding.kind](finding.step, finding.check, finding.place)
    case "wrong-broken":
      return `${w[finding.kind](finding.step, finding.check, finding.place)} ${finding.problem}`
  }
}
