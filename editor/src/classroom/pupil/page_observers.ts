/// Observers of the page for class mode: changes of the program that are to be saved, and the status that the board shows.

import type {Store} from "../../browser/store.ts"
import {isDone} from "../../state/lesson_state.ts"
import type {PageState} from "../../state/page_state.ts"
import {isActive} from "../../state/runs/run_state.ts"
import type {PupilRequest, Reason, Status} from "../../wire/classroom/pupil_messages.generated.ts"

/// Milliseconds between a change and its being sent to the service.
const savePause = 2000

/// Calls `touched` at each change of the program and `save` some time after it, and at every run.
export function watchChanges(
  store: Store,
  isMember: () => boolean,
  touched: () => void,
  save: (reason: Reason) => void,
): void {
  let seen = {document: store.now.document.program, name: store.now.name, world: store.now.worldName}
  let runs = store.now.runs
  let timer: ReturnType<typeof setTimeout> | undefined
  const saveNow = (reason: Reason) => {
    clearTimeout(timer)
    timer = undefined
    if (isMember()) save(reason)
  }
  store.onEvent(({document, name, worldName, runs: newest}) => {
    if (newest !== runs) {
      runs = newest
      // After the event: saving dispatches events of its own.
      queueMicrotask(() => saveNow("run"))
    }
    if (document.program === seen.document && name === seen.name && worldName === seen.world) return
    seen = {document: document.program, name, world: worldName}
    if (isMember()) touched()
    timer ??= setTimeout(() => saveNow("change"), savePause)
  })
  const flush = () => timer !== undefined && saveNow("change")
  window.addEventListener("pagehide", flush)
  document.addEventListener("visibilitychange", () => document.visibilityState === "hidden" && flush())
}

/// Tells the board what the page shows, whenever it changes.
export function openStatus(
  store: Store,
  /// The identifier of the open program, `null` for one that is not stored.
  openProgram: () => string | null,
  send: (message: PupilRequest) => boolean,
) {
  let told = ""
  let session: string | null = null
  const tell = (state: PageState) => {
    if (state.session !== session && state.session !== null && send({op: "here", session: state.session}))
      session = state.session
    const now = {...statusOf(state), program: openProgram()}
    const text = JSON.stringify(now)
    if (text !== told && send({op: "status", ...now})) told = text
  }
  store.onFrame(tell)
  return {
    repeat() {
      told = ""
      session = null
      tell(store.now)
    },
  }
}

function statusOf(state: PageState): Omit<Status, "op" | "program"> {
  const {open} = state.lessons
  const isError = (finding: {readonly severity: string}) => finding.severity === "error"
  return {
    errors: state.findings.compiler.some(isError) || state.findings.run.some(isError),
    running: isActive(state.run),
    lesson:
      open === null
        ? null
        : {
            name: open.lesson.title,
            done: open.lesson.steps.filter(step => isDone(state.lessons, step)).length,
            steps: open.lesson.steps.length,
          },
  }
}
