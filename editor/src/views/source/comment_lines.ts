/// Comments of the teacher in the Haskell pane: the lines that they are about, and below each of them what was said. No part of the text.

import {type Extension, StateEffect, StateField} from "@codemirror/state"
import {Decoration, type DecorationSet, EditorView, WidgetType} from "@codemirror/view"

export interface CommentOnLine {
  readonly range: {readonly start: number; readonly end: number}
  readonly text: string
}

export const setComments = StateEffect.define<readonly CommentOnLine[]>()

class CommentWidget extends WidgetType {
  private readonly text: string

  constructor(text: string) {
    super()
    this.text = text
  }

  override eq({text}: CommentWidget): boolean {
    return text === this.text
  }

  override toDOM(): HTMLElement {
    const element = document.createElement("div")
    element.className = "hs-teacher-comment"
    element.dataset["testid"] = "comment-in-text"
    element.textContent = this.text
    return element
  }
}

const commentedLine = Decoration.line({class: "hs-commented"})
const commentedText = Decoration.mark({class: "hs-commented-text"})

export const commentLines: Extension = StateField.define<DecorationSet>({
  create: () => Decoration.none,
  update(set, transaction) {
    for (const effect of transaction.effects)
      if (effect.is(setComments)) {
        const {doc} = transaction.state
        const marks = effect.value.flatMap(({range, text}) => {
          const start = Math.min(range.start, doc.length)
          const end = Math.min(Math.max(range.end, start), doc.length)
          const line = doc.lineAt(start)
          const widget = Decoration.widget({widget: new CommentWidget(text), side: 1, block: true})
          const words =
            start < Math.min(end, line.to) ? [commentedText.range(start, Math.min(end, line.to))] : []
          return [commentedLine.range(line.from), ...words, widget.range(line.to)]
        })
        return Decoration.set(marks, true)
      }
    return set.map(transaction.changes)
  },
  provide: field => EditorView.decorations.from(field),
})
