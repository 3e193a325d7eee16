/// Notice bar below the top bar: connection state, worker state, place in the run queue, notices.

import type {VNode} from "preact"
import {awaitsProgram, type Notice} from "../../state/page_state.ts"
import {type AppController, useController, usePageState} from "../../ui/app_context.ts"
import {noticeText} from "../../ui/descriptions.ts"
import {CloseIcon} from "../../ui/icons.tsx"
import {words} from "../../words/index.ts"

export function NoticeBar(): VNode {
  const {store} = useController()
  const notice = usePageState(s => s.notice)
  const link = usePageState(s => s.link)
  const worker = usePageState(s => s.worker)
  const fault = usePageState(s => s.workerFault)
  const awaited = usePageState(s => awaitsProgram(s) && s.notice === null)
  const place = usePageState(s => (s.run.kind === "queued" ? s.run.place : null))
  // The first connection and the first start are quick as a rule: the stylesheet shows these lines late.
  const state =
    link === "lost"
      ? words.link.lost
      : link === "connecting"
        ? words.link.connecting
        : worker === "failed"
          ? fault
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
          <Choices notice={notice} />
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

function Choices({notice}: {readonly notice: Notice | null}): VNode | null {
  const controller = useController()
  const offered = choices(notice, controller)
  if (offered.length === 0) return null
  return (
    <span class="choices">
      {offered.map(({label, choose}) => (
        <button
          key={label}
          type="button"
          class="plain"
          onClick={() => {
            controller.store.dispatch({kind: "notice", notice: null})
            choose()
          }}
        >
          {label}
        </button>
      ))}
    </span>
  )
}

interface Choice {
  readonly label: string
  choose(): void
}

/// What a notice offers to do.
function choices(notice: Notice | null, {openText, repairCharacters}: AppController): readonly Choice[] {
  switch (notice?.kind) {
    case "older-encoding": {
      const {name, text, encoding} = notice
      const label = words.notices.olderEncoding.readAs(encoding)
      return [{label, choose: () => openText(name, {kind: "text", text})}]
    }
    case "several-programs":
      return notice.programs.map(({name, content}) => ({label: name, choose: () => openText(name, content)}))
    case "confusable":
      return [{label: words.notices.confusable.repair, choose: () => repairCharacters(notice)}]
    default:
      return []
  }
}
