/// Clips: a definition comes with what it needs and its comments, comes back word for word, and never changes what the other program means.

import {expect, it} from "vitest"
import {clipOf, mergeClip} from "../../src/reader/clips.ts"
import {corpus, testReader} from "./open.ts"

const reader = await testReader()

const source = `-- | A program.
import Data.List (sort)
import Data.Char (toUpper)
import qualified Data.Map as Map

-- How a hit is told.
data Hit = Soft | Hard Int -- for how long

instance Show Hit where
  show Soft = "soft"
  show (Hard n) = "hard " ++ show n

-- Backwards when
-- the robot was hit.
backOff :: Bumper -> Velocity
backOff (Bumper _ Pressed) = Velocity slow 0   -- and back
backOff _ = Velocity 0.2 0

slow :: Double
slow = negate 0.1

unused :: [Int] -> [Int]
unused slow = sort slow

strength :: Hit -> Int
strength (Hard n) = n
strength Soft = 0

main :: IO ()
main = simulate backOff
`

const clip = (name: string, text = source) => clipOf(reader.read(text), name)

it("holds the definition with its comments and what it needs, and nothing else", () => {
  expect(clip("backOff")).toEqual({
    name: "backOff",
    others: ["slow"],
    text: `-- Backwards when
-- the robot was hit.
backOff :: Bumper -> Velocity
backOff (Bumper _ Pressed) = Velocity slow 0   -- and back
backOff _ = Velocity 0.2 0

slow :: Double
slow = negate 0.1
`,
  })
})

it("brings types with their instances, and the imports of which it uses a name", () => {
  const taken = clip("strength")
  expect(taken?.others).toEqual(["Hit"])
  expect(taken?.text).toContain("-- How a hit is told.\ndata Hit = Soft | Hard Int -- for how long")
  expect(taken?.text).toContain('show Soft = "soft"')
  expect(taken?.text).not.toContain("import")
  const unused = clip("unused")
  // A parameter of the same name is not the function.
  expect(unused?.others).toEqual([])
  expect(unused?.text).toMatch(/^import Data.List \(sort\)\n\nunused ::/)
})

it("what runs the program, what is broken and what is not there is no clip", () => {
  expect(clip("main")).toBeUndefined()
  expect(clip("nothing")).toBeUndefined()
  expect(clip("f", "f = (\n")).toBeUndefined()
})

it("comes back word for word before main, with its imports", () => {
  const text = clip("unused")?.text ?? ""
  const merged = mergeClip(
    reader,
    "import Data.Char (toUpper)\n\nmain :: IO ()\nmain = simulate drive\n",
    text,
  )
  expect(merged).toEqual({
    ok: true,
    text: `import Data.Char (toUpper)
import Data.List (sort)

unused :: [Int] -> [Int]
unused slow = sort slow

main :: IO ()
main = simulate drive
`,
    added: ["unused"],
    renamed: [],
    present: [],
  })
  const empty = mergeClip(reader, "", clip("backOff")?.text ?? "")
  expect(empty.ok && empty.text).toBe(clip("backOff")?.text)
})

it("a name that means something else there is renamed in the clip, also where the clip uses it", () => {
  const other = `slow :: Double
slow = 7

backOff2 :: Velocity
backOff2 = Velocity slow 0

backOff = backOff2

main = simulate backOff2
`
  const merged = mergeClip(reader, other, clip("backOff")?.text ?? "")
  expect(merged.ok && merged.renamed).toEqual([
    {from: "backOff", to: "backOff3"},
    {from: "slow", to: "slow2"},
  ])
  expect(merged.ok && merged.text).toContain(`-- the robot was hit.
backOff3 :: Bumper -> Velocity
backOff3 (Bumper _ Pressed) = Velocity slow2 0   -- and back
backOff3 _ = Velocity 0.2 0

slow2 :: Double
slow2 = negate 0.1

main = simulate backOff2`)
  expect(merged.ok && merged.text.startsWith(other.slice(0, other.indexOf("main")))).toBe(true)
})

it("types and constructors that mean something else there are renamed", () => {
  const other = "data Hit = Hit | Hard\n\nmain = simulate strength\n"
  const merged = mergeClip(reader, other, clip("strength")?.text ?? "")
  expect(merged.ok && merged.renamed).toEqual([
    {from: "Hit", to: "Hit2"},
    {from: "Hard", to: "Hard2"},
  ])
  expect(merged.ok && merged.text).toContain("data Hit2 = Soft | Hard2 Int")
  expect(merged.ok && merged.text).toContain("instance Show Hit2 where")
  expect(merged.ok && merged.text).toContain("strength :: Hit2 -> Int\nstrength (Hard2 n) = n")
})

it("what is there already is not put in a second time", () => {
  const again = mergeClip(reader, source, clip("backOff")?.text ?? "")
  expect(again).toEqual({ok: true, text: source, added: [], renamed: [], present: ["backOff", "slow"]})
})

it("a clip of a program changes nothing in that program", () => {
  let count = 0
  for (const {text, name} of corpus.filter(program => program.text.length < 900)) {
    const names = reader.read(text).pieces.flatMap(piece => (piece.kind === "declaration" ? piece.names : []))
    for (const own of new Set(names)) {
      const taken = clip(own, text)
      if (taken === undefined) continue
      count += 1
      const merged = mergeClip(reader, text, taken.text)
      expect(merged.ok && {text: merged.text, renamed: merged.renamed}, `${own} of ${name}`).toEqual({
        text,
        renamed: [],
      })
    }
  }
  expect(count).toBeGreaterThan(20)
})
