/// Causal path that an answer highlights: functions, stores, sources and commands, and the moments on the time line. Pure.

import type {Explanation} from "../../../state/messages/why_state.ts"
import type {FiringShown} from "../../../wire/page/explanations.generated.ts"

export interface CausalPath {
  /// Functions that ran, and all that the sentences name.
  readonly functions: ReadonlySet<string>
  /// Types of events and states that were taken, of memories, and of commands.
  readonly taken: ReadonlySet<string>
  readonly stores: ReadonlySet<string>
  readonly given: ReadonlySet<string>
  /// Seconds of the run, in order.
  readonly moments: readonly number[]
}

export const noPath: CausalPath = {
  functions: new Set(),
  taken: new Set(),
  stores: new Set(),
  given: new Set(),
  moments: [],
}

export function causalPath(answer: Explanation): CausalPath {
  const {path} = answer
  const about = answer.sentences.flatMap(({said}) => [said.function, said.other, ...said.functions])
  const last = path.at(-1)
  return {
    functions: new Set([...path.map(f => f.function), ...about.filter(name => name !== "")]),
    taken: new Set(path.flatMap(taken)),
    stores: new Set(
      path.flatMap(({took}) =>
        took.flatMap(({from, type}) => (from === "memory" || from === "param" ? [type] : [])),
      ),
    ),
    // What earlier firings sent has no part in it.
    given: new Set(last?.gave.flatMap(({to, type}) => (to === "command" ? [type] : []))),
    moments: [...new Set([...path.map(f => f.time), ...answer.sentences.map(s => s.time)])].sort(
      (a, b) => a - b,
    ),
  }
}

const firstWord = (value: string) => /^\S+/.exec(value)?.[0] ?? value

function taken({cause, took}: FiringShown): readonly string[] {
  const values = took.flatMap(({from, value}) => (from === "event" || from === "state" ? [value] : []))
  return [...values, cause.value].filter(value => value !== "" && value !== "()").map(firstWord)
}
