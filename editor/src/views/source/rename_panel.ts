/// Rename panel (F2): asks for a new name of the word under the cursor and shows why a name is refused.

import {type Extension, StateEffect, StateField} from "@codemirror/state"
import {type EditorView, type KeyBinding, type Panel, showPanel} from "@codemirror/view"
import {tokens} from "@rosy/codegen"
import {ownKeys} from "./shortcuts.ts"

export interface Renamer {
  /// Renames what stands at an offset, everywhere. Answers why not, if not.
  rename(offset: number, old: string, name: string): string | null
  readonly words: {
    label(old: string): string
    readonly rename: string
  }
}

interface Asked {
  readonly old: string
  readonly offset: number
}

const ask = StateEffect.define<Asked | null>()

export function renamePanel(renamer: Renamer): Extension {
  const asked = StateField.define<Asked | null>({
    create: () => null,
    update(value, transaction) {
      for (const effect of transaction.effects) if (effect.is(ask)) return effect.value
      return transaction.docChanged ? null : value
    },
    provide: field =>
      showPanel.from(field, value => (value === null ? null : view => panel(view, value, renamer))),
  })
  return asked
}

export const renameShortcut: KeyBinding = {
  key: ownKeys.rename,
  run(view) {
    const {head} = view.state.selection.main
    const text = view.state.doc.toString()
    const token = tokens(text).find(
      t => t.start <= head && head <= t.end && (t.kind === "name" || t.kind === "type"),
    )
    if (token === undefined || view.state.readOnly) return false
    view.dispatch({
      effects: ask.of({old: text.slice(token.start, token.end), offset: token.start}),
    })
    return true
  },
}

function panel(view: EditorView, {old, offset}: Asked, renamer: Renamer): Panel {
  const dom = document.createElement("form")
  dom.className = "hs-rename"
  const label = document.createElement("label")
  label.textContent = renamer.words.label(old)
  const input = document.createElement("input")
  input.className = "cm-textfield"
  input.value = old
  input.spellcheck = false
  label.append(input)
  const go = document.createElement("button")
  go.className = "cm-button"
  go.textContent = renamer.words.rename
  const why = document.createElement("span")
  why.setAttribute("role", "alert")
  dom.append(label, go, why)
  const close = () => {
    view.dispatch({effects: ask.of(null)})
    view.focus()
  }
  dom.onsubmit = event => {
    event.preventDefault()
    const name = input.value.trim()
    const refused = name === old ? null : renamer.rename(offset, old, name)
    if (refused === null) close()
    else why.textContent = refused.replaceAll("`", "")
  }
  dom.onkeydown = event => {
    if (event.key !== "Escape") return
    event.stopPropagation()
    close()
  }
  return {
    dom,
    top: true,
    mount() {
      input.focus()
      input.select()
    },
  }
}
