/// Requests for previews: one after each change of the program while a run of the page has ended or stands still. Pure.

import {noPreview, previewSeconds} from "../state/messages/preview.ts"
import type {PageState} from "../state/page_state.ts"
import {isActive} from "../state/runs/run_state.ts"
import type {Effect, Transition} from "../state/transition.ts"

/// Whether the service computes previews for the page now.
export function computesPreviews({run, clock, link, robots, worldEditor}: PageState): boolean {
  const stands = !isActive(run) || (run.kind === "running" && clock === "standing")
  return stands && link === "open" && robots.held === null && worldEditor === null
}

/// Whether the page shows previews of the edited program now.
export function mayPreview(state: PageState): boolean {
  return hasPreview(state) && state.companions.length === 0
}

const hasPreview = (state: PageState): boolean =>
  state.previewing && computesPreviews(state) && state.room.preview.ran !== null

/// Whether there is no preview of the edited program because other robots are in the room: a preview has the first alone.
export function lacksPreview(state: PageState): boolean {
  const {text} = state.document.program
  return state.companions.length > 0 && hasPreview(state) && text !== state.room.preview.ran && text !== ""
}

/// Asks for a preview when the program is another one than at the last question, and forgets the preview when none may be shown. When the page begins to
/// show previews, the service is told before anything is changed.
export function withPreview(before: PageState, {state, effects: others}: Transition): Transition {
  const begins = mayPreview(state) && !mayPreview(before)
  const effects: readonly Effect[] = begins
    ? [...others, {kind: "send", message: {op: "prepare-previews"}}]
    : others
  const {preview} = state.room
  // The blocks follow a text some milliseconds later; the preview needs none.
  const text = state.pendingText ?? state.document.program.text
  const wants = mayPreview(state) && text !== preview.ran && text !== ""
  if (!wants)
    return preview.asked === null && preview.answer === null
      ? {state, effects}
      : {state: withRoomPreview(state, {...noPreview, ran: preview.ran}), effects}
  if (preview.asked?.text === text) return {state, effects}
  const id = state.previews + 1
  const asked = withRoomPreview({...state, previews: id}, {...preview, asked: {id, text, isLate: false}})
  const seconds = previewSeconds(state.room.frame?.time ?? 0)
  const request: Effect = {kind: "send", message: {op: "preview", id, source: text, seconds}}
  return {state: asked, effects: [...effects, request]}
}

const withRoomPreview = (state: PageState, preview: PageState["room"]["preview"]): PageState => ({
  ...state,
  room: {...state.room, preview},
})
