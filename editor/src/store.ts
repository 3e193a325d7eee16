/// Holds the page's state. Events change it at once; whoever draws is told at most once per animation frame.

import {signal} from "@preact/signals"
import {next} from "./state/next.ts"
import {firstPage, type Order, type PageEvent, type PageState} from "./state/page.ts"

export interface Store {
  /// The newest state, also between frames.
  readonly now: PageState
  /// The state as it is drawn; panels subscribe to it.
  readonly drawn: {readonly value: PageState}
  dispatch(event: PageEvent): void
  /// Called once per frame after something changed, or was asked for by `redraw`.
  onFrame(draw: (state: PageState, now: number) => void): void
  redraw(): void
}

export function openStore(perform: (order: Order) => void, first: Partial<PageState>): Store {
  let state: PageState = {...firstPage, ...first}
  const drawn = signal(state)
  const drawers: ((state: PageState, now: number) => void)[] = []
  let asked = false

  const redraw = () => {
    if (asked) return
    asked = true
    requestAnimationFrame(now => {
      asked = false
      drawn.value = state
      for (const draw of drawers) draw(state, now)
    })
  }

  return {
    get now() {
      return state
    },
    drawn,
    dispatch(event) {
      const step = next(state, event)
      state = step.state
      for (const order of step.orders) perform(order)
      redraw()
    },
    onFrame(draw) {
      drawers.push(draw)
    },
    redraw,
  }
}
