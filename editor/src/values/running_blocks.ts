/// The blocks that run at the moment of a run that is looked at: definitions, and calls of ready-made tasks, which have no definition in the program. Pure.

import type {BlockId, Program} from "../program/program.ts"
import type {PageState} from "../state/page_state.ts"
import {shownFrame} from "../state/runs/room_state.ts"
import {begunAt} from "../state/runs/run_steps.ts"

export interface Running {
  readonly blocks: readonly BlockId[]
  /// Their places in the text.
  readonly ranges: readonly {readonly start: number; readonly end: number}[]
  /// The learner went to the very beginning of a step, and did not only pass through it.
  readonly isAtStep: boolean
}

const nothing: Running = {blocks: [], ranges: [], isAtStep: false}

/// Nothing while the run is not looked back at, or when the text has changed since it began.
export function runningBlocks({room, document}: Pick<PageState, "room" | "document">): Running {
  const frame = shownFrame(room)
  const {program} = document
  if (room.lookedAt === null || frame === null || room.source !== program.text) return nothing
  // Where one step ends and another begins, both fire: the one that begins is meant.
  const begun = begunAt(room.recording, frame.time)
  const parts = [...new Set(begun.length > 0 ? begun : frame.fired)].flatMap(name => placesOf(program, name))
  return {
    blocks: parts.map(({block}) => block),
    ranges: parts.map(({start, end}) => ({start, end})),
    isAtStep: begun.length > 0 && room.lookedAt === frame.time,
  }
}

/// The definition of a function, or the calls of one that the program does not define.
function placesOf({text, spans, definitions}: Program, name: string): Program["spans"] {
  const definition = definitions.find(d => d.name === name)
  if (definition !== undefined) return [definition]
  const calls = spans.filter(
    ({start, end}) =>
      text.slice(start, end).startsWith(name) && !/^[\w']/.test(text.slice(start + name.length, end)),
  )
  // Of the spans that begin at one place the widest is the call with all that it takes.
  return calls.filter(call => !calls.some(other => other.start === call.start && other.end > call.end))
}
