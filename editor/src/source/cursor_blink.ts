/// Blinking of the cursor in the Haskell pane, by a timer. CodeMirror's own is an endless animation of the style sheet: for it the browser makes
/// 60 frames a second as long as the pane has the focus, and a key pressed meanwhile waits for the next of them.

import {EditorView, ViewPlugin, type ViewUpdate} from "@codemirror/view"

/// Milliseconds for which the cursor is seen, and for which it is not.
const half = 600

class CursorBlink {
  private readonly view: EditorView
  private timer: ReturnType<typeof setInterval> | undefined

  constructor(view: EditorView) {
    this.view = view
    this.restart()
  }

  update(update: ViewUpdate): void {
    // After a key, and where the cursor goes, it is seen.
    if (update.docChanged || update.selectionSet || update.focusChanged) this.restart()
  }

  destroy(): void {
    clearInterval(this.timer)
  }

  private restart(): void {
    clearInterval(this.timer)
    this.show(true)
    this.timer = this.view.hasFocus
      ? setInterval(() => this.show(this.layer()?.style.visibility === "hidden"), half)
      : undefined
  }

  private show(isSeen: boolean): void {
    const layer = this.layer()
    const visibility = isSeen ? "" : "hidden"
    if (layer !== null && layer.style.visibility !== visibility) layer.style.visibility = visibility
  }

  private layer(): HTMLElement | null {
    return this.view.scrollDOM.querySelector<HTMLElement>(":scope > .cm-cursorLayer")
  }
}

export const cursorBlink = [
  ViewPlugin.fromClass(CursorBlink),
  EditorView.theme({"&.cm-focused > .cm-scroller > .cm-cursorLayer": {animation: "none !important"}}),
]
