/// Transition of the page's state: the next state and the effects to perform; helpers of the reducers.

import type {Request} from "../wire/page/page.generated.ts"
import type {PageState} from "./page_state.ts"

/// Effect outside of the state: a message to send, a sound to play, a file to read or to download.
export type Effect =
  | {readonly kind: "send"; readonly message: Request}
  | {readonly kind: "play"; readonly sound: number}
  /// A file of a room: to choose from the computer, or to download.
  | {readonly kind: "pick-world"}
  | {readonly kind: "save-world"; readonly name: string; readonly text: string}

export interface Transition {
  readonly state: PageState
  readonly effects: readonly Effect[]
}

/// The next state without effects.
export const still = (state: PageState): Transition => ({state, effects: []})

/// The next state and messages to the service.
export const sending = (state: PageState, ...messages: Request[]): Transition => ({
  state,
  effects: messages.map(message => ({kind: "send", message})),
})

/// Ends a `switch` over a union: the compiler proves that no case was forgotten.
export function unreachable(value: never): never {
  throw new Error(`expected every case to be handled, found ${JSON.stringify(value)}`)
}
