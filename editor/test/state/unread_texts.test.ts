/// Edits that follow each other before the compiler has answered: each text that blocks have written is compared in the end.

import {describe, expect, it} from "vitest"
import type {ChangeOrigin, Document} from "../../src/program/history.ts"
import {emptyDocument} from "../../src/program/history.ts"
import {emptyProgram} from "../../src/program/program.ts"
import type {PageEvent} from "../../src/state/page_events.ts"
import type {PageState} from "../../src/state/page_state.ts"
import {hear, open, play} from "./event_player.ts"

/// A program of one-line definitions. The blocks of each group its last two operands.
function documentOf(...lines: readonly string[]): Document {
  const text = lines.join("\n")
  const definitions = lines.map(line => ({
    name: line.slice(0, line.indexOf(" ")),
    start: text.indexOf(line),
    end: text.indexOf(line) + line.length,
    block: line.slice(0, 1),
  }))
  const spans = definitions.flatMap(({start, end, block}) => [
    {start: start + 4, end, block: `${block}1`},
    {start: end - 5, end, block: `${block}2`},
  ])
  return {...emptyDocument, program: {...emptyProgram, text, spans, definitions}}
}

const old = documentOf("f = 0 + 0 + 0", "g = 0 + 0 + 0")
/// The compiler groups `*` before `+`.
const misread = documentOf("f = 1 * 2 + 3", "g = 0 + 0 + 0")
const misreadAndMore = documentOf("f = 1 * 2 + 3", "g = 4 + 5 + 6")
const misreadAndEdited = documentOf("f = 1 * 2 + 7", "g = 0 + 0 + 0")
const good = documentOf("f = 0 + 0 + 0", "g = 4 + 5 + 6")

let clock = 0

/// A step of its own, however fast the machine is.
const edit = (document: Document, by: ChangeOrigin = "blocks"): PageEvent => {
  clock += 10_000
  return {kind: "program-changed", document, by, at: clock}
}

/// The state after the compiler has answered the newest check: products are grouped first, or the text cannot be parsed.
function answered(state: PageState, isParsed = true) {
  const lines = state.document.program.text.split("\n")
  const at = lines.flatMap((line, i) => (isParsed && line.includes("*") ? [[i + 1, 5, i + 1, 10, 0]] : []))
  const answer = {problems: [], declarations: [], parts: [], topics: []}
  return play(
    state,
    hear({
      ...answer,
      op: "checked",
      id: state.checks,
      types: {names: ["Int"], at},
      groups: isParsed ? [] : null,
    }),
  ).state
}

const opened = answered(play(open, edit(old, "command")).state)

describe("an edit that the compiler groups otherwise is taken back", () => {
  const after = (...events: readonly PageEvent[]) => play(opened, ...events).state

  it("when another edit of blocks came before the answer, with that one", () => {
    const state = answered(after(edit(misread), edit(misreadAndMore)))
    expect(state.document).toBe(old)
    expect(state.notice).toMatchObject({kind: "grouped-otherwise", names: ["f"]})
    expect(play(state, {kind: "redo-pressed"}).state.document).toBe(old)
    expect(state.history.past).toEqual(opened.history.past)
  })

  it("when text was edited elsewhere or in it before the answer, and Undo brings the text back", () => {
    for (const typed of [misreadAndMore, misreadAndEdited]) {
      const state = answered(after(edit(misread), edit(typed, "haskell")))
      expect(state.document).toBe(old)
      expect(answered(play(state, {kind: "undo-pressed"}).state).document).toBe(typed)
    }
  })

  it("when text was typed while the answer came", () => {
    const typing = play(after(edit(misread)), {kind: "text-typed", text: misreadAndMore.program.text}).state
    expect(answered(play(answered(typing), edit(misreadAndMore, "haskell")).state).document).toBe(old)
  })

  it("when it was undone before the answer, and made again", () => {
    const undone = answered(play(after(edit(misread)), {kind: "undo-pressed"}).state)
    expect(undone.document).toBe(old)
    expect(answered(play(undone, {kind: "redo-pressed"}).state).document).toBe(old)
  })
})

describe("an edit stays", () => {
  it("of text that the compiler groups otherwise, also beside one of blocks", () => {
    expect(answered(play(opened, edit(misread, "haskell")).state).document).toBe(misread)
    const both = play(opened, edit(good), edit(misreadAndMore, "haskell")).state
    expect(answered(both).document).toBe(misreadAndMore)
  })

  it("of blocks when the text that was edited after it cannot be parsed, and is compared when it can", () => {
    const unparsed = answered(play(opened, edit(misread), edit(misreadAndMore, "haskell")).state, false)
    expect(unparsed.document).toBe(misreadAndMore)
    expect(answered(unparsed).document).toBe(old)
  })

  it("once the compiler has read it", () => {
    const read = answered(play(opened, edit(good)).state)
    expect(read.unread).toEqual([])
    expect(read.document).toBe(good)
  })
})
