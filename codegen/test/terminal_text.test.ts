/// Nothing that a file says gives orders to a terminal.

import {expect, it} from "vitest"
import {commands} from "../src/commands.ts"
import {neutralize} from "../src/terminal_text.ts"

it("puts a sign in the place of each control character", () => {
  expect(neutralize("a\u001b[2J\tb\n\u009bc\u007f\ud800 \u{1f600}é")).toBe(
    "a\ufffd[2J\tb\n\ufffdc\ufffd\ufffd \u{1f600}é",
  )
})

it("needs it: messages name files", () => {
  const outcome = commands("to-haskell", ["\u001b[2J.rosy"], () => {
    throw new Error("missing")
  })
  expect(outcome.err).toContain("\u001b")
  expect(neutralize(outcome.err)).not.toContain("\u001b")
})
