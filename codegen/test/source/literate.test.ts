/// Literate texts become programs with the same code as GHC's own `unlit` finds in them.

import {execFileSync} from "node:child_process"
import {mkdtempSync, readFileSync, rmSync, writeFileSync} from "node:fs"
import {tmpdir} from "node:os"
import {join} from "node:path"
import {expect, test} from "vitest"
import {literateToHaskell} from "../../src/source/literate.ts"

const unlit = join(execFileSync("ghc", ["--print-libdir"], {encoding: "utf8"}).trim(), "bin", "unlit")

/// Lines of code, without what they have in common in front.
function ghcReads(text: string): readonly string[] {
  const folder = mkdtempSync(join(tmpdir(), "rosy-literate-"))
  try {
    writeFileSync(join(folder, "p.lhs"), text)
    execFileSync(unlit, ["-q", join(folder, "p.lhs"), join(folder, "p.hs")])
    return codeOf(readFileSync(join(folder, "p.hs"), "utf8"))
  } finally {
    rmSync(folder, {recursive: true})
  }
}

function codeOf(text: string): readonly string[] {
  const lines = text.split("\n").filter(line => line.trim() !== "" && !/^\s*--/.test(line))
  const indentation = Math.min(...lines.map(line => line.search(/\S/)))
  return lines.map(line => line.slice(indentation).trimEnd())
}

/// The service reads the same texts (`sim-service/tests/run/test_literate_haskell.py`).
const texts: readonly (readonly [string, string, string])[] = JSON.parse(
  readFileSync(new URL("../cases/literate.json", import.meta.url), "utf8"),
)

test.each(texts)("%s", (_, text, program) => {
  const haskell = literateToHaskell(text)
  expect(haskell).toBe(program)
  expect(codeOf(haskell ?? "")).toEqual(ghcReads(text))
})

test.each(texts)("%s, with the line ends of Windows", (_, text) => {
  expect(literateToHaskell(text.replaceAll("\n", "\r\n"))).toBe(literateToHaskell(text))
})

test("prose becomes comments, line for line", () => {
  expect(literateToHaskell("A *robot*.\n\n> f = 1\n\n| and more\n")).toBe(
    "-- A *robot*.\n\nf = 1\n\n-- | and more\n",
  )
})

test("a text without code is no program", () => {
  expect(literateToHaskell("\\begin{code} % first\nf = 1\n\\end{code}\n")).toBeNull()
  expect(literateToHaskell("Only\nprose.\n")).toBeNull()
})
