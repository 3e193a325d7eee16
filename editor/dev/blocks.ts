/// The block view on a page of its own, for looking at and for the browser tests: `/dev/blocks.html`.
///
/// `?tone=dark` and `?small` (the tests' language) choose what is shown; the view stands at `window.blocks`.

import "@fontsource/inter/400.css"
import "@fontsource/inter/500.css"
import "@fontsource/inter/600.css"
import "@fontsource/inter/700.css"
import "@fontsource/jetbrains-mono/500.css"
import * as Blockly from "blockly/core"
import {type BlocksView, openBlocks} from "../src/blocks/index.ts"
import {sample, small} from "../test/blocks/small.ts"

declare global {
  interface Window {
    blocks: BlocksView
    Blockly: typeof Blockly
    changes: number
  }
}

const asked = new URLSearchParams(location.search)
const tone = asked.get("tone") === "dark" ? "dark" : "light"
document.documentElement.dataset.theme = tone
const view = openBlocks(document.getElementById("blocks")!, {language: small, tone})
if (!asked.has("empty")) view.load(sample)
window.blocks = view
window.Blockly = Blockly
window.changes = 0
view.onChange(() => {
  window.changes++
})
