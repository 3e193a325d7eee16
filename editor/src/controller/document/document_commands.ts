/// Commands that change the open document or the world editor's room: fix, format, rename, drop of a block on the text, undo and redo.

import {codeOf, type SavedBlock} from "@rosy/codegen"
import {formatted} from "@rosy/codegen/reader"
import type {Store} from "../../browser/store.ts"
import {type Fix, fixChanges, mapFix, selectionAfterFix} from "../../program/program.ts"
import {ChangeSet, changesBetween} from "../../program/text_changes.ts"
import {confusableRepair} from "../../state/confusable_repair.ts"
import type {FoundConfusables} from "../../state/page_state.ts"
import {dropEdit} from "../../views/source/drop_edit.ts"
import type {DocumentEditor} from "./document_editor.ts"
import type {PageParts} from "./page_parts.ts"
import {renameSymbol} from "./symbol_rename.ts"

export interface DocumentCommands {
  undo(): void
  redo(): void
  format(): void
  /// Makes this text the program, in one undo step.
  showProgram(text: string): void
  applyFix(fix: Fix): void
  /// Writes what is meant in the place of characters that look right and are not, in one undo step.
  repairCharacters(offered: FoundConfusables): void
  /// Renames the symbol at `offset`; the reason if that is impossible, otherwise `null`.
  rename(offset: number, old: string, name: string): string | null
  /// Shows where the code of a dragged block would be inserted; `x` and `y` are CSS pixels of the window.
  previewDrop(block: SavedBlock, x: number, y: number): void
  drop(block: SavedBlock, x: number, y: number): void
}

export function documentCommands(store: Store, parts: PageParts, editor: DocumentEditor): DocumentCommands {
  const dropAt = (block: SavedBlock, x: number, y: number) => {
    const code = codeOf(block)
    const at = parts.source?.offsetAt(x, y) ?? null
    if (code === undefined || at === null) return null
    const {text} = store.now.document.program
    return {code, text, edit: dropEdit(text, at, code)}
  }
  const showProgram = (text: string) => {
    editor.flush()
    editor.changeText(changesBetween(store.now.document.program.text, text))
  }
  return {
    showProgram,
    undo() {
      if (store.now.worldEditor !== null) return store.dispatch({kind: "world-edited", edit: {kind: "undo"}})
      editor.flush()
      // The steps of the document are those of both who edit it.
      const shared = parts.source?.shared() ?? null
      if (shared !== null) return shared.undo()
      store.dispatch({kind: "undo-pressed"})
      // Text that was typed and undone within one frame leaves the document as it was drawn; the pane still has it.
      editor.showText()
    },
    redo() {
      if (store.now.worldEditor !== null) return store.dispatch({kind: "world-edited", edit: {kind: "redo"}})
      editor.flush()
      const shared = parts.source?.shared() ?? null
      if (shared !== null) return shared.redo()
      store.dispatch({kind: "redo-pressed"})
      editor.showText()
    },
    format() {
      editor.flush()
      if (parts.reader === null) return
      const {text, left} = formatted(parts.reader, store.now.document.program.text)
      showProgram(text)
      if (left > 0) store.dispatch({kind: "notice", notice: {kind: "not-formatted", left}})
    },
    applyFix(fix) {
      // The pending edit moves the positions of the fix.
      const pending = editor.flush()
      const mapped = pending === null ? fix : mapFix(pending, fix)
      editor.changeText(fixChanges(mapped, store.now.document.program.text.length))
      parts.source?.select(selectionAfterFix(mapped))
    },
    repairCharacters(offered) {
      editor.flush()
      editor.changeText(confusableRepair(offered, store.now.document.program.text))
    },
    rename(offset, old, name) {
      editor.flush()
      const answer = renameSymbol(store.now.document, offset, old, name)
      if (!answer.ok) return answer.why
      editor.changeText(answer.changes)
      return null
    },
    previewDrop(block, x, y) {
      const found = dropAt(block, x, y)
      parts.source?.previewDrop(found === null ? null : {code: found.code.text, at: found.edit.from, x, y})
    },
    drop(block, x, y) {
      editor.flush()
      const found = dropAt(block, x, y)
      if (found === null) return
      const {from, to, insert, select} = found.edit
      editor.changeText(ChangeSet.of({from, to, insert}, found.text.length))
      parts.source?.select(select)
    },
  }
}
