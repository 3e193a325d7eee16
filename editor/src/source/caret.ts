/// Keeps the browser's cursor where CodeMirror's is. When colours or marks change around it, its letters move into other elements. Chromium then
/// tells a place between two elements and writes the next letter somewhere else: `De`, a mark, `g` became `Dge`. A place inside of the letters is one
/// that it keeps. (CodeMirror itself sets it anew where lines are joined, for the same reason.)

import type {Extension} from "@codemirror/state"
import {EditorView} from "@codemirror/view"

export const caret: Extension = EditorView.updateListener.of(({view}) => {
  const selection = view.root instanceof Document ? view.root.getSelection() : null
  if (selection === null || !selection.isCollapsed || !view.hasFocus || view.composing) return
  const {focusNode, focusOffset} = selection
  if (!(focusNode instanceof Element) || !view.contentDOM.contains(focusNode)) return
  const letters = lettersBefore(focusNode.childNodes[focusOffset - 1])
  // The same place, only said otherwise: never another one.
  if (letters === null || view.posAtDOM(letters, letters.length) !== view.state.selection.main.head) return
  selection.collapse(letters, letters.length)
})

/// The text that a node ends with; `null` where it ends with something else.
function lettersBefore(node: Node | undefined | null): Text | null {
  if (node instanceof Text) return node
  if (!(node instanceof HTMLElement) || node.contentEditable === "false") return null
  return lettersBefore(node.lastChild)
}
