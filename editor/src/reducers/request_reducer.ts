/// Reducers for lessons and questions about a run, whose changes may send a request to the service. Pure.

import {type LessonTransition, reduceLesson} from "../state/lesson_state.ts"
import {reduceWhy, type WhyEvent} from "../state/messages/why_state.ts"
import type {PageState} from "../state/page_state.ts"
import {sending, still, type Transition} from "../state/transition.ts"

/// Stores the state of the lessons, and tells the service which step it checks from now on.
export function withLessons(state: PageState, {state: lessons, watched}: LessonTransition): Transition {
  const changed = {...state, lessons}
  return watched === undefined || state.link !== "open"
    ? still(changed)
    : sending(changed, {op: "lesson", step: watched})
}

/// A room that was changed in the room editor beside the lesson editor is the room of the draft.
export function withDraftRoom(before: PageState, {state, effects}: Transition): Transition {
  const {worldName, lessons} = state
  const isTaken = typeof worldName === "object" && worldName !== null && worldName !== before.worldName
  if (lessons.writing?.mode !== "editing" || !isTaken) return {state, effects}
  const edit = {kind: "room", room: worldName} as const
  return {state: {...state, lessons: reduceLesson(lessons, {kind: "draft-edited", edit}).state}, effects}
}

/// Stores a question about the run or a step between questions, and asks the service. On a phone the answer is in the region of the room.
export function explain(state: PageState, event: WhyEvent): Transition {
  const {state: why, request} = reduceWhy(state.why, event)
  const asked = {
    ...state,
    why,
    region: event.kind === "asked" && state.size === "phone" ? "room" : state.region,
  } as const
  if (request === null) return still(asked)
  const {run} = state.room
  const about = run === null || run === state.runs ? {} : {run}
  return state.link === "open" ? sending(asked, {...request, ...about}) : still(state)
}
