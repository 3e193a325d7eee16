/// Blocks beside Haskell that blocks cannot say: what text brings into scope is known, and nothing is called wrong that only GHC can judge.

import {describe, expect, test} from "vitest"
import {modulesFromGhc, packageDatabase} from "../scripts/ghc.ts"
import {infer, toHaskell} from "../src/index.ts"
import {openView, workspaceOf} from "../src/reader/index.ts"
import {modules} from "../src/types/environment/modules.generated.ts"
import {testReader} from "./reader/open.ts"

const reader = await testReader()
const run = "\n\nmain = simulate (Velocity 1 1)\n"

/// What a learner would see: problems, and the types on the headers.
function seen(text: string): {problems: string[]; types: string[]} {
  const workspace = workspaceOf(openView(reader, text + run))
  const {problems, definitions} = infer(workspace)
  return {
    problems: problems.map(p => p.message),
    types: [...definitions.values()].flatMap(d => (d.name === "main" ? [] : [`${d.name} :: ${d.type}`])),
  }
}

describe("what only GHC can judge is never called wrong", () => {
  test.each([
    [
      "a synonym with variables of its own",
      "type Handler e = forall a. e a -> a\n\ntype Two e = (Handler e, Int)\n\nwith :: Handler Maybe -> Maybe Int -> Int\nwith h e = h e\n\nboth :: Two Maybe -> Int\nboth (_, n) = n",
    ],
    [
      "the methods of a class at types of their own",
      'data Mode = Go | Stop\n\ninstance Show Mode where\n  show Go = "go"\n  show Stop = show (1 + 2)',
    ],
    [
      "a class of one's own, and what it needs",
      "class Shape a where\n  area :: a -> Double\n  area = const 0\n\nnewtype Circle = Circle Double\n\ninstance Shape Circle where\n  area (Circle r) = pi * square r\n    where\n      square x = x * x\n\nbig :: Shape a => a -> Bool\nbig s = area s > 1",
    ],
    [
      "many branches, and a function that looks at its input",
      "f :: Double -> LedColor\nf d = if | d < 1 -> Red\n         | Just e <- Just d, e < 2 -> Orange\n         | otherwise -> Green\n\ng :: Maybe Int -> Int\ng = \\case\n  Just n -> n\n  Nothing -> 0",
    ],
  ])("%s", (_, text) => {
    expect(seen(text).problems).toEqual([])
  })

  test("but what is wrong inside of a method or a branch is", () => {
    expect(
      seen('data M = M\n\ninstance Show M where\n  show M = if \'a\' then "x" else "y"').problems,
    ).toHaveLength(1)
    expect(seen("f :: Int -> Int\nf d = if | d -> 1\n         | otherwise -> 2").problems).toHaveLength(1)
  })
})

describe("names that text brings into scope", () => {
  test.each([
    ["a module that Rosy allows", "import Data.Char\n\nf x = toUpper x", "f :: Char -> Char"],
    [
      "some names of a module",
      "import Data.List (sortOn, nub)\n\nf xs = sortOn negate (nub xs)",
      "f :: (Num a, Ord a) => [a] -> [a]",
    ],
    [
      "a qualified module",
      "import qualified Data.Map as Map\n\nf = Map.insert 'a' True Map.empty",
      "f :: Map Char Bool",
    ],
    [
      "what is qualified after its name",
      "import Data.Set qualified as Set\n\nf xs = Set.size (Set.fromList xs)",
      "f :: Ord a => [a] -> Int",
    ],
    [
      "a class and its instance",
      "class Shape a where\n  area :: a -> Double\n\ninstance Shape Bool where\n  area _ = 1\n\nf = area True + 2",
      "f :: Double",
    ],
    ["a constructor between its parts", "data P = E | Int :> P\n\nf E = E\nf (x :> p) = E", "f :: P -> P"],
    [
      "two dots for all parts",
      "data R = R {part :: Double}\n\nf :: R -> Double\nf R {..} = part + 1",
      "f :: R -> Double",
    ],
    [
      "a type with variables of its own",
      'f :: (forall a. [a] -> Int) -> Int\nf g = g [1] + g "a"',
      "f :: (forall a. [a] -> Int) -> Int",
    ],
    [
      "a constructor that says more about the type",
      "data E a where\n  N :: Int -> E Int\n\nf :: E a -> a\nf (N n) = n + 1",
      "f :: E a -> a",
    ],
    ["an argument that is kept as text", "f x = map [q|w|] (words x)", "f :: String -> [a]"],
    ["a tuple with an open part", "f x = map (,True) (words x)", "f :: String -> [(String, Bool)]"],
    ["a type for a function", 'f = read @Int "1" + length "a"', "f :: Int"],
    ["a pattern through a function", "f (words -> w : _) = w\nf _ = []", "f :: String -> String"],
    ["a pattern with a type", "f (x :: Int) !y = (x, y)", "f :: Int -> a -> (Int, a)"],
    ["parts under their own names", "data R = R {part :: Double}\n\nf R {part} = part", "f :: R -> Double"],
    [
      "a function of another language",
      'foreign import ccall unsafe "sin" c_sin :: Double -> Double\n\nf x = c_sin x',
      "f :: Double -> Double",
    ],
    [
      "a function that looks at its input",
      "f x = map (\\case\n  \"one\" -> 'a'\n  _ -> 'b') (words x)",
      "f :: String -> String",
    ],
    [
      "an operator",
      "infixl 6 <+>\n(<+>) :: Double -> Double -> Double\na <+> b = a * b\n\nf x = x <+> 2",
      "f :: Double -> Double",
    ],
    ["a strict type", "data Vec = Vec !Double !Double\n\nf (Vec a _) = Vec a a", "f :: Vec -> Vec"],
    [
      "a record with strict parts",
      "data Vec = Vec {east, north :: !Double}\n\nf v = east v",
      "f :: Vec -> Double",
    ],
    [
      "an instance of a known class",
      "data Vec = Vec !Double\n\ninstance Num Vec where\n  fromInteger n = Vec (fromInteger n)\n\nf = Vec 1 + 2",
      "f :: Vec",
    ],
  ])("%s", (_, text, type) => {
    const {problems, types} = seen(text)
    expect(problems).toEqual([])
    expect(types).toContain(type)
  })

  test.each([
    ["an unknown module", "import Mystery\n\nf x = mystery x + puzzle"],
    ["names of an unknown module", "import Mystery (mystery, Riddle (..))\n\nf = mystery 3"],
    ["an unknown qualified module", "import qualified Mystery as M\n\nf = M.solve (M.Riddle 1)"],
    ["a definition without a type", "p = \\case\n  1 -> 2\n  _ -> 3\n\nf = p 3 + p 4"],
    ["a type with a class in it", "data Any = forall a. Show a => Any a\n\nf (Any x) = Any 3"],
    ["a type by its constructors' types", "data Sum where\n  Sum :: Int -> Sum\n\nf (Sum n) = Sum (n + 1)"],
    ["a name the Prelude would have", "import Prelude hiding (lookup)\n\nlookup x = x + 1"],
    [
      "a name that gives way",
      "data Side = Left | Right\n\nlookup x = x + 1\n\nf Left = lookup 1\nf Right = 2",
    ],
    ["a pattern of text", "f !x = x\n\ng = f 3"],
  ])("%s is no problem", (_, text) => expect(seen(text).problems).toEqual([]))

  test("what a program imports by its module's name does not give way", () => {
    expect(seen("import Prelude\n\nlookup x = x + 1").problems).toEqual([])
    expect(seen("import Prelude\n\nlookup x = x + 1\n\nf = lookup 2").problems).toEqual([
      "Haskell itself has a `lookup` already.",
    ])
    expect(seen("import Prelude (lookup)\n\nfilter x = x + 1").problems).toEqual([])
  })
  test("a name that nothing brings is still a problem", () => {
    expect(seen("import Data.Char (toUpper)\n\nf = toLower 'a'").problems).toEqual([
      "`toLower` has no meaning here.",
    ])
    expect(seen("import qualified Data.Map as Map\n\nf = Nap.empty").problems).toEqual([
      "`Nap.empty` has no meaning here.",
    ])
    expect(seen("import Data.Char\n\nf = toUpper True").problems).toEqual([
      "Here goes a character, and `True` is a yes or no.",
    ])
  })
})

describe("what is printed", () => {
  const print = (text: string) => toHaskell(workspaceOf(openView(reader, text + run))).text
  test("no signature names a type that is not in scope without a dot", () =>
    expect(print("import qualified Data.Map as Map\n\nf = Map.insert 'a' True Map.empty")).not.toMatch(
      /f ::/,
    ))
  test("no signature for what only GHC knows", () =>
    expect(print("import Mystery\n\nf x = mystery x")).not.toMatch(/f ::/))
  test("nothing is derived that the text has an instance of", () => {
    const text = "data Mode = Go | Stop\n\ninstance Eq Mode where\n  _ == _ = True\n\nf = Go == Stop"
    expect(print(text)).toMatch(/^data Mode = Go \| Stop$/m)
  })
})

const database = packageDatabase()
test.skipIf(database === undefined)("the table of modules is not stale", () => {
  const told = modulesFromGhc(database ?? "")
  // The table is made with GHC 9.0. Later libraries have more names, and types that ask for less of their arguments.
  if (/ghc-9\.0\.[^/]*$/.test(database ?? "")) expect(told).toEqual(modules)
  else
    expect(
      Object.keys(modules).flatMap(name => {
        const there = namesOf(told, name)
        return [...namesOf(modules, name)].filter(n => !there.has(n)).map(n => `${name}.${n}`)
      }),
    ).toEqual(["Data.Semigroup.Option", "Data.Semigroup.option"])
})

/// The names in a table's lines of a module: not those that a package keeps to itself, and of a class only its methods.
function namesOf(table: {readonly [module: string]: string}, name: string): ReadonlySet<string> {
  const lines = table[name] ?? ""
  if (lines.startsWith("=")) return namesOf(table, lines.slice(1))
  return new Set(
    lines.split("\n").flatMap(line => {
      const found = /^(?:(?:data|newtype|type) )?(\S+)/.exec(line)?.[1] ?? ""
      return found === "class" || /^[\w-]+-[\d.]+:/.test(found) ? [] : [found]
    }),
  )
}

describe("a method has the type that its class gives it", () => {
  test.each([
    ['instance Show M where\n  show m = "m"', "show :: M -> String"],
    ["instance Ord M where\n  compare a b = EQ", "compare :: M -> M -> Ordering"],
    [
      "newtype Box a = Box a\n\ninstance Show a => Show (Box a) where\n  show (Box a) = show a",
      "show :: Show a => Box a -> String",
    ],
    [
      "newtype Box a = Box a\n\ninstance Functor Box where\n  fmap f (Box a) = Box (f a)",
      "fmap :: (a -> b) -> Box a -> Box b",
    ],
    [
      "newtype Box b = Box b\n\ninstance Foldable Box where\n  foldMap f (Box x) = f x",
      "foldMap :: Monoid m => (a -> m) -> Box a -> m",
    ],
    [
      "class Shape a where\n  area :: a -> Double\n\ninstance Shape M where\n  area _ = 1",
      "area :: M -> Double",
    ],
    [
      "class Far a where\n  to :: a -> b -> b\n\ninstance Far [b] where\n  to bs x = x",
      "to :: [b] -> b' -> b'",
    ],
  ])("%s", (text, type) => {
    expect(seen(`data M = M\n\n${text}`)).toEqual({problems: [], types: [type]})
  })

  test.each([
    ["a value of another type", "instance Show M where\n  show m = 5"],
    ["a pattern of another type", 'instance Show M where\n  show 1 = "one"'],
    ["one input too many", 'instance Show M where\n  show m n = ""'],
    [
      "more than the instance promises",
      "newtype Box a = Box a\n\ninstance Show (Box a) where\n  show (Box a) = show a",
    ],
    [
      "a class without the one that it builds on",
      "newtype Box a = Box a\n\ninstance Monad Box where\n  Box a >>= f = f a",
    ],
    ["what the class does not ask for", 'instance Show M where\n  move m = "m"'],
    [
      "what a class of one's own does not ask for",
      "class C a where\n  c :: a\n\ninstance C M where\n  c = M\n  d = M",
    ],
    ["a pattern", 'instance Show M where\n  show m = "m"\n  (a, b) = (1, 2)'],
    ["the same twice", 'instance Show M where\n  show m = "m"\n  showsPrec _ _ = id\n  show m = "n"'],
    ["another type than the class asks for", "instance Show M where\n  show :: M -> Int\n  show m = 1"],
    ["more than its own type promises", 'instance Show M where\n  show :: a -> String\n  show M = ""'],
    ["a second instance", 'instance Show M where\n  show m = "m"\n\ninstance Show M where\n  show m = "n"'],
    ["an instance of what is derived", 'data N = N deriving (Show)\n\ninstance Show N where\n  show m = "m"'],
  ])("%s is wrong", (_, text) => {
    expect(seen(`data M = M\n\n${text}`).problems.length).toBeGreaterThan(0)
  })

  test("what a class builds on is derived", () => {
    const text = "data M = M\n\ninstance Ord M where\n  compare _ _ = EQ"
    expect(toHaskell(workspaceOf(openView(reader, text + run))).text).toContain("deriving (Eq)")
  })
})

test("what stands by hand is not derived once more", () => {
  const text = "data M = M Int\n\ninstance Eq M where\n  M a == M b = a == b\n\nf :: M -> Bool\nf m = m > M 1"
  expect(toHaskell(workspaceOf(openView(reader, text + run))).text).toContain(
    "data M = M Int deriving (Ord)\n",
  )
})
