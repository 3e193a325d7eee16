/// Dragging of the number at the cursor in the Haskell pane, by a grip below it.

import {EditorState, type Extension, StateField} from "@codemirror/state"
import {type EditorView, showTooltip, type Tooltip} from "@codemirror/view"
import {makeNumberGrip, type NumberDragListener} from "../preview/number_grip.ts"
import {inText, type NumberPlace, numberAt} from "../preview/number_steps.ts"

export interface NumberDragging extends NumberDragListener {
  readonly hint: string
}

/// The number that the cursor touches, with its place in the whole text.
function numberAtCursor(state: EditorState): NumberPlace | null {
  const {head, empty} = state.selection.main
  if (!empty || state.facet(EditorState.readOnly)) return null
  const line = state.doc.lineAt(head)
  const found = numberAt(line.text, head - line.from)
  return found === null ? null : {...found, from: line.from + found.from, to: line.from + found.to}
}

export function numberDragging(dragging: NumberDragging): Extension {
  // One function for all grips: the view of a tooltip stays while its function does, also when the text changes.
  const create = (view: EditorView) => ({
    dom: makeNumberGrip(
      dragging.hint,
      {
        literal: () => numberAtCursor(view.state)?.literal ?? "0",
        set(literal) {
          const place = numberAtCursor(view.state)
          if (place === null) return
          const insert = inText(literal)
          view.dispatch({
            changes: {from: place.from, to: place.to, insert},
            selection: {anchor: place.from},
            userEvent: "input.drag",
          })
        },
      },
      dragging,
    ),
  })
  const tooltipOf = (state: EditorState): Tooltip | null => {
    const place = numberAtCursor(state)
    return place === null ? null : {pos: place.from, above: false, create}
  }
  return StateField.define<Tooltip | null>({
    create: tooltipOf,
    update(before, transaction) {
      if (!transaction.docChanged && transaction.selection === undefined && !transaction.reconfigured)
        return before
      const now = tooltipOf(transaction.state)
      return now !== null && before !== null && now.pos === before.pos ? before : now
    },
    provide: field => showTooltip.from(field),
  })
}
