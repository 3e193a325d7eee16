/// What the blocks say of a connection that they accept and that only GHC can judge.

import {beforeAll, describe, expect, test} from "vitest"
import type {Reader} from "../src/reader/index.ts"
import {openView, workspaceOf} from "../src/reader/index.ts"
import type {Place, SavedBlock, SavedWorkspace} from "../src/serialized_blocks.ts"
import {InferenceSession} from "../src/workspace/inference/inference_session.ts"
import {everyBlock} from "../src/workspace/inference/workspace_inference.ts"
import {checker} from "../src/workspace/moves/drop_checker.ts"
import {testReader} from "./reader/open.ts"

let reader: Reader
beforeAll(async () => {
  reader = await testReader()
})

/// The socket of the number 42 in a program.
function place(workspace: SavedWorkspace): Place {
  for (const block of everyBlock(workspace))
    for (const [input, {block: inside}] of Object.entries(block.inputs ?? {}))
      if (inside?.extraState?.value === "42" && block.id !== undefined) return {block: block.id, input}
  throw new Error("expected a socket with 42, found none")
}

const number: SavedBlock = {type: "number", id: "new", extraState: {value: "0.5"}}
const named = (name: string): SavedBlock => ({type: "name", id: "new", extraState: {name}})
const gOfShade: SavedBlock = {
  type: "name",
  id: "new",
  extraState: {name: "g", args: 1},
  inputs: {A0: {block: {...named("shade"), id: "two"}}},
}

/// The sentence about a block in place of 42, also when all other definitions are remembered; "refused" where it does not fit.
function said(text: string, block: SavedBlock): string | undefined {
  const workspace = workspaceOf(openView(reader, text))
  const session = new InferenceSession()
  session.inferWorkspace(workspace)
  const verdict = checker(workspace, session).fits(place(workspace), block)
  return verdict.fits ? verdict.doubt : "refused"
}

describe("only GHC knows, and the blocks name the cause", () => {
  const imported = "import Some.Module (blend, Colour)\n"
  test.each<[string, string, SavedBlock, RegExp]>([
    ["the place belongs to an imported function", `${imported}f = blend 42\n`, number, /type of `blend`/],
    [
      "the block is an imported function",
      `${imported}f :: Int\nf = 1 + 42\n`,
      named("blend"),
      /type of `blend`/,
    ],
    [
      "a local name has its type from an imported function",
      `${imported}f :: Int -> Int\nf n = 42\n  where\n    g = blend n\n`,
      named("blend"),
      /type of `blend`/,
    ],
    [
      "a function without a signature has its type from an imported one",
      `${imported}f x = blend x\ng = f 42\n`,
      number,
      /type of `blend`/,
    ],
    [
      "the type of a local definition follows from the block and is used by an imported function",
      `${imported}f :: Int\nf = blend n\n  where\n    n = 42\n`,
      number,
      /type of `blend`/,
    ],
    [
      "the type of a function follows from the block, and another function gives it to an imported one",
      `${imported}f x = x > 42\ng = blend f\n`,
      number,
      /type of `blend`/,
    ],
    [
      "a definition has a signature that cannot be read",
      "{-# LANGUAGE DataKinds #-}\ndata Vec n a = Vec [a]\nf :: Vec 3 Int\nf = 42\n",
      number,
      /types here/,
    ],
    [
      "a type of a module is a number or is none",
      `${imported}f :: Colour -> Colour\nf c = 42\n`,
      number,
      /`Colour` belongs to `Fractional`/,
    ],
    [
      "a class of several types",
      "import Data.Coerce (coerce)\nnewtype Age = Age Int\nf :: Age -> Bool\nf a = coerce 42\n",
      named("a"),
      /belongs to `Coercible`/,
    ],
    [
      "types of one name come from two modules",
      "import qualified Data.Text as T\nimport qualified Data.Text.Lazy as L\nshort :: T.Text\nshort = T.empty\nsize :: L.Text -> Int\nsize t = 1\nf = size 42\n",
      named("short"),
      /type of `Text`/,
    ],
    [
      "a constructor that may say what a variable is",
      "{-# LANGUAGE GADTs #-}\ndata Field a where\n  FInt :: Field Int\n  FBool :: Field Bool\nf :: Field a -> a -> Int\nf FInt n = 42\nf FBool b = 1\n",
      named("n"),
      /types here/,
    ],
    [
      "a definition with a type inside a type",
      "{-# LANGUAGE RankNTypes #-}\nuse :: (forall a. a -> a) -> Int\nuse g = g 42\n",
      number,
      /types here/,
    ],
    [
      "an existential type",
      "{-# LANGUAGE ExistentialQuantification #-}\ndata Shown = forall a. Show a => Shown a\nf :: Shown -> Int\nf (Shown x) = 42\n",
      named("x"),
      /types here|`x`/,
    ],
    [
      "a type of a module may be another name for the type that is wanted",
      `${imported}f :: Colour -> Int\nf c = 42\n`,
      named("c"),
      /type of `Colour`/,
    ],
    [
      "the block makes an imported type and a known one the same elsewhere in the definition",
      `${imported}f :: Colour -> String -> Bool\nf c t = g t 42\n  where\n    g x y = x == y\n`,
      named("c"),
      /type of `Colour`|types here/,
    ],
    [
      "a local name of another definition may be a name of a module as well",
      "import Some.Module\ng :: Int -> Int\ng n = n + 1\nf :: Int\nf = 42\nh shade = shade\n",
      gOfShade,
      /type of `shade`/,
    ],
    [
      "an annotation beyond inference",
      "{-# LANGUAGE RankNTypes #-}\nf :: Int\nf = (42 :: forall a. Num a => a)\n",
      number,
      /types here/,
    ],
  ])("%s", (_, text, block, sentence) => {
    expect(said(text, block)).toMatch(sentence)
  })
})

describe("the blocks promise that it compiles", () => {
  test.each<[string, string, SavedBlock]>([
    ["the type is written", "f :: Double -> Double\nf x = x + 42\n", number],
    ["the type is inferred", "f x = sqrt (x + 42)\n", number],
    [
      "an imported function stands elsewhere in the program",
      "import Some.Module (blend)\ng = blend 1\nf :: Double\nf = 42\n",
      number,
    ],
    [
      "what an imported function gives has a known type here",
      "import Some.Module (blend)\nhalf :: Double -> Double\nhalf x = x / 2\nf = blend (half 42)\n",
      number,
    ],
    [
      "a name of a module that is not read stands in the block, and only there",
      "import Some.Module\ng :: Int -> Int\ng n = n + 1\nf :: Int\nf = 42\n",
      gOfShade,
    ],
    [
      "an imported type where that type is wanted",
      "import Some.Module (Colour)\nf :: Colour -> Colour\nf c = 42\n",
      named("c"),
    ],
    [
      "the class has a written instance",
      "class Size a where\n  size :: a -> Int\ninstance Size Bool where\n  size b = 42\n",
      {type: "number", id: "new", extraState: {value: "7"}},
    ],
    [
      "a local definition has a signature",
      `import Some.Module (blend)\nf :: Int\nf = blend n\n  where\n    n :: Double\n    n = 42\n`,
      number,
    ],
    ["an explicit forall", "{-# LANGUAGE RankNTypes #-}\nf :: forall a. a -> Double\nf x = 42\n", number],
  ])("%s", (_, text, block) => {
    expect(said(text, block)).toBeUndefined()
  })
})
