/// State machine of a run: effects of Run and Stop, and which late answers are ignored.
///
/// A run has a number chosen by the page. An answer with another number belongs to an older run and is ignored, so Stop takes effect at once.

import type {Problem} from "../../wire/problem.generated.ts"
import type {Ended, ServiceMessage} from "../messages/messages.ts"

export type RunState =
  | {readonly kind: "ready"}
  /// Run was pressed while the service could not be reached; it is sent when the service is back.
  | {readonly kind: "waiting"; readonly run: number}
  /// As many programs run as may; this one's place in the queue, 1 for the next.
  | {readonly kind: "queued"; readonly run: number; readonly place: number}
  | {readonly kind: "compiling"; readonly run: number}
  | {readonly kind: "running"; readonly run: number}
  | {readonly kind: "ended"; readonly run: number; readonly how: Ended | "hole" | "lost"}

export type RunEvent =
  | {readonly kind: "run-pressed"; readonly connected: boolean; readonly run: number}
  | {readonly kind: "stop-pressed"}
  | {readonly kind: "reset-pressed"}
  | {readonly kind: "connected"}
  | {readonly kind: "lost"}
  | {readonly kind: "heard"; readonly message: ServiceMessage & {readonly op: "state"}}

/// True while Stop is what the button should say.
export function isActive(
  run: RunState,
): run is RunState & {readonly kind: "waiting" | "queued" | "compiling" | "running"} {
  return run.kind === "waiting" || run.kind === "queued" || run.kind === "compiling" || run.kind === "running"
}

export function nextRun(state: RunState, event: RunEvent): RunState {
  switch (event.kind) {
    case "run-pressed":
      return {kind: event.connected ? "compiling" : "waiting", run: event.run}
    case "stop-pressed":
      if (state.kind === "waiting") return {kind: "ready"}
      return isActive(state) ? {kind: "ended", run: state.run, how: "stopped"} : state
    case "reset-pressed":
      return {kind: "ready"}
    case "connected":
      return state.kind === "waiting" ? {kind: "compiling", run: state.run} : state
    case "lost":
      if (state.kind === "queued" || state.kind === "compiling" || state.kind === "running")
        return {kind: "ended", run: state.run, how: "lost"}
      return state
    case "heard": {
      const {message} = event
      if (!isActive(state) || message.run !== state.run) return state
      if (message.state === "ended") return {kind: "ended", run: state.run, how: endOf(message)}
      if (message.state === "queued") return {kind: "queued", run: state.run, place: message.place}
      if (message.state === "compiling" && state.kind !== "queued") return state
      return {kind: message.state, run: state.run}
    }
  }
}

/// A run that comes to an empty place has an end of its own.
function endOf({
  ended,
  problems,
}: {
  readonly ended: Ended
  readonly problems: readonly Problem[]
}): Ended | "hole" {
  return ended === "error" && problems.some(p => p.kind === "hole") ? "hole" : ended
}
