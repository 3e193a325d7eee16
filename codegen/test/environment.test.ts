/// The environment is what GHC says, not a list kept by hand.

import {describe, expect, test} from "vitest"
import {browsed, instancesOf} from "../scripts/browse.ts"
import {environmentFromGhc, packageDatabase} from "../scripts/ghc.ts"
import {generated} from "../src/types/environment/environment.generated.ts"
import {library} from "../src/types/environment/standard_library.ts"
import {showScheme} from "../src/types/syntax/type.ts"

const database = packageDatabase()

/// What the Prelude of GHC 9.6 or 9.10 has and that of 9.0, which the environment is made with, has not. Blocks offer what all versions have.
const newer = new Set([
  "foldl' :: Foldable t => (b -> a -> b) -> b -> t a -> b",
  "liftA2 :: Applicative f => (a -> b -> c) -> f a -> f b -> f c",
  "class (a ~ b) => (~) a b",
  "instance Functor ((,,,,) a b c d)",
  "instance Functor ((,,,,,) a b c d e)",
  "instance Functor ((,,,,,,) a b c d e f)",
])

describe("the generated environment", () => {
  // Needs the built library; `./rosy test` builds it first.
  test.skipIf(database === undefined)("is not stale", () => {
    const told = environmentFromGhc(database ?? "").split("\n")
    expect(told.filter(line => !newer.has(line)).join("\n")).toBe(generated)
  })
  test.each([
    ["simulate", "Runnable a => a -> IO ()"],
    ["randomR", "(Random a, RandomGen b) => (a, a) -> b -> (a, b)"],
    ["replicateM_", "Applicative m => Int -> m a -> m ()"],
    ["elem", "(Eq a, Foldable t) => a -> t a -> Bool"],
    ["velocityLinear", "Velocity -> Double"],
  ])("knows %s", (name, type) => {
    const scheme = library.values.get(name)
    expect(scheme === undefined ? "" : showScheme(scheme).replaceAll(/\bg\b/g, "b")).toBe(type)
  })
  test("knows what comes from the Prelude, and which of it a program cannot define anew", () => {
    expect(["lookup", "Just", "Maybe", "+", "Show"].filter(n => !library.prelude.has(n))).toEqual([])
    expect(["say", "Velocity", "when", "Red"].filter(n => library.prelude.has(n))).toEqual([])
    expect(["Maybe", "Show"].filter(n => !library.fixed.has(n))).toEqual([])
    expect(["lookup", "Just", "+", "say", "Velocity"].filter(n => library.fixed.has(n))).toEqual([])
  })
})

describe("reading what GHCi says", () => {
  test("keeps what is in scope and drops modules and strictness", () => {
    expect(
      browsed(
        [
          "type Rosy.Robot.Velocity :: *",
          "data Rosy.Robot.Velocity = Velocity {-# UNPACK #-}Double !Rosy.Robot.Orientation",
          "newtype Task end = Rosy.Core.Task {Rosy.Core.runTask :: forall r. end -> r}",
          "class Foldable t where",
          "  elem :: Eq a => a -> t a -> Bool",
          "  Data.Foldable.fold :: Monoid m => t m -> m",
          "undefined :: GHC.Stack.Types.HasCallStack => a",
        ].join("\n"),
      ),
    ).toEqual([
      "data Velocity = Velocity Double Orientation",
      "newtype Task end",
      "class Foldable t",
      "elem :: (Foldable t, Eq a) => a -> t a -> Bool",
      "undefined :: a",
    ])
  })
  test("keeps instances without their comments and pragmas", () => {
    expect(
      instancesOf(
        "instance [overlappable] Rosy.Command.Command c => Controller c -- Defined in ‘Rosy.Controller’\nclass X a",
      ),
    ).toEqual(["instance Command c => Controller c"])
  })
})
