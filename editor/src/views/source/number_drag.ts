/// Changing of numbers in the Haskell pane: with the mouse by their digits, by finger by a grip below the number at the cursor, and by keys.

import {EditorState, type Extension, StateField} from "@codemirror/state"
import {type Command, EditorView, keymap, showTooltip, type Tooltip} from "@codemirror/view"
import {
  type DraggedNumber,
  dragNumber,
  makeNumberGrip,
  type NumberDragListener,
} from "../../browser/number_grip.ts"
import {inText, type NumberPlace, numberAt, withSteps} from "../../browser/number_steps.ts"
import {ownKeys} from "./shortcuts.ts"

export interface NumberDragging extends NumberDragListener {
  readonly hint: string
}

/// The number that a place touches, with its own place in the whole text.
function numberTouching(state: EditorState, place: number): NumberPlace | null {
  if (state.facet(EditorState.readOnly)) return null
  const line = state.doc.lineAt(place)
  const found = numberAt(line.text, place - line.from)
  return found === null ? null : {...found, from: line.from + found.from, to: line.from + found.to}
}

/// The number that the cursor touches.
function numberAtCursor(state: EditorState): NumberPlace | null {
  const {head, empty} = state.selection.main
  return empty ? numberTouching(state, head) : null
}

/// The number at the cursor as it is dragged.
const numberOf = (view: EditorView): DraggedNumber => ({
  literal: () => numberAtCursor(view.state)?.literal ?? "0",
  set(literal) {
    const place = numberAtCursor(view.state)
    if (place === null) return
    view.dispatch({
      changes: {from: place.from, to: place.to, insert: inText(literal)},
      selection: {anchor: place.from},
      userEvent: "input.drag",
    })
  },
})

/// Pixels of movement after which a press on a digit is a drag.
const dragDistance = 3

/// Whether a point is on the digits of a number, and not beside them.
function isOnDigits(view: EditorView, {from, to}: NumberPlace, {x, y}: {x: number; y: number}): boolean {
  const first = view.coordsAtPos(from, 1)
  const last = view.coordsAtPos(to, -1)
  if (first === null || last === null) return false
  return x >= first.left && x <= last.right && y >= first.top && y <= last.bottom
}

/// A drag to the left or right from the digits of a number changes it; upwards or downwards it selects text, as a drag from elsewhere does.
function digitDragging(listener: NumberDragListener): Extension {
  // Of the press that is going on: the mouse event that follows tells whether it is the first of a double click.
  let down: PointerEvent | null = null
  return EditorView.domEventHandlers({
    pointerdown(event) {
      down = event
      return false
    },
    mousedown(event, view) {
      const pointer = down
      const isPlain = !event.shiftKey && !event.ctrlKey && !event.altKey && !event.metaKey
      if (pointer?.pointerType !== "mouse" || event.button !== 0 || event.detail !== 1 || !isPlain)
        return false
      const point = {x: event.clientX, y: event.clientY}
      const pressed = view.posAtCoords(point)
      const place = pressed === null ? null : numberTouching(view.state, pressed)
      if (pressed === null || place === null || !isOnDigits(view, place, point)) return false
      view.focus()
      view.dispatch({selection: {anchor: pressed}, userEvent: "select.pointer"})
      followPress(view, pointer, pressed, listener)
      return true
    },
  })
}

/// Follows a press on a digit until its direction is known.
function followPress(
  view: EditorView,
  down: PointerEvent,
  pressed: number,
  listener: NumberDragListener,
): void {
  const stop = new AbortController()
  let isSelecting = false
  const listen = {capture: true, signal: stop.signal}
  window.addEventListener(
    "pointermove",
    move => {
      if (move.pointerId !== down.pointerId) return
      const [wide, high] = [move.clientX - down.clientX, move.clientY - down.clientY].map(Math.abs)
      if (isSelecting) {
        const head = view.posAtCoords({x: move.clientX, y: move.clientY}, false)
        view.dispatch({selection: {anchor: pressed, head}, userEvent: "select.pointer"})
      } else if (Math.max(wide ?? 0, high ?? 0) >= dragDistance) {
        isSelecting = (high ?? 0) > (wide ?? 0)
        if (isSelecting) return
        stop.abort()
        dragNumber(view.scrollDOM, down, numberOf(view), listener)
      }
    },
    listen,
  )
  window.addEventListener("pointerup", () => stop.abort(), listen)
  window.addEventListener("pointercancel", () => stop.abort(), listen)
}

/// Changes the number at the cursor by some steps.
const step =
  (steps: number): Command =>
  view => {
    const place = numberAtCursor(view.state)
    if (place === null) return false
    numberOf(view).set(withSteps(place.literal, steps))
    return true
  }

export function numberDragging(dragging: NumberDragging): Extension {
  // One function for all grips: the view of a tooltip stays while its function does, also when the text changes.
  const create = (view: EditorView) => ({
    dom: makeNumberGrip(dragging.hint, numberOf(view), dragging),
  })
  const tooltipOf = (state: EditorState): Tooltip | null => {
    const place = numberAtCursor(state)
    return place === null ? null : {pos: place.from, above: false, create}
  }
  const grip = StateField.define<Tooltip | null>({
    create: tooltipOf,
    update(before, transaction) {
      if (!transaction.docChanged && transaction.selection === undefined && !transaction.reconfigured)
        return before
      const now = tooltipOf(transaction.state)
      return now !== null && before !== null && now.pos === before.pos ? before : now
    },
    provide: field => showTooltip.from(field),
  })
  const keys = keymap.of([
    {key: ownKeys.more, run: step(1)},
    {key: ownKeys.less, run: step(-1)},
  ])
  return [grip, digitDragging(dragging), keys]
}
