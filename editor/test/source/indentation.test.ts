/// Where a new line of Haskell begins.

import {existsSync, readdirSync, readFileSync} from "node:fs"
import {fileURLToPath} from "node:url"
import {describe, expect, it} from "vitest"
import {indentBelow} from "../../src/views/source/indentation.ts"

const examples = fileURLToPath(new URL("../../../examples/", import.meta.url))

describe("a new line", () => {
  it.each([
    ["play (Bumper _ Pressed) =", 2],
    ["  case mode of", 4],
    ["main = do -- drive", 2],
    ["main = do drive", 10],
    ["  | hit = Velocity 0 0", 2],
    ["  where", 4],
    ["  where rest = goal", 8],
    ["redo x", 2],
    ["f x", 2],
    ["f :: Int ->", 2],
    ["f ::\n  Int ->\n  Int ->", 2],
    ["f ::\n  Int ->\n  Int", 0],
    ["xs = map f [", 2],
    ["xs = [ 1", 2],
    ["xs =\n  [ 1,\n    2\n  ]", 2],
    ["  drive 0.5", 2],
    ["  drive 0.5\n", 0],
    ["-- a remark", 0],
    ['x = say "do"', 0],
    ["", 0],
  ])("below %j stands at column %i", (above, column) => {
    expect(indentBelow(above.split("\n"), "")).toBe(column)
  })

  it.each([
    ["f x", "|", 2],
    ["f x\n  | x = 1", "|", 2],
    ["data A\n  = B", "|", 2],
    ["f x\n  | x = 1\n  | otherwise = y", "where", 2],
    ["f x = y", "where", 2],
    ["f x =\n  if x", "else ", 4],
    ["f x =\n  if x\n    then y", "else ", 4],
    ["f x =\n  let y = x\n      z = y", "in ", 2],
    ["xs =\n  [ 1", "]", 2],
    ["f x = y", "in ", 0],
  ])("below %j that begins with %j stands at column %i", (above, word, column) => {
    expect(indentBelow(above.split("\n"), word)).toBe(column)
  })

  it("stands where it must when an example is typed line by line", () => {
    const elsewhere: string[] = []
    for (const name of readdirSync(examples).filter(n => existsSync(`${examples}${n}/Main.hs`))) {
      const lines = readFileSync(`${examples}${name}/Main.hs`, "utf8").trimEnd().split("\n")
      lines.forEach((line, i) => {
        if (line.trim() === "") return
        const fresh = indentBelow(lines.slice(0, i), "")
        const word = /^\s*(\||where|deriving|(?:then|else|in) )/.exec(line)?.[1]
        const found = word === undefined ? fresh : indentBelow(lines.slice(0, i), " ".repeat(fresh) + word)
        // That a body is over and another equation or step begins, or that a value goes on further in, only its author knows.
        const column = line.search(/\S/)
        const above = (lines[i - 1] ?? "").search(/\S/)
        const ends = column < above && lines.slice(0, i).some(earlier => earlier.search(/\S/) === column)
        const goesOn = found === above && column > above
        if (found !== column && !ends && !goesOn) elsewhere.push(`${name}:${i + 1} at ${found}: ${line}`)
      })
    }
    expect(elsewhere).toEqual([])
  })
})
