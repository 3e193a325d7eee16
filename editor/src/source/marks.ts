/// What is marked in the Haskell pane besides words: the text of the block under the cursor, and the lines of
/// the functions that fire.

import {type Extension, RangeSetBuilder, StateEffect, StateField, type Text} from "@codemirror/state"
import {Decoration, type DecorationSet, EditorView} from "@codemirror/view"

export interface Range {
  readonly start: number
  readonly end: number
}

export const setLinked = StateEffect.define<Range | null>()
export const setGlowing = StateEffect.define<readonly Range[]>()

const linkedLine = Decoration.line({class: "hs-linked-line"})
const linkedText = Decoration.mark({class: "hs-linked"})
const glowingLine = Decoration.line({class: "hs-glowing"})

function lines(builder: RangeSetBuilder<Decoration>, doc: Text, range: Range, mark: Decoration): void {
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
function linked(doc: Text, range: Range): DecorationSet {
  const builder = new RangeSetBuilder<Decoration>()
  lines(builder, doc, range, linkedLine)
  const set = builder.finish()
  const start = Math.min(range.start, doc.length)
  const end = Math.min(range.end, doc.length)
  const line = doc.lineAt(start)
  const whole = start === line.from && end >= line.to
  return whole || start === end ? set : set.update({add: [linkedText.range(start, end)], sort: true})
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

const glowingField = StateField.define<DecorationSet>({
  create: () => Decoration.none,
  update(set, transaction) {
    for (const effect of transaction.effects)
      if (effect.is(setGlowing)) {
        const builder = new RangeSetBuilder<Decoration>()
        const sorted = [...effect.value].sort((a, b) => a.start - b.start)
        for (const range of sorted) lines(builder, transaction.state.doc, range, glowingLine)
        return builder.finish()
      }
    return set.map(transaction.changes)
  },
  provide: field => EditorView.decorations.from(field),
})

export const marks: Extension = [linkedField, glowingField]
