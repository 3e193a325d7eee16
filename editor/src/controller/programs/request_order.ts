/// Order of requests for programs, whose answers arrive later. What the learner chooses takes the place of what was chosen before; the page's own first program takes
/// the place of nothing.

export interface RequestOrder {
  /// The learner chooses a program. The result tells whether it is still the last one chosen.
  choose(): () => boolean
  /// Whether the learner has chosen nothing, so that the page's first program is wanted.
  isFirstWanted(): boolean
  /// The program that was chosen last does not exist.
  withdraw(): void
}

export function orderRequests(): RequestOrder {
  let last: symbol | null = null
  return {
    choose() {
      const mine = Symbol()
      last = mine
      return () => mine === last
    },
    isFirstWanted: () => last === null,
    withdraw() {
      last = null
    },
  }
}
