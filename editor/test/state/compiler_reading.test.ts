/// An edit of blocks, from the page's state to the real worker and back: what the compiler reads as the blocks stays, and all else is taken back.

import {openView, type Reader, type View} from "@rosy/codegen/reader"
import {beforeAll, describe, expect, it} from "vitest"
import {testReader} from "../../../codegen/test/reader/open.ts"
import {checkAll, hasWorker} from "../../../codegen/test/worker.ts"
import {unanalysed} from "../../src/controller/document/document_conversion.ts"
import type {Document} from "../../src/program/history.ts"
import {readServiceMessage} from "../../src/state/messages/message_decoder.ts"
import {initialState, type PageState} from "../../src/state/page_state.ts"
import {noticeText} from "../../src/ui/descriptions.ts"
import {hear, hello, play} from "./event_player.ts"

const before = "x = f y\n"

/// The blocks of a text, and a text as long that the edit has written.
const edits: readonly (readonly [what: string, blocks: string, text: string, notice: string | undefined])[] =
  [
    ["that the compiler reads as the blocks", "x = f (g y)\n", "x = f (g y)\n", undefined],
    ["with a call in a call", "x = f (g y)\n", "x = f  g y \n", "grouped-otherwise"],
    ["in a text with a type error", "x = 1 (g y)\n", "x = 1  g y \n", "grouped-otherwise"],
    ["that cannot be parsed", "x = f (g y)\n", "x = f )g y(\n", "unreadable-edit"],
    ["of text in a block", "x = f (\\case)\n", "x = f (\\case)\n", undefined],
  ]

let reader: Reader
let answers: ReadonlyMap<string, object>

beforeAll(async () => {
  reader = await testReader()
  const texts = [before, ...edits.map(([, , text]) => text)]
  const checked = hasWorker ? await checkAll(texts) : []
  answers = new Map(texts.map((text, i) => [text, checked[i] ?? {}]))
})

/// The document of these blocks that the page would show if its reader read the text as them.
function documentOf(blocks: string, text: string): Document {
  const view: View = {...openView(reader, blocks), text}
  return unanalysed(view)
}

/// The state after the worker has answered the newest check.
function answered(state: PageState): PageState {
  const answer = answers.get(state.document.program.text)
  const read = readServiceMessage(JSON.stringify({...answer, id: state.checks}))
  if (read.kind !== "ok") throw new Error("expected an answer")
  return play(state, hear(read.value)).state
}

describe.skipIf(!hasWorker)("an edit of blocks", () => {
  it.each(edits)("%s", (_, blocks, text, notice) => {
    const old = documentOf(before, before)
    const opened = answered(play({...initialState, document: old}, hello).state)
    expect(opened.parsed).toEqual([before])
    const edited = documentOf(blocks, text)
    const made = play(opened, {kind: "program-changed", document: edited, by: "blocks", at: 0}).state
    const {document, notice: said} = answered(made)
    expect(document).toBe(notice === undefined ? edited : old)
    expect(said?.kind).toBe(notice)
    if (said !== null) expect(noticeText(said).message).toContain("x")
  })

  it("that cannot be parsed stays when the text could not be parsed before", () => {
    const edited = documentOf("x = f (g y)\n", "x = f )g y(\n")
    const opened = play({...initialState, document: documentOf(before, before)}, hello).state
    const made = play(opened, {kind: "program-changed", document: edited, by: "blocks", at: 0}).state
    expect(answered(made).document).toBe(edited)
  })
})
