/// Shared text: the text of an editor while the teacher and a pupil edit it together. Changes of both are brought into the order that the service decides; undo takes
/// back one's own changes only; the other's cursor stands in the text with a name. Needs no page.

import {collab, getSyncedVersion, receiveUpdates, sendableUpdates} from "@codemirror/collab"
import {history, redo, undo} from "@codemirror/commands"
import {
  type ChangeDesc,
  ChangeSet,
  type EditorState,
  type Extension,
  StateEffect,
  StateField,
  Transaction,
  type TransactionSpec,
} from "@codemirror/state"
import {Decoration, type DecorationSet, EditorView, WidgetType} from "@codemirror/view"
import type {Cursor, Push, Side, Update, Updates} from "../../wire/classroom/shared_messages.generated.ts"

/// A selection in a version of the text.
export type SharedCursor = Omit<Cursor, "op">

/// Changes that follow a version, one after the other, as CodeMirror writes them.
export type PushedChanges = Omit<Push, "op">

/// Changes that have become versions, from the one after `version` on.
export type SharedUpdates = Omit<Updates, "op">

export interface SharedText {
  /// The changes that the service has not confirmed; `null` when there are none.
  pending(): PushedChanges | null
  /// Applies what the service has confirmed; false when it does not fit this text.
  receive(updates: SharedUpdates): boolean
  /// What is selected; `null` while the service has not confirmed all changes.
  selection(): SharedCursor | null
  /// Shows where the other is. A position in another version is not shown: the other tells it again.
  showCursor(cursor: SharedCursor): void
  /// The line of the other's cursor, from 1; `null` when it is not known.
  otherLine(): number | null
  undo(): void
  redo(): void
}

/// What the shared text needs of an editor.
interface Editor {
  readonly state: EditorState
  dispatch(transaction: Transaction): void
  dispatch(spec: TransactionSpec): void
}

/// Changes that the service takes in one request are fewer than 2000 (protocol §11.1).
const mostChanges = 1000

const setOther = StateEffect.define<Selection | null>()

interface Selection {
  readonly anchor: number
  readonly head: number
}

function movedSelection({anchor, head}: Selection, changes: ChangeDesc, side: -1 | 1): Selection {
  return {anchor: changes.mapPos(anchor, side), head: changes.mapPos(head, side)}
}

const otherSelection = StateField.define<Selection | null>({
  create: () => null,
  update(other, transaction) {
    for (const effect of transaction.effects) if (effect.is(setOther)) return effect.value
    if (other === null || !transaction.docChanged) return other
    // What the other writes stands before the other's cursor, one's own text at the same place after it.
    const side = transaction.annotation(Transaction.remote) === true ? 1 : -1
    return movedSelection(other, transaction.changes, side)
  },
})

class OtherCursor extends WidgetType {
  private readonly name: string

  constructor(name: string) {
    super()
    this.name = name
  }

  override eq({name}: OtherCursor): boolean {
    return name === this.name
  }

  override toDOM(): HTMLElement {
    const cursor = document.createElement("span")
    cursor.className = "hs-other-cursor"
    cursor.dataset["testid"] = "other-cursor"
    // The class bar and the board say the line to a screen reader.
    cursor.setAttribute("aria-hidden", "true")
    const name = document.createElement("span")
    name.className = "hs-other-name"
    name.dataset["name"] = this.name
    cursor.append(name)
    return cursor
  }
}

const otherText = Decoration.mark({class: "hs-other-selection"})

function decorationsOf(state: EditorState, name: string): DecorationSet {
  const other = state.field(otherSelection)
  if (other === null) return Decoration.none
  const [from, to] = [Math.min(other.anchor, other.head), Math.max(other.anchor, other.head)]
  const cursor = Decoration.widget({widget: new OtherCursor(name), side: 1}).range(other.head)
  return Decoration.set(from < to ? [otherText.range(from, to), cursor] : [cursor], true)
}

/// What an editor needs for a text of version 0. `name` is the other's.
export function sharedText(side: Side, name: string): Extension {
  return [
    collab({startVersion: 0, clientID: side}),
    history(),
    otherSelection,
    EditorView.decorations.compute([otherSelection], state => decorationsOf(state, name)),
  ]
}

/// Operates an editor that has `sharedText`.
export function openSharedText(editor: Editor): SharedText {
  const target = () => ({state: editor.state, dispatch: (change: Transaction) => editor.dispatch(change)})
  return {
    pending() {
      const updates = sendableUpdates(editor.state).slice(0, mostChanges)
      if (updates.length === 0) return null
      return {
        version: getSyncedVersion(editor.state),
        changes: updates.map(({changes}) => changes.toJSON() as Update["changes"]),
      }
    },
    receive({version, updates}) {
      if (version !== getSyncedVersion(editor.state)) return false
      try {
        const read = updates.map(({by, changes}) => ({clientID: by, changes: ChangeSet.fromJSON(changes)}))
        editor.dispatch(receiveUpdates(editor.state, read))
        return true
      } catch (fault) {
        if (fault instanceof RangeError) return false
        throw fault
      }
    },
    selection() {
      if (sendableUpdates(editor.state).length > 0) return null
      const {anchor, head} = editor.state.selection.main
      return {version: getSyncedVersion(editor.state), anchor, head}
    },
    showCursor({version, anchor, head}) {
      const {state} = editor
      if (version !== getSyncedVersion(state)) return
      const unconfirmed = sendableUpdates(state)
      const length = unconfirmed[0]?.changes.length ?? state.doc.length
      if (anchor > length || head > length) return
      let other: Selection = {anchor, head}
      for (const {changes} of unconfirmed) other = movedSelection(other, changes, -1)
      editor.dispatch({effects: setOther.of(other)})
    },
    otherLine() {
      const other = editor.state.field(otherSelection, false) ?? null
      return other === null ? null : editor.state.doc.lineAt(other.head).number
    },
    undo: () => void undo(target()),
    redo: () => void redo(target()),
  }
}
