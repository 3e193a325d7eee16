/// Drop preview: the dragged code beside the pointer, and a line at its insertion point.

import type {EditorView} from "@codemirror/view"

export interface DropPreview {
  readonly code: string
  /// The offset where it would go.
  readonly at: number
  /// The pointer, in pixels of the window.
  readonly x: number
  readonly y: number
}

/// Pixels between the pointer and what it carries.
const beside = 14

export function openDropPreview(view: EditorView): {show(carried: DropPreview | null): void} {
  let label: HTMLElement | null = null
  let caret: HTMLElement | null = null
  const element = (className: string) => {
    const made = document.createElement("div")
    made.className = className
    made.setAttribute("aria-hidden", "true")
    view.dom.append(made)
    return made
  }
  return {
    show(carried) {
      if (carried === null) {
        label?.remove()
        caret?.remove()
        label = caret = null
        return
      }
      label ??= element("hs-carried")
      caret ??= element("hs-landing")
      label.textContent = carried.code
      const frame = view.dom.getBoundingClientRect()
      label.style.transform = `translate(${carried.x - frame.left + beside}px, ${carried.y - frame.top + beside}px)`
      const place = view.coordsAtPos(carried.at)
      caret.hidden = place === null
      if (place === null) return
      caret.style.transform = `translate(${place.left - frame.left - 1}px, ${place.top - frame.top}px)`
      caret.style.height = `${place.bottom - place.top}px`
    },
  }
}
