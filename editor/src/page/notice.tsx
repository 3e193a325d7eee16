/// A quiet bar below the top bar for what the page itself must say: a lost connection, a helper that restarts, a full room,
/// a file that could not be read.

import type {VNode} from "preact"
import {awaitsProgram} from "../state/page.ts"
import {words} from "../words/index.ts"
import {CloseIcon} from "./icons.tsx"
import {useDesk, usePage} from "./pick.ts"
import {noticeWords} from "./sentences.ts"

export function NoticeBar(): VNode {
  const {store} = useDesk()
  const notice = usePage(s => s.notice)
  const link = usePage(s => s.link)
  const worker = usePage(s => s.worker)
  const awaited = usePage(s => awaitsProgram(s) && s.notice === null)
  const place = usePage(s => (s.run.kind === "queued" ? s.run.place : null))
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
  const said = notice === null ? null : noticeWords(notice)
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
