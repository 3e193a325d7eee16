/// Texts of walks: programs to begin with, pieces to type, and long pieces to paste.

import {readdirSync, readFileSync} from "node:fs"
import type {Dice} from "../../codegen/test/generate/random.ts"
import {corpus, type Program} from "../../codegen/test/reader/open.ts"

const ofExample = (name: string): Program => ({
  name,
  text: readFileSync(new URL(`../../examples/${name}/Main.hs`, import.meta.url), "utf8"),
})

const examples = [
  "accelerateAndPlay",
  "drawSquare",
  "forwardBackward",
  "mux",
  "randomWalk",
  "safeRandomWalk",
  "wander",
]

const lines = (text: string) => text.split("\n").length

/// A folder of Haskell files to begin with instead of the examples and the corpus.
const folder = process.env["FILES"]

const ofFolder = (path: string): readonly Program[] =>
  readdirSync(path)
    .filter(name => name.endsWith(".hs"))
    .sort()
    .map(name => ({name, text: readFileSync(`${path}/${name}`, "utf8")}))

const isShort = ({text}: Program) => lines(text) < 60 && !/[\r\t]/.test(text)

/// Programs that fit on a few pages. Pasting makes spaces of tabs and one kind of line end.
export const programs: readonly Program[] =
  folder === undefined
    ? [...examples.map(ofExample), ...corpus.filter(isShort)]
    : ofFolder(folder).filter(isShort)

/// More letters each than the editor closes brackets for.
export const snippets: readonly string[] = [
  "-- hi {there}\n",
  "\n-- above\nextra x = x + 1\n",
  "\nextra2 :: Double -> Double\nextra2 y = y * 2 -- twice\n",
  "\n  where z = 3\n",
  "\ndata Mood = Happy | Sad Int\n",
  "\nmain2 = simulate (\\(Bumper _ _) -> Velocity 0 0)\n",
  "{- inside -}",
  " + 1 ",
  "((1))",
  "(1 +",
  " = = ",
  "[1, 2, 3]",
  '"text',
  " if x then",
  "do {a; b}",
  "   ",
  "\n\n\n",
  "{- open",
  " -- tail",
  "let q = 4 in q",
  "case x of _ -> x",
  "::Int",
  "äöü",
  "→ ∷",
]

const manyLines = programs.flatMap(({text}) => text.split("\n"))

/// Three hundred lines: whole programs, or lines that begin and end within one.
export function longText(dice: Dice): {readonly name: string; readonly text: string} {
  const count = 300
  if (dice.once(2)) {
    const from = dice.below(Math.max(1, manyLines.length - count))
    return {
      name: `${count} lines from ${from}`,
      text: `\n${manyLines.slice(from, from + count).join("\n")}\n`,
    }
  }
  const names: string[] = []
  let text = "\n"
  while (lines(text) < count) {
    const program = dice.pick(programs)
    names.push(program.name)
    text += `${program.text}\n`
  }
  return {name: names.join(" + "), text}
}
