/// Rehearsals of the draft that is being written: one at a time, asked of the service.

import {type Signal, signal} from "@preact/signals"
import type {Store} from "../../browser/store.ts"
import {startJob} from "../../jobs/job_socket.ts"
import {
  heard,
  isOver,
  type Rehearsal,
  type RehearsalAnswer,
  readAnswer,
  rehearsalOf,
} from "../../jobs/rehearsal.ts"
import type {LessonDraft} from "../../lesson_files/draft.ts"

export interface LessonRehearsals {
  /// The latest rehearsal; `null` before the first.
  readonly latest: Signal<Rehearsal | null>
  start(draft: LessonDraft): void
}

export function openLessonRehearsals(store: Store): LessonRehearsals {
  const latest = signal<Rehearsal | null>(null)
  let cancel = () => {}
  return {
    latest,
    start(draft) {
      cancel()
      const begun = rehearsalOf(draft)
      latest.value = begun
      const lost = () => {
        latest.value = {...(latest.value ?? begun), failure: {kind: "lost"}}
      }
      if (isOver(begun)) return
      const {session} = store.now
      if (session === null) return lost()
      const isLast = (answer: RehearsalAnswer) =>
        answer.op === "failed" || (answer.op === "attempt" && answer.number + 1 === begun.attempts.length)
      cancel = startJob(
        `lesson-rehearsals/${encodeURIComponent(session)}`,
        JSON.parse(begun.request),
        {read: readAnswer, isLast},
        {
          received(answer) {
            latest.value = heard(latest.value ?? begun, answer)
          },
          lost,
        },
      )
    },
  }
}
