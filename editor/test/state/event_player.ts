/// Player of events for tests of the reducers, with a program and the messages of a service.

import {type Document, emptyDocument} from "../../src/program/history.ts"
import {reduce} from "../../src/reducers/reducer.ts"
import type {Frame, ServiceMessage} from "../../src/state/messages/messages.ts"
import type {PageEvent} from "../../src/state/page_events.ts"
import {initialState, type PageState} from "../../src/state/page_state.ts"
import type {Effect} from "../../src/state/transition.ts"
import type {Problem} from "../../src/wire/problem.generated.ts"

/// Whether a message has to do with runs themselves; what prepares previews is tested with those.
export const isOfRun = ({op}: {readonly op: string}): boolean => op !== "prepare-previews"

/// Plays events in order; answers the last state and every message that was sent, without what prepares previews.
export function play(state: PageState, ...events: readonly PageEvent[]) {
  const orders: Effect[] = []
  for (const event of events) {
    const step = reduce(state, event)
    state = step.state
    orders.push(...step.effects)
  }
  const sent = orders.flatMap(o => (o.kind === "send" && isOfRun(o.message) ? [o.message] : []))
  return {state, orders, sent, ops: sent.map(m => m.op)}
}

export const hear = (message: ServiceMessage): PageEvent => ({kind: "heard", message})
export const hello = hear({op: "hello", session: "s"})
export const running = (run: number) => hear({op: "state", run, state: "running"})
export const ended = (
  run: number,
  how: "done" | "error" | "refused" | "stopped",
  problems: readonly Problem[] = [],
) => hear({op: "state", run, state: "ended", ended: how, problems})
export const frame = (run: number, more: Partial<Frame> = {}): PageEvent =>
  hear({
    op: "frame",
    frame: {
      run,
      step: 1,
      time: 0.02,
      x: 1,
      y: 2,
      theta: 0,
      channels: {Velocity: [0.5, 0]},
      fired: [],
      sensed: [],
      boxes: null,
      ghost: null,
      memory: null,
      ...more,
    },
  })
export const press = {kind: "run-pressed"} as const
export const stop = {kind: "stop-pressed"} as const
export const reset = {kind: "reset-pressed"} as const
export const text = "accelerate :: Velocity\n\nmain = simulate accelerate\n"
export const program = {
  text,
  spans: [
    {start: 0, end: 22, block: "def"},
    {start: 14, end: 22, block: "type"},
    {start: 24, end: 50, block: "main"},
  ],
  definitions: [
    {name: "accelerate", start: 0, end: 22, block: "def"},
    {name: "main", start: 24, end: 50, block: "main"},
  ],
  families: new Map(),
  words: [],
}
export const document: Document = {...emptyDocument, program}
export const open = play(
  {...initialState, document},
  hello,
  hear({op: "worker", state: "ready", fault: ""}),
).state
export const problem: Problem = {
  severity: "error",
  kind: "type-mismatch",
  start: {line: 1, column: 15},
  end: {line: 1, column: 23},
  function: "accelerate",
  message: "",
  hint: "",
  ghc: "",
  time: null,
  inputs: [],
  sentences: null,
  fixes: [],
}
