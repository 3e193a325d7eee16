/// An edit of blocks that the compiler groups in another way than the blocks is taken back, and said.

import {describe, expect, it} from "vitest"
import {otherwiseGrouped} from "../../src/program/compiler_groups.ts"
import {type Document, emptyDocument} from "../../src/program/history.ts"
import {emptyProgram, type Program} from "../../src/program/program.ts"
import type {PageEvent} from "../../src/state/page_events.ts"
import {noticeText} from "../../src/ui/descriptions.ts"
import type {TypesAtPlaces} from "../../src/wire/worker.generated.ts"
import {hear, open, play} from "./event_player.ts"

/// A program of one definition, whose blocks are these pieces of its text.
function programOf(text: string, ...pieces: readonly string[]): Program {
  const spans = pieces.map((piece, i) => ({
    start: text.indexOf(piece),
    end: text.indexOf(piece) + piece.length,
    block: `b${i}`,
  }))
  const definitions = [{name: "x", start: 0, end: text.length, block: "def"}]
  return {...emptyProgram, text, spans, definitions}
}

/// Places as the worker tells them: line, column, end line, end column and the number of the type.
function places(text: string, ...pieces: readonly string[]) {
  const place = (offset: number) => {
    const lines = text.slice(0, offset).split("\n")
    return [lines.length, [...(lines.at(-1) ?? "")].length + 1]
  }
  const at = pieces.map(piece => {
    const start = text.indexOf(piece)
    return [...place(start), ...place(start + piece.length), 0]
  })
  return {names: ["Int"], at}
}

function grouped(program: Program, types: TypesAtPlaces, definitions = program.definitions) {
  const reading = {types, groups: null}
  return otherwiseGrouped({...emptyDocument, program}, definitions, reading).map(d => d.name)
}

describe("groups of the compiler", () => {
  const text = "x = a * b + c"
  const whole = "a * b + c"

  it("are those of the blocks, with pieces that only one of the two tells of", () => {
    const program = programOf(text, whole, "a * b", "c")
    expect(grouped(program, places(text, whole, "a * b", "a", "b", "c"))).toEqual([])
    expect(grouped(program, places(text, whole))).toEqual([])
  })

  it("are others than those of the blocks", () => {
    const program = programOf(text, whole, "b + c")
    expect(grouped(program, places(text, whole, "a * b"))).toEqual(["x"])
  })

  it("are compared on later lines and behind characters of two units", () => {
    const later = "x = f 1\n  (g '😀' a * b + c)"
    const told = places(later, "f 1\n  (g '😀' a * b + c)", "1", "'😀'", "g '😀' a * b")
    expect(grouped(programOf(later, "1", "g '😀' a * b"), told)).toEqual([])
    expect(grouped(programOf(later, "1", "b + c"), told)).toEqual(["x"])
  })

  it("do not count in a definition that no edit of blocks has written", () => {
    const program = programOf(text, whole, "b + c")
    expect(grouped(program, places(text, whole, "a * b"), [])).toEqual([])
  })
})

describe("an edit", () => {
  const text = "x = a * b + c"
  const edited: Document = {...emptyDocument, program: programOf(text, "a * b + c", "b + c")}
  const change = (by: "blocks" | "haskell"): PageEvent => ({
    kind: "program-changed",
    document: edited,
    by,
    at: 0,
  })
  const answer = (id: number, ...pieces: readonly string[]) =>
    hear({
      op: "checked",
      id,
      problems: [],
      declarations: [],
      parts: [],
      topics: [],
      types: places(text, ...pieces),
      groups: null,
    })
  const checked = (by: "blocks" | "haskell", ...pieces: readonly string[]) => {
    const {state} = play(open, change(by))
    return play(state, answer(state.checks, ...pieces))
  }

  it("of blocks that the compiler groups otherwise is taken back, said, and not to be made again", () => {
    const {state, sent} = checked("blocks", "a * b")
    expect(state.document).toBe(open.document)
    expect(state.history).toEqual({...open.history, last: null})
    expect(sent).toMatchObject([{op: "check", source: open.document.program.text}])
    expect(state.notice && noticeText(state.notice).message).toContain("x")
    expect(play(state, {kind: "redo-pressed"}).state.document).toBe(open.document)
  })

  it("stays when the compiler groups it as the blocks, when it is one of the text, and while text is typed", () => {
    expect(checked("blocks", "b + c").state.document).toBe(edited)
    expect(checked("haskell", "a * b").state.document).toBe(edited)
    const {state} = play(open, change("blocks"), {kind: "text-typed", text: "x = a"})
    expect(play(state, answer(state.checks, "a * b")).state.document).toBe(edited)
  })
})
