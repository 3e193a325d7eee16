/// Values at the ends of lines: what functions took last and gave, as widgets that are no part of the text; and marks of the branches that they took.

import {type Extension, StateEffect, StateField} from "@codemirror/state"
import {Decoration, type DecorationSet, EditorView, ViewPlugin, WidgetType} from "@codemirror/view"

export interface LineValue {
  /// The offset of a place in the line, and the block that the values belong to.
  readonly at: number
  readonly block: string
  readonly text: string
  /// The text without folds.
  readonly whole: string
  readonly isOld: boolean
  /// Characters that the widget has room for, so that a line does not wrap anew with each value.
  readonly room: number
}

/// The branches that functions took; an outer range stands before those in it.
export const setTaken = StateEffect.define<readonly {readonly start: number; readonly end: number}[]>()

export const setValues = StateEffect.define<readonly LineValue[]>()

class ValueWidget extends WidgetType {
  private readonly value: LineValue

  constructor(value: LineValue) {
    super()
    this.value = value
  }

  override eq({value}: ValueWidget): boolean {
    const {text, whole, isOld, room, block} = this.value
    return (
      text === value.text &&
      whole === value.whole &&
      isOld === value.isOld &&
      room === value.room &&
      block === value.block
    )
  }

  override toDOM(): HTMLElement {
    const element = document.createElement("span")
    this.updateDOM(element)
    return element
  }

  override updateDOM(element: HTMLElement): boolean {
    const {text, whole, isOld, room, block} = this.value
    element.dataset["block"] = block
    element.className = isOld ? "hs-value old" : "hs-value"
    element.style.minWidth = `min(${room}ch, 100% - 1.5ch)`
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

const takenText = Decoration.mark({class: "hs-taken"})

const takenField = StateField.define<DecorationSet>({
  create: () => Decoration.none,
  update(set, transaction) {
    for (const effect of transaction.effects)
      if (effect.is(setTaken)) {
        const {length} = transaction.state.doc
        const marks = effect.value.flatMap(({start, end}) =>
          start < Math.min(end, length) ? [takenText.range(start, Math.min(end, length))] : [],
        )
        return Decoration.set(marks, true)
      }
    // A branch is told of the text that ran.
    return transaction.docChanged ? Decoration.none : set
  },
  provide: field => EditorView.decorations.from(field),
})

/// A click or a tap on a value asks why it is so; CodeMirror leaves events in widgets alone.
export const valueWidgets = (clicked: (block: string) => void): Extension => [
  valuesField,
  takenField,
  ViewPlugin.define(({dom}) => {
    const onClick = ({target}: MouseEvent) => {
      const value = target instanceof Element ? target.closest<HTMLElement>(".hs-value") : null
      const block = value?.dataset["block"]
      if (block !== undefined) clicked(block)
    }
    dom.addEventListener("click", onClick)
    return {destroy: () => dom.removeEventListener("click", onClick)}
  }),
]
