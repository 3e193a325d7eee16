/// The backpack: definitions are put in with what they need, and taken out into another program in one undo step.

import {type Clip, clipOf, mergeClip} from "@rosy/codegen/reader"
import type {Store} from "../../browser/store.ts"
import {type BlockId, textRangeOf} from "../../program/program.ts"
import type {BackpackResult} from "../../state/page_state.ts"
import type {BackpackStore, PackedClip} from "../../storage/backpack_store.ts"
import type {Backpack} from "../../ui/app_context.ts"
import type {DocumentCommands} from "../document/document_commands.ts"
import type {DocumentEditor} from "../document/document_editor.ts"
import type {PageParts} from "../document/page_parts.ts"

export interface BackpackCommands extends Backpack {
  /// The definition around a block; `null` where there is none that can be put in.
  definitionAt(block: BlockId): string | null
}

export function openBackpack(
  store: Store,
  parts: PageParts,
  editor: DocumentEditor,
  commands: Pick<DocumentCommands, "showProgram">,
  backpack: BackpackStore,
): BackpackCommands {
  const tell = (result: BackpackResult) =>
    store.dispatch({kind: "notice", notice: {kind: "backpack", result}})
  const pieces = () => store.now.document.view?.module.pieces ?? []
  const clipFor = (name: string): Clip | undefined => {
    editor.flush()
    const {view} = store.now.document
    return view === null || view === undefined ? undefined : clipOf(view.module, name)
  }
  return {
    list: backpack.list,
    candidates: () =>
      pieces().flatMap(({kind, names: [name], broken, declaration: d}) =>
        kind !== "declaration" || broken || d?.kind === "instance" || name === undefined || name === "main"
          ? []
          : [name],
      ),
    definitionAt(block) {
      const range = textRangeOf(store.now.document.program.spans, block)
      const piece = range === null ? undefined : pieces().find(({end}) => range.start < end)
      const [name] = piece?.declaration?.kind === "instance" ? [] : (piece?.names ?? [])
      return name === undefined || name === "main" || piece?.broken === true ? null : name
    },
    open: () => store.dispatch({kind: "dialog", dialog: "backpack"}),
    put(name) {
      const clip = clipFor(name)
      if (clip === undefined) tell({kind: "not-packed", name})
      else if (!backpack.put(clip)) tell({kind: "full"})
      else tell({kind: "packed", name, others: clip.others})
    },
    remove: backpack.remove,
    take({name, text}: PackedClip) {
      editor.flush()
      store.dispatch({kind: "dialog", dialog: null})
      if (parts.reader === null) return
      const merged = mergeClip(parts.reader, store.now.document.program.text, text)
      if (!merged.ok) return tell({kind: "not-unpacked", name, why: merged.why})
      commands.showProgram(merged.text)
      const {added, renamed, present} = merged
      tell({kind: "unpacked", added, renamed, present})
      editor.showBlocks()
      const called = renamed.find(({from}) => from === name)?.to ?? name
      const {definitions} = store.now.document.program
      const block = definitions.find(definition => definition.name === called)?.block
      if (block !== undefined) parts.blocks?.select(block)
    },
  }
}
