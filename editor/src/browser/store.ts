/// Store of the page's state. Events change the state at once; views are notified at most once per animation frame.

import {signal} from "@preact/signals"
import {reduce} from "../reducers/reducer.ts"
import type {PageEvent} from "../state/page_events.ts"
import {initialState, type PageState} from "../state/page_state.ts"
import type {Effect} from "../state/transition.ts"

export interface Store {
  /// The newest state, also between frames.
  readonly now: PageState
  /// The state as it is drawn; panels subscribe to it.
  readonly drawn: {readonly value: PageState}
  dispatch(event: PageEvent): void
  /// Called after each event, in the task of the event.
  onEvent(heard: (state: PageState) => void): void
  /// Called once per frame after something changed, or was asked for by `redraw`.
  onFrame(draw: (state: PageState, now: number) => void): void
  redraw(): void
  /// Draws what the next frame would, without waiting for it.
  drawNow(): void
}

export function createStore(perform: (order: Effect) => void, first: Partial<PageState>): Store {
  let state: PageState = {...initialState, ...first}
  const drawn = signal(state)
  const drawers: ((state: PageState, now: number) => void)[] = []
  const listeners: ((state: PageState) => void)[] = []
  let frame: number | null = null

  const draw = (now: number) => {
    frame = null
    drawn.value = state
    for (const drawer of drawers) drawer(state, now)
  }
  const redraw = () => {
    frame ??= requestAnimationFrame(draw)
  }

  return {
    get now() {
      return state
    },
    drawn,
    dispatch(event) {
      const step = reduce(state, event)
      state = step.state
      for (const order of step.effects) perform(order)
      for (const heard of listeners) heard(state)
      redraw()
    },
    onEvent(heard) {
      listeners.push(heard)
    },
    onFrame(draw) {
      drawers.push(draw)
    },
    redraw,
    drawNow() {
      if (frame === null) return
      cancelAnimationFrame(frame)
      draw(performance.now())
    },
  }
}
