/// Order of the offered fixes of a problem by what they lead to. Pure.

import {compareOutcomes, isBetter, type Outcome} from "./outcome.ts"

/// An outcome is `undefined` as long as it is not known, and `null` where there is none to know.
export type KnownOutcome = Outcome | null | undefined

/// The order in which a list shows its fixes, for good.
export interface DecidedOrder {
  /// What the list is about: another list is decided anew.
  readonly key: string
  readonly order: readonly number[]
}

/// The decision about a list of so many fixes, once it is taken: as soon as the outcomes give an `order`, or else, when a person has begun to point at
/// the list or its first moment is over (`isClosed`), as they were given.
export function decideOrder(
  before: DecidedOrder | null,
  key: string,
  count: number,
  order: readonly number[] | null,
  isClosed: boolean,
): DecidedOrder | null {
  if (before?.key === key) return before
  if (isClosed) return {key, order: Array.from({length: count}, (_, i) => i)}
  return order === null ? null : {key, order}
}

/// The places of the fixes that are offered, best first; `null` as long as an outcome is missing. Fixes without an outcome follow those with one.
/// `drops`: a fix whose run is no better than that of the program is left out.
export function orderedFixes(
  program: KnownOutcome,
  outcomes: readonly KnownOutcome[],
  drops: boolean,
): readonly number[] | null {
  if (program === undefined || outcomes.includes(undefined)) return null
  const places = outcomes.map((_, i) => i)
  // Without a run of the program there is nothing to compare with.
  if (program === null) return places
  const isOffered = (i: number) => {
    const outcome = outcomes[i] ?? null
    return !drops || outcome === null || isBetter(outcome, program)
  }
  return places.filter(isOffered).sort((i, j) => {
    const [a, b] = [outcomes[i] ?? null, outcomes[j] ?? null]
    if (a === null || b === null) return (a === null ? 1 : 0) - (b === null ? 1 : 0)
    return compareOutcomes(a, b)
  })
}
