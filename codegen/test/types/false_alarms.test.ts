/// Programs that GHC accepts and inference therefore says nothing about, by kind.

import {beforeAll, expect, test} from "vitest"
import type {Reader} from "../../src/reader/index.ts"
import {openView, workspaceOf} from "../../src/reader/index.ts"
import {infer} from "../../src/workspace/inference/workspace_inference.ts"
import {testReader} from "../reader/open.ts"

let reader: Reader
beforeAll(async () => {
  reader = await testReader()
})

test.each([
  ["a `do` of one step that is no task", "f :: Int -> Int\nf x = do\n  x + 1\n"],
  ["the same with a comment behind the step", "f :: Int -> Int\nf x = do\n  x + 1 -- c\n"],
  ["the same with a comment above the step", "f :: Int -> Int\nf x = do\n  -- c\n  x + 1\n"],
  [
    "record wildcards on the fields of a GADT",
    "{-# LANGUAGE GADTs, RecordWildCards #-}\ndata T where\n  T :: {a :: Int, b, c :: Bool} -> T\n  U :: Int -> T\nf T{..} = a + 1\nf (U n) = n\ng = c\n",
  ],
  [
    "record wildcards on the fields of an existential type",
    "{-# LANGUAGE ExistentialQuantification, RecordWildCards #-}\ndata T = forall e. Show e => T {a :: Int, b :: e}\nf T{..} = a + length (show b)\n",
  ],
  [
    "a family of data in a class, and what its members are made of",
    "{-# LANGUAGE TypeFamilies #-}\nclass Entity r where\n  data Field r t\n  nothing :: r -> Int\ninstance Entity Bool where\n  data Field Bool t where\n    Yes :: Field Bool Int\n    No :: {size :: Int} -> Field Bool Int\n  nothing _ = 0\nf :: Field Bool Int -> Int\nf Yes = 1\nf r = size r\n",
  ],
  [
    "a family of data at the margin, and its members",
    "{-# LANGUAGE TypeFamilies #-}\ndata family List a\ndata instance List Bool = None | Some Bool (List Bool)\nnewtype instance List Int = Count {count :: Int}\nf :: List Bool -> List Int\nf None = Count 0\nf (Some _ r) = Count (1 + count (f r))\n",
  ],
  [
    "classes of several types, with and without members and dependencies",
    "{-# LANGUAGE FunctionalDependencies #-}\nclass Add a b where\n  add :: [a] -> [b] -> [a]\ninstance Num k => Add k k where\n  add x _ = x\nclass Convert a b | a -> b where\n  convert :: a -> b\ninstance Convert Int Bool where\n  convert = (> 0)\nf :: Convert a b => a -> b\nf = convert\n",
  ],
  [
    "a class with a kind",
    "{-# LANGUAGE KindSignatures, DataKinds #-}\nclass Shown (a :: *) where\n  shown :: a -> Int\ninstance Shown Bool where\n  shown _ = 1\nf :: Shown a => a -> Int\nf = shown\n",
  ],
  [
    "a name for types that is an operator of signs that arrows are made of",
    "{-# LANGUAGE TypeOperators, RankNTypes #-}\ntype f ==> g = forall z. f z -> g z\nf :: (a ==> b) -> a x -> b x\nf g = g\n",
  ],
  [
    "a constructor that is an operator, with fields",
    "data V a = N | (:>>) { hd :: a, tl :: V a }\nf :: V Int -> V Int\nf N = 1 :>> N\nf (x :>> _) = x :>> N\n",
  ],
  [
    "what the constructor of a GADT says about a variable",
    "{-# LANGUAGE GADTs #-}\ndata Field a where\n  FInt :: Field Int\n  FBool :: Field Bool\nf :: Field a -> a -> Bool\nf FInt n = n > (1 :: Int)\nf FBool b = not b\ng :: Field a -> a -> a\ng t x = case t of\n  FInt -> x + 1\n  FBool -> not x\n",
  ],
  [
    "operators of a module that is not read, whose precedence only GHC knows",
    'import Some.Module\nf x = x + 1 =~= 1 + x |&| x * 2 =~= 2 * x\ng :: [Int] -> Check\ng xs = length xs > 0 |> not (null xs) |&| True\nh :: Int\nh = length $ words "a" |+| "b" ++ "c"\n',
  ],
  [
    "a function that an imported one passes and that is used at two types",
    "import Some.Module (mask, (>>>=))\nf :: IO a -> IO b -> (a -> b) -> IO b\nf one two g = mask $ \\restore -> do\n  x <- restore one\n  y <- restore two\n  return (if True then y else g x)\n",
  ],
  [
    "a GADT with a kind, whose constructors have contexts",
    "{-# LANGUAGE GADTs, KindSignatures #-}\ndata Term a where\n  Word' :: String -> Term Integer\n  Equals :: (Eq a) => Term a -> Term a -> Term Bool\ndata Eql :: * -> * where\n  Eql :: Eq b => b -> Eql b\nf :: Term a -> Eql b -> Int\nf t e = 1\n",
  ],
  [
    "a name of the Prelude that is defined anew and used with a qualifier",
    "module Main where\nimport Prelude hiding (sum)\nfoldr :: (a -> b -> b) -> b -> [a] -> b\nfoldr f z [] = z\nfoldr f z (x:xs) = f x (Main.foldr f z xs)\nand p q = p q\nsum :: [Int] -> Int\nsum = Main.foldr (+) 0\n",
  ],
  [
    "fields that several types have with DuplicateRecordFields",
    "{-# LANGUAGE DuplicateRecordFields #-}\ndata A = A {name :: Int, size :: Int}\ndata B = B {name :: Bool}\nf :: A -> (A, B)\nf a = (A {name = 1, size = 2}, B {name = True})\ng :: A -> B -> A\ng a (B {name = n}) = if n then a {name = 3, size = 1} else a\n",
  ],
  [
    "a type that is named with the program's own module",
    "module Flags where\ntype Flags = [Flag]\ndata Flag = Up | Down\nf :: (String, Flags.Flag) -> Maybe Flag\nf (_, flag) = Just flag\n",
  ],
])("nothing is said about %s", (_, text) => {
  const {problems} = infer(workspaceOf(openView(reader, text)))
  expect(problems.filter(p => p.kind !== "no-main").map(p => `${p.kind}: ${p.message}`)).toEqual([])
})

test.each([
  [
    "what differs behind the constructor of a GADT and is about no variable",
    "{-# LANGUAGE GADTs #-}\ndata Field a where\n  FInt :: Field Int\nf :: Field a -> a -> Bool\nf FInt n = 'c'\n",
  ],
  [
    "a variable of the signature beside such a constructor",
    "{-# LANGUAGE GADTs #-}\ndata Field a where\n  FInt :: Field Int\nf :: Field a -> Int\nf FInt = 1\ng :: a -> Bool\ng x = not x\n",
  ],
  ["fields that several types have", "data A = A {name :: Int}\ndata B = B {name :: Bool}\n"],
  [
    "two types of one name with DuplicateRecordFields",
    "{-# LANGUAGE DuplicateRecordFields #-}\ndata A = A {name :: Int}\ndata A = B {name :: Bool}\n",
  ],
])("but it is said: %s", (_, text) => {
  const {problems} = infer(workspaceOf(openView(reader, text)))
  expect(problems.filter(p => p.kind === "type-mismatch" || p.kind === "duplicate")).not.toEqual([])
})
