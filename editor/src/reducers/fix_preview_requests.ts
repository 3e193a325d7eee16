/// Requests for previews of the offered fixes: one after another, only of lists that can be seen, and after the preview of the program. Pure.

import {nextText, noFixPreviews} from "../state/messages/fix_previews.ts"
import {isPending, previewSeconds} from "../state/messages/preview.ts"
import type {PageState} from "../state/page_state.ts"
import type {Effect, Transition} from "../state/transition.ts"
import {computesPreviews} from "./preview_requests.ts"

/// Shortest and longest run that is previewed for a fix, s: in an empty room the robot needs half a minute to the wall and what the fix
/// does there, and a list may ask for several.
const shortest = 30
const longest = 60

/// Whether the fixes of the program are previewed now: it has been compiled as it is.
export const previewsFixes = (state: PageState): boolean =>
  computesPreviews(state) && state.accepted && state.pendingText === null

/// Asks for the next preview. A change of the program drops the answers; what the service answers to an older question is not used.
export function withFixPreviews(old: PageState, {state, effects: others}: Transition): Transition {
  // The way out of a conflict is likely to be looked at: a process that computes previews takes two seconds to start.
  const begins = hasConflict(state) && !hasConflict(old) && computesPreviews(state)
  const effects: readonly Effect[] = begins
    ? [...others, {kind: "send", message: {op: "prepare-previews"}}]
    : others
  const text = state.document.program.text
  const before = state.room.fixPreviews
  if (!previewsFixes(state)) {
    const isEmpty = before.asked === null && before.answers.size === 0
    return {state: isEmpty ? state : withAnswers(state, noFixPreviews), effects}
  }
  const known = before.of === text ? before : {...noFixPreviews, of: text}
  // The service answers the newest question of a page only.
  const current = isPending(state.room.preview) ? {...known, asked: null} : known
  const next = isPending(state.room.preview) ? undefined : nextText(current, state.offeredFixes, text)
  if (next === undefined || current.asked?.text === next)
    return {
      state: current === before || state.offeredFixes.length === 0 ? state : withAnswers(state, current),
      effects,
    }
  const id = state.previews + 1
  const seconds = Math.min(longest, Math.max(shortest, previewSeconds(state.room.frame?.time ?? 0)))
  const request: Effect = {kind: "send", message: {op: "preview", id, source: next, seconds}}
  return {
    state: withAnswers({...state, previews: id}, {...current, asked: {id, text: next}}),
    effects: [...effects, request],
  }
}

const hasConflict = ({document}: PageState) => document.findings.some(f => f.conflict !== undefined)

const withAnswers = (state: PageState, fixPreviews: PageState["room"]["fixPreviews"]): PageState => ({
  ...state,
  room: {...state.room, fixPreviews},
})
