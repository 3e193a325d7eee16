/// Connects the dragging of numbers with the page: one undo step for a drag, and the pace of the previews.

import type {NumberDragListener} from "../../browser/number_grip.ts"
import type {Store} from "../../browser/store.ts"
import {isPending} from "../../state/messages/preview.ts"

/// `flush` applies edits of the text that the document does not have yet.
export function openNumberDragging(store: Store, flush: () => void): NumberDragListener {
  return {
    begins() {
      flush()
      store.dispatch({kind: "number-drag", going: true})
    },
    ends() {
      flush()
      // The blocks tell their last change in a microtask of this task.
      setTimeout(() => store.dispatch({kind: "number-drag", going: false}))
    },
    isBehind: () => isPending(store.now.room.preview),
  }
}
