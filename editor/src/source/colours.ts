/// The colours of the Haskell pane: each name in the colour its block has. Words are told apart in the whole text, for comments may begin far above; only what
/// is in sight is coloured.

import {type Extension, RangeSetBuilder, StateEffect} from "@codemirror/state"
import {Decoration, type DecorationSet, type EditorView, ViewPlugin, type ViewUpdate} from "@codemirror/view"
import type {Program} from "../state/program.ts"
import {firstWith, type Token, tokens, tokensAfter} from "./lexer.ts"
import {classOf, noPalette, type Palette, paletteOf, wayBack} from "./paint.ts"

/// Tells the pane that its text now is this program's.
export const programShown = StateEffect.define<Program>()

class Colours {
  decorations: DecorationSet
  private text: string
  private words: readonly Token[]
  private palette: Palette = noPalette

  constructor(view: EditorView) {
    this.text = view.state.doc.toString()
    this.words = tokens(this.text)
    this.decorations = this.inSight(view)
  }

  update(update: ViewUpdate): void {
    if (update.docChanged) {
      const change = {from: this.text.length, to: 0}
      update.changes.iterChangedRanges((_fromOld, _toOld, from, to) => {
        change.from = Math.min(change.from, from)
        change.to = Math.max(change.to, to)
      })
      const before = this.text.length
      this.text = update.state.doc.toString()
      this.words = tokensAfter(this.words, this.text, {...change, shift: this.text.length - before})
    }
    let told = false
    for (const transaction of update.transactions)
      for (const effect of transaction.effects)
        if (effect.is(programShown) && effect.value.text === this.text) {
          this.palette = paletteOf(effect.value)
          told = true
        }
    if (told || update.docChanged || update.viewportChanged) this.decorations = this.inSight(update.view)
  }

  private inSight(view: EditorView): DecorationSet {
    const builder = new RangeSetBuilder<Decoration>()
    const {from, to} = view.viewport
    const before = wayBack(this.palette.text, this.text)
    for (let i = firstWith(this.words, token => token.end >= from); i < this.words.length; i += 1) {
      const token = this.words[i] as Token
      if (token.start > to) break
      const word = this.text.slice(token.start, token.end)
      const known = before(token.start, token.end)
      const name = classOf(token, word, known === null ? undefined : this.palette.at(known, word))
      if (name !== null) builder.add(token.start, token.end, markOf(name))
    }
    return builder.finish()
  }
}

const marks = new Map<string, Decoration>()

function markOf(name: string): Decoration {
  const known = marks.get(name)
  if (known !== undefined) return known
  const made = Decoration.mark({class: name})
  marks.set(name, made)
  return made
}

export const colours: Extension = ViewPlugin.fromClass(Colours, {decorations: plugin => plugin.decorations})
