/// Notice bar below the top bar: connection state, worker state, place in the run queue, notices.

import type {VNode} from "preact"
import {awaitsProgram} from "../../state/page_state.ts"
import {words} from "../../words/index.ts"
import {useController, usePageState} from "../app_context.ts"
import {noticeText} from "../descriptions.ts"
import {CloseIcon} from "../icons.tsx"

export function NoticeBar(): VNode {
  const {store} = useController()
  const notice = usePageState(s => s.notice)
  const link = usePageState(s => s.link)
  const worker = usePageState(s => s.worker)
  const awaited = usePageState(s => awaitsProgram(s) && s.notice === null)
  const place = usePageState(s => (s.run.kind === "queued" ? s.run.place : null))
  // The first connection and the first start are quick as a rule: the stylesheet shows these lines late.
  const state =
    link === "lost"
      ? words.link.lost
      : link === "connecting"
        ? words.link.connecting
        : worker !== "ready"
          ? words.worker[worker]
          : awaited
            ? words.programComing
            : place === null
              ? null
              : words.queued(place)
  const said = notice === null ? null : noticeText(notice)
  return (
    <div class="notices" aria-live="polite">
      {state !== null && (
        <p
          class={`notice ${link === "connecting" || worker === "starting" || awaited ? "late" : ""}`}
          data-testid="link"
        >
          {state}
        </p>
      )}
      {said !== null && (
        <p class="notice strong" data-testid="notice">
          <span>
            <b>{said.message}</b> {said.hint}
          </span>
          <button
            type="button"
            class="plain icon"
            aria-label={words.close}
            onClick={() => store.dispatch({kind: "notice", notice: null})}
          >
            <CloseIcon />
          </button>
        </p>
      )}
    </div>
  )
}
