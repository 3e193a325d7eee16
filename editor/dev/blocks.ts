/// The block view on a page of its own, for looking at and for the browser tests: `/dev/blocks.html`.
///
/// `?tone=dark`, `?small` (the tests' language), `?example=move`, `?empty`, `?untyped` and `?level=haskell` choose what is shown;
/// the view stands at `window.blocks`.

import "@fontsource/inter/400.css"
import "@fontsource/inter/500.css"
import "@fontsource/inter/600.css"
import "@fontsource/inter/700.css"
import "@fontsource/jetbrains-mono/500.css"
import * as codegen from "@rosy/codegen"
import * as Blockly from "blockly/core"
import {fetchReader} from "../src/browser/remote_resources.ts"
import {readHaskell, withBlocks} from "../src/controller/document/document_conversion.ts"
import {type BlocksView, openBlocks} from "../src/views/blocks/index.ts"
import {openClipboard} from "../src/views/blocks/interaction/clipboard.ts"
import {sample, small} from "../test/blocks/small_language.ts"

declare global {
  interface Window {
    blocks: BlocksView
    Blockly: typeof Blockly
    codegen: typeof codegen
    /// Shows a Haskell text as blocks; answers what makes the edits that the view tells of in the document, as the page does.
    openText(haskell: string): Promise<(edit: BlocksEdit) => string>
    /// How often the view told of a change.
    changes: number
    /// Puts the page back to its beginning.
    reset(): void
  }
}

type BlocksEdit = Parameters<Parameters<BlocksView["onChange"]>[0]>[0]

const examples: Record<string, string> = import.meta.glob("../../examples/*/program.rosy", {
  query: "?raw",
  import: "default",
  eager: true,
})

function wanted(): codegen.SavedWorkspace {
  const name = asked.get("example") ?? "accelerateAndPlay"
  const outcome = codegen.parseProject(examples[`../../examples/${name}/program.rosy`] ?? "")
  return outcome.ok ? codegen.openProject(outcome.project).workspace : codegen.newWorkspace()
}

const asked = new URLSearchParams(location.search)
const tone = asked.get("tone") === "dark" ? "dark" : "light"
document.documentElement.dataset.theme = tone
const level = (asked.get("level") ?? "reactions") as codegen.Level
/// Blockly's own checks, for the benchmark to compare with.
const untyped = {
  ...codegen,
  session: () => ({...codegen.session(), checker: () => ({fits: () => ({fits: true}) as const})}),
}
const view = openBlocks(document.getElementById("blocks")!, {
  language: asked.has("small") ? small : asked.has("untyped") ? untyped : codegen,
  tone,
  level,
  clipboard: openClipboard(window.localStorage),
})
const nothing: codegen.SavedWorkspace = {blocks: {languageVersion: 0, blocks: []}}
const first = asked.has("empty") ? nothing : asked.has("small") ? sample : wanted()
view.load(first)
window.blocks = view
window.Blockly = Blockly
window.codegen = codegen
window.openText = async haskell => {
  const reader = await fetchReader()
  if (reader === null) throw new Error("the parser's files cannot be fetched")
  let {document} = readHaskell(reader, "", haskell)
  view.load(document.workspace)
  return ({workspace, inference}) => {
    document = withBlocks(reader, document, workspace, inference).document
    return document.program.text
  }
}
window.changes = 0
window.reset = () => {
  const workspace = Blockly.getMainWorkspace() as Blockly.WorkspaceSvg
  Blockly.hideChaff()
  workspace.getToolbox()?.clearSelection()
  view.mark([])
  view.highlight([])
  view.setLevel(level)
  view.load(nothing)
  workspace.setScale(1)
  view.load(first)
  workspace.scroll(0, 0)
  window.changes = 0
}
view.onChange(() => {
  window.changes++
})
