/// Values at the ends of lines: what functions took last and gave, as widgets that are no part of the text.

import {type Extension, StateEffect, StateField} from "@codemirror/state"
import {Decoration, type DecorationSet, EditorView, WidgetType} from "@codemirror/view"

export interface LineValue {
  /// The offset of a place in the line.
  readonly at: number
  readonly text: string
  /// The text without folds.
  readonly whole: string
  readonly isOld: boolean
  /// Characters that the widget has room for, so that a line does not wrap anew with each value.
  readonly room: number
}

export const setValues = StateEffect.define<readonly LineValue[]>()

class ValueWidget extends WidgetType {
  private readonly value: LineValue

  constructor(value: LineValue) {
    super()
    this.value = value
  }

  override eq({value}: ValueWidget): boolean {
    const {text, whole, isOld, room} = this.value
    return text === value.text && whole === value.whole && isOld === value.isOld && room === value.room
  }

  override toDOM(): HTMLElement {
    const element = document.createElement("span")
    this.updateDOM(element)
    return element
  }

  override updateDOM(element: HTMLElement): boolean {
    const {text, whole, isOld, room} = this.value
    element.className = isOld ? "hs-value old" : "hs-value"
    element.style.minWidth = `min(${room}ch, 100%)`
    element.title = whole
    if (element.textContent !== text) element.textContent = text
    return true
  }
}

const valuesField = StateField.define<DecorationSet>({
  create: () => Decoration.none,
  update(set, transaction) {
    for (const effect of transaction.effects)
      if (effect.is(setValues)) {
        const {doc} = transaction.state
        const widgets = effect.value.map(value => {
          const {to} = doc.lineAt(Math.min(value.at, doc.length))
          return Decoration.widget({widget: new ValueWidget(value), side: 1}).range(to)
        })
        return Decoration.set(widgets, true)
      }
    return set.map(transaction.changes)
  },
  provide: field => EditorView.decorations.from(field),
})

export const valueWidgets: Extension = valuesField
