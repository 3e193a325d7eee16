/// Undo and redo through changes of both views.

import fc from "fast-check"
import {describe, expect, it} from "vitest"
import {
  type Document,
  emptyDocument,
  emptyHistory,
  recordChange,
  redo,
  undo,
} from "../../src/program/history.ts"

const named = (text: string): Document => ({...emptyDocument, program: {...emptyDocument.program, text}})

/// Makes changes one second apart, so that each is a step; answers the last document and the history.
function change(texts: readonly string[]) {
  let now = named("start")
  let history = emptyHistory
  texts.forEach((text, i) => {
    history = recordChange(history, now, i % 2 ? "haskell" : "blocks", i * 1000)
    now = named(text)
  })
  return {now, history}
}

describe("the history", () => {
  it("goes back through every document in order, and forward again to where it was", () => {
    fc.assert(
      fc.property(fc.array(fc.string(), {maxLength: 40}), texts => {
        let {now, history} = change(texts)
        const seen = [now.program.text]
        for (let step = undo(history, now); step !== null; step = undo(history, now)) {
          ;({document: now, history} = step)
          seen.unshift(now.program.text)
        }
        expect(seen).toEqual(["start", ...texts])
        for (let step = redo(history, now); step !== null; step = redo(history, now))
          ({document: now, history} = step)
        expect(now.program.text).toBe(texts.at(-1) ?? "start")
      }),
    )
  })

  it("joins what is typed in one go, but not across views", () => {
    let history = recordChange(emptyHistory, named("a"), "blocks", 0)
    history = recordChange(history, named("ab"), "blocks", 300)
    history = recordChange(history, named("abc"), "blocks", 600)
    expect(history.past.map(d => d.program.text)).toEqual(["a"])
    history = recordChange(history, named("abcd"), "haskell", 700)
    expect(history.past.map(d => d.program.text)).toEqual(["a", "abcd"])
  })

  it("forgets the future when something else is done", () => {
    const {now, history} = change(["a", "b"])
    const back = undo(history, now)
    if (back === null) throw new Error("expected a step back")
    expect(recordChange(back.history, back.document, "blocks", 9000).future).toEqual([])
  })

  it("does not join a change to what was undone", () => {
    let history = recordChange(emptyHistory, named("a"), "blocks", 0)
    const back = undo(history, named("b"))
    if (back === null) throw new Error("expected a step back")
    history = recordChange(back.history, back.document, "blocks", 100)
    expect(history.past.map(d => d.program.text)).toEqual(["a"])
  })
})
