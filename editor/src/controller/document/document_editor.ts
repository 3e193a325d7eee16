/// Editor of the open document: applies edits of the text and of the blocks to the document, and shows the result in the other view. Commands that change the document
/// are in `document_commands.ts`; opening another program is in `program_loader.ts`.

import type {Inference, SavedWorkspace} from "@rosy/codegen"
import type {Store} from "../../browser/store.ts"
import {innermostBlock} from "../../program/program.ts"
import {applyChanges, type ChangeSet} from "../../program/text_changes.ts"
import {isPending} from "../../state/messages/preview.ts"
import {awaitsProgram} from "../../state/page_state.ts"
import {sameBlocks} from "../../views/blocks/index.ts"
import {mergeWorkspaces} from "../../views/blocks/workspace/workspace_merge.ts"
import {analysed, withBlocks, withPlaces, withText} from "./document_conversion.ts"
import {type EditDebounce, openEditDebounce} from "./edit_debounce.ts"
import type {PageParts} from "./page_parts.ts"

export interface DocumentEditor {
  readonly typing: EditDebounce
  /// Shows the text of the document at once, so that an edit in the same frame is made in this text.
  showText(changes?: ChangeSet): void
  /// Loads the blocks of the document into the block view if it has others.
  showBlocks(): void
  /// Applies the pending edit of the text to the document; the changes it made, if any.
  flush(): ChangeSet | null
  /// Changes the text by a command, as one undo step.
  changeText(changes: ChangeSet): void
  /// Applies an edit of the blocks to the document.
  blocksEdited(edited: SavedWorkspace, inference: Inference): void
  cursorMoved(offset: number): void
}

export function openDocumentEditor(store: Store, parts: PageParts): DocumentEditor {
  /// The blocks as the block view has them.
  let shown: SavedWorkspace | null = null
  // Behind the frame that shows the key: the next one is not waited for.
  const typing = openEditDebounce(
    () => {
      flush()
      store.drawNow()
    },
    () => isPending(store.now.room.preview),
  )
  store.onFrame(({room}) => {
    if (!isPending(room.preview)) typing.pathSettled()
  })

  const showText = (changes?: ChangeSet) => parts.source?.setProgram(store.now.document.program, changes)
  const showBlocks = () => {
    const {document} = store.now
    if (document.workspace === shown || parts.blocks === null || awaitsProgram(store.now)) return
    const began = performance.now()
    const {moved} = parts.blocks.load(document.workspace)
    const inference = parts.blocks.inference()
    const placed = moved === null ? document : withPlaces(parts.reader, document, moved, inference)
    shown = placed.workspace
    store.dispatch({kind: "analysed", before: document, document: analysed(placed, inference)})
    typing.cost(performance.now() - began)
  }
  const cursorMoved = (offset: number) => {
    const block = innermostBlock(store.now.document.program.spans, {start: offset, end: offset})
    store.dispatch({kind: "selected", block, in: "haskell", at: offset})
  }
  const flush = () => {
    if (parts.reader === null) return null
    const edit = typing.take()
    if (edit === null) return null
    const {text, changes, isOwn} = edit
    const began = performance.now()
    const document = withText(parts.reader, store.now.document, text, changes)
    store.dispatch({kind: "program-changed", document, changes, by: "haskell", at: began})
    // The cursor chooses a block where the learner writes, not where another user does.
    if (parts.source !== null && isOwn) cursorMoved(parts.source.cursor())
    typing.cost(performance.now() - began)
    return changes
  }
  const changeText = (changes: ChangeSet) => {
    const before = store.now.document
    const text = applyChanges(before.program.text, changes)
    if (parts.reader === null || text === before.program.text) return
    const document = withText(parts.reader, before, text, changes)
    store.dispatch({kind: "program-changed", document, changes, by: "command", at: performance.now()})
    showText(changes)
  }
  const blocksEdited = (edited: SavedWorkspace, inference: Inference) => {
    flush()
    if (parts.reader === null || (shown !== null && sameBlocks(edited, shown))) return
    const now = store.now.document.workspace
    const workspace = shown === null || shown === now ? edited : mergeWorkspaces(shown, edited, now)
    const edit = withBlocks(parts.reader, store.now.document, workspace, inference)
    const {document} = edit
    if (edit.kind === "refused") {
      // The blocks go back to what they were.
      store.dispatch({kind: "analysed", before: store.now.document, document})
      store.dispatch({kind: "notice", notice: {kind: edit.reason, names: edit.names}})
      return
    }
    if (document.workspace === workspace) shown = workspace
    store.dispatch({kind: "program-changed", document, by: "blocks", at: performance.now()})
    showText()
  }
  return {typing, showText, showBlocks, flush, changeText, blocksEdited, cursorMoved}
}
