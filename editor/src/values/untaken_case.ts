/// Question why a case was not taken: the equation, guard or alternative around a block. Pure.

import {type BlockId, offsetOf, textRangeOf} from "../program/program.ts"
import {lookedBackFor, type Question} from "../state/messages/why_state.ts"
import type {PageState} from "../state/page_state.ts"
import type {Branch} from "../wire/firing.generated.ts"

type Shown = Pick<PageState, "document" | "room">

/// About the innermost case around a block, at the displayed moment; `null` where nothing is chosen, without a run, and when the text has
/// changed since the run began: the places of cases are those of the text that runs.
export function caseQuestion(state: Shown, block: BlockId): Question | null {
  return questionIn(state, textRangeOf(state.document.program.spans, block))
}

/// The same at the cursor in the text.
export function caseQuestionAt(state: Shown, offset: number): Question | null {
  return questionIn(state, {start: offset, end: offset})
}

function questionIn({document, room}: Shown, range: {start: number; end: number} | null): Question | null {
  const {text} = document.program
  const until = room.lookedAt ?? room.frame?.time ?? null
  if (room.run === null || until === null || room.source !== text) return null
  const around = range === null ? null : innermostBranch(room.branches, text, range)
  if (around === null) return null
  const {start, end} = around
  const since = Math.max(0, until - lookedBackFor)
  return {kind: "not-taken", text: shownCase(around), start, end, since, until}
}

/// What the case is told by; `else` has the condition of its `if`.
const shownCase = ({kind, text}: Branch): string => (kind === "else" ? `else (${text})` : text)

function innermostBranch(
  branches: readonly Branch[],
  text: string,
  {start, end}: {readonly start: number; readonly end: number},
): Branch | null {
  const around = branches
    .map(branch => ({branch, from: offsetOf(text, branch.start), to: offsetOf(text, branch.end)}))
    .filter(({from, to}) => from <= start && end <= to)
    .sort((a, b) => a.to - a.from - (b.to - b.from))
  return around[0]?.branch ?? null
}
