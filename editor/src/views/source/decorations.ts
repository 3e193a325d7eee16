/// Line and range decorations of the Haskell pane: the text of the selected block and the lines of functions that fire; and the position of the browser's cursor between
/// decorated elements.

import {
  type Text as DocumentText,
  type EditorState,
  type Extension,
  RangeSet,
  RangeSetBuilder,
  StateEffect,
  StateField,
} from "@codemirror/state"
import {Decoration, type DecorationSet, EditorView} from "@codemirror/view"

export interface Range {
  readonly start: number
  readonly end: number
}

export const setLinked = StateEffect.define<Range | null>()
/// The functions that led to the answer of a question.
export const setExplained = StateEffect.define<readonly Range[]>()
export const setGlowing = StateEffect.define<readonly Range[]>()

const linkedLine = Decoration.line({class: "hs-linked-line"})
const linkedText = Decoration.mark({class: "hs-linked"})
const explainedLine = Decoration.line({class: "hs-why"})
const glowingLine = Decoration.line({class: "hs-glowing"})

function lines(
  builder: RangeSetBuilder<Decoration>,
  doc: DocumentText,
  range: Range,
  mark: Decoration,
): void {
  let at = Math.min(range.start, doc.length)
  const end = Math.min(range.end, doc.length)
  for (;;) {
    const line = doc.lineAt(at)
    builder.add(line.from, line.from, mark)
    if (line.to >= end || line.number === doc.lines) return
    at = line.to + 1
  }
}

/// The lines of a range, and its very words where they are only a part of a line: a definition is shown by its
/// lines alone.
function linked(doc: DocumentText, range: Range): DecorationSet {
  const builder = new RangeSetBuilder<Decoration>()
  lines(builder, doc, range, linkedLine)
  const set = builder.finish()
  const start = Math.min(range.start, doc.length)
  const end = Math.min(range.end, doc.length)
  const line = doc.lineAt(start)
  const whole = start === line.from && end >= line.to
  return whole || start === end ? set : set.update({add: [linkedText.range(start, end)], sort: true})
}

/// Whether the range is already the linked one.
export function isLinked(state: EditorState, range: Range | null): boolean {
  const now = state.field(linkedField)
  return range === null ? now.size === 0 : RangeSet.eq([now], [linked(state.doc, range)])
}

const linkedField = StateField.define<DecorationSet>({
  create: () => Decoration.none,
  update(set, transaction) {
    for (const effect of transaction.effects)
      if (effect.is(setLinked))
        return effect.value === null ? Decoration.none : linked(transaction.state.doc, effect.value)
    return set.map(transaction.changes)
  },
  provide: field => EditorView.decorations.from(field),
})

const glowingField = linesField(setGlowing, glowingLine)
const explainedField = linesField(setExplained, explainedLine)

/// Marks the lines of the ranges that an effect gives, until the next one.
function linesField(effectType: typeof setGlowing, mark: Decoration): StateField<DecorationSet> {
  return StateField.define<DecorationSet>({
    create: () => Decoration.none,
    update(set, transaction) {
      for (const effect of transaction.effects)
        if (effect.is(effectType)) {
          const builder = new RangeSetBuilder<Decoration>()
          const sorted = [...effect.value].sort((a, b) => a.start - b.start)
          for (const range of sorted) lines(builder, transaction.state.doc, range, mark)
          return builder.finish()
        }
      return set.map(transaction.changes)
    },
    provide: field => EditorView.decorations.from(field),
  })
}

export const lineDecorations: Extension = [linkedField, glowingField, explainedField]

export const cursorCorrection: Extension = EditorView.updateListener.of(({view}) => {
  const selection = view.root instanceof Document ? view.root.getSelection() : null
  if (selection === null || !selection.isCollapsed || !view.hasFocus || view.composing) return
  const {focusNode, focusOffset} = selection
  if (!(focusNode instanceof Element) || !view.contentDOM.contains(focusNode)) return
  const letters = lettersBefore(focusNode.childNodes[focusOffset - 1])
  // The same place, only said otherwise: never another one.
  if (letters === null || view.posAtDOM(letters, letters.length) !== view.state.selection.main.head) return
  selection.collapse(letters, letters.length)
})

/// At the break of a wrapped line a cursor has a side. CodeMirror puts the browser's cursor there also after the text has lost the focus, and the browser then gives
/// the text the focus again: what is typed into a block would come into the text. A cursor without a side stays where it is.
export const focusRelease: Extension = EditorView.updateListener.of(({view, focusChanged}) => {
  const {main} = view.state.selection
  if (focusChanged && !view.hasFocus && main.empty && main.assoc !== 0)
    view.dispatch({selection: {anchor: main.head}})
})

/// The text that a node ends with; `null` where it ends with something else.
function lettersBefore(node: Node | undefined | null): Text | null {
  if (node instanceof Text) return node
  if (!(node instanceof HTMLElement) || node.contentEditable === "false") return null
  return lettersBefore(node.lastChild)
}
