/// Minimal programs on which inference and GHC must not contradict each other.
///
/// `accepted`: GHC compiles the program, and inference must report nothing. `refused`: GHC refuses it, and inference must report a problem of
/// that kind. `test/types/agreement.test.ts` asks inference, and GHC where it is installed.

import type {TypeProblem} from "../../src/types/syntax/type_problems.ts"

export const accepted: {readonly [name: string]: string} = {
  "a forall in front of a signature": `{-# LANGUAGE RankNTypes, ScopedTypeVariables #-}
pair :: forall a b. a -> b -> (a, b)
pair x y = (x, y)
shown :: forall a . Show a => a -> String
shown x = show x ++ show (pair x 'c')
main = putStrLn (shown (fst (pair 1 True)))`,
  "a local signature about a variable of a forall": `{-# LANGUAGE RankNTypes, ScopedTypeVariables #-}
twice :: forall a. (a -> a) -> a -> a
twice f x = once (once x)
  where
    once :: a -> a
    once y = if True then f y else x
main = print (twice (+ 1) 2)`,
  "a local signature with a forall of the same variable": `{-# LANGUAGE RankNTypes, ScopedTypeVariables #-}
both :: forall a. a -> (a, Bool)
both x = (same x, same True)
  where
    same :: forall a. a -> a
    same y = y
main = print (both 'x')`,
  "an annotation about a variable of a forall": `{-# LANGUAGE RankNTypes, ScopedTypeVariables #-}
parse :: forall a. (Read a, Show a) => a -> String -> String
parse x t = show (if True then read t :: a else x)
main = putStrLn (parse (1 :: Int) "2")`,
  "a constraint without a type behind a forall": `{-# LANGUAGE RankNTypes #-}
import GHC.Stack (HasCallStack)
first :: forall a b. HasCallStack => a -> b -> a
first x _ = x
main = print (first 1 'x')`,
  "a constraint without a type": `import GHC.Stack (HasCallStack)
first :: HasCallStack => a -> b -> a
first x _ = x
main = print (first 1 'x')`,
  "a type with a forall inside": `{-# LANGUAGE RankNTypes #-}
use :: forall b. (forall a. a -> a) -> b -> (b, Bool)
use f x = (f x, f True)
main = print (use id 'x')`,
  "an import without a space before its list": `import Data.Char(toLower)
main = print (map toLower "AbC")`,
  "the parts of a type of a module that is not read": `import Data.Time (UTCTime(..), getCurrentTime)
main = getCurrentTime >>= print . utctDayTime`,
  "the members of a class by its name": `import Data.Bits (Bits(..))
main = print (popCount (5 :: Int) + (6 .&. 3))`,
  "the members of Foldable by its name": `import Data.Foldable (Foldable(..))
main = print (toList (Just 1), foldl' (+) 0 [1, 2])`,
  "the parts of a record of a module that is read": `import Data.Monoid (Sum(..), First(..))
main = print (getSum (foldMap Sum [1, 2]), getFirst (First (Just 'a')))`,
  "a hidden name without a space": `import Data.List hiding(insert)
insert :: Int -> Int
insert n = n
main = print (insert (length (nub [1, 2, 2])))`,
  "guards in a pattern binding": `(low, high)
  | limit > 3 = (1, limit)
  | otherwise = (0, 3)
limit :: Int
limit = 5
main = print (low + high)`,
  "guards in a local pattern binding": `f :: Int -> Int
f n = a + b
  where
    (a, b)
      | n > 3 = (1, n)
      | Just m <- lookup n [(1, 2)] = (m, m)
      | otherwise = (0, 3)
main = print (f 2)`,
  "a derived Functor": `data Tree a = Leaf | Branch (Tree a) a (Tree a) deriving (Show, Functor, Foldable, Traversable)
main = print (fmap (+ 1) (Branch Leaf 1 Leaf), sum (Branch Leaf 1 Leaf)) >> mapM_ print (traverse Just (Branch Leaf 2 Leaf))`,
  "a derived Functor of a type with two parameters": `data Tagged t a = Tagged t a deriving (Show, Functor)
main = print (fmap not (Tagged 'x' True))`,
  Rational: `import Data.Ratio
half :: Rational
half = 1 % 2
main = print (half + 1, fromRational half :: Double, numerator half)`,
  "Rational without an import": `half :: Rational
half = 0.5
main = print (half * 2 + toRational 3)`,
  "a composition with read in a where": `total :: String -> Int
total text = add text
  where
    add = sum . map read . words
main = print (total "1 2 3")`,
  "a composition with read in a where that defaulting decides": `main = do
  contents <- getContents
  print (add contents)
  where
    add = sum . map read . words`,
  "a constructor with the name of a Prelude type": `import Prelude hiding ((<>))
data Token = Char Char | Double Double deriving Show
main = print (Char 'x')`,
  "instances for two lists": `{-# LANGUAGE FlexibleInstances #-}
class Named a where
  nameOf :: a -> String
instance Named [Int] where
  nameOf _ = "numbers"
instance Named [Char] where
  nameOf _ = "text"
main = putStrLn (nameOf "x" ++ nameOf [1 :: Int])`,
  "a signature for several names": `low, high :: Int
low = 1
high = low + 2
main = print (fromIntegral low + 0.5, high)`,
  "a constraint synonym": `{-# LANGUAGE ConstraintKinds #-}
type Plain a = (Show a, Eq a)
f :: Plain a => a -> String
f n = if n == n then show n else ""
main = putStrLn (f True)`,
  "a type with a type as parameter": `newtype Fix f = Fix (f (Fix f))
depth :: Fix Maybe -> Int
depth (Fix Nothing) = 0
depth (Fix (Just rest)) = 1 + depth rest
main = print (depth (Fix (Just (Fix Nothing))))`,
  "a class of an imported module": `import Data.Bits
import Data.Ix (Ix, range)
both :: (Bits a, Num a) => a -> a
both n = n .&. 3
data Mode = Go | Halt deriving (Eq, Ord, Ix, Show)
main = print (both (6 :: Int), range (Go, Halt))`,
  "a constraint that two types are equal": `{-# LANGUAGE GADTs #-}
f :: (a ~ Int) => a -> Int
f n = n + 1
main = print (f 2)`,
  "a type of a module imported with a qualifier": `import qualified Data.Map as M
phone :: M.Map String Int -> Maybe Int
phone book = M.lookup "me" book
main = print (phone (M.fromList [("me", 1)]))`,
  "a qualified type of an unknown module": `import qualified Data.Array as A
type Board = A.Array Int Bool
size :: A.Array Int a -> Int
size cells = let (a, b) = A.bounds cells in b - a + 1
board :: Board
board = A.listArray (0, 2) [True, False, True]
main = print (size board, board A.! 1)`,
  IOException: `import Control.Exception
handler :: IOException -> IO ()
handler e = putStrLn ("no file: " ++ show e)
main = catch (readFile "x" >>= putStrLn) handler`,
  IOError: `import System.IO.Error
handler :: IOError -> IO ()
handler e
  | isDoesNotExistError e = putStrLn "no file"
  | otherwise = ioError e
main = catchIOError (readFile "x" >>= putStrLn) handler`,
  "a curried context": `biggest :: Ord a => Show a => [a] -> String
biggest items = show (maximum items)
main = putStrLn (biggest [1 :: Int, 2])`,
  "a context in two pairs of brackets": `biggest :: ((Ord a, Show a)) => [a] -> String
biggest items = show (maximum items)
main = putStrLn (biggest [1 :: Int, 2])`,
  "a constraint in brackets": `biggest :: ((Ord a), (Show a)) => [a] -> String
biggest items = show (maximum items)
main = putStrLn (biggest [1 :: Int, 2])`,
  "text under OverloadedStrings": `{-# LANGUAGE OverloadedStrings #-}
import Data.String (IsString (..))
newtype Name = Name String deriving (Show, Eq)
instance IsString Name where
  fromString = Name
me :: Name
me = "Ada"
isMe :: Name -> Bool
isMe "Ada" = True
isMe _ = False
main = print (isMe me)`,
  "a method with a type of its own in an instance with a variable": `{-# LANGUAGE InstanceSigs #-}
newtype Carry s a = Carry (s -> (a, s))
instance Functor (Carry s) where
  fmap :: (a -> b) -> Carry s a -> Carry s b
  fmap f (Carry g) = Carry (\\s -> let (a, s') = g s in (f a, s'))
main = case fmap not (Carry (\\s -> (True, s))) of Carry g -> print (g 'x')`,
  "a method with a type of its own that says the head's variables anew": `{-# LANGUAGE InstanceSigs #-}
newtype Compose f g a = Compose (f (g a))
instance (Functor f, Functor g) => Functor (Compose f g) where
  fmap :: (a -> b) -> Compose f g a -> Compose f g b
  fmap f (Compose t) = Compose (fmap (fmap f) t)
instance (Foldable f, Foldable g) => Foldable (Compose f g) where
  foldMap :: Monoid m => (a -> m) -> Compose f g a -> m
  foldMap f (Compose t) = foldMap (foldMap f) t
main = case fmap not (Compose (Just [True])) of Compose t -> print t`,
  "a method with a more general type than its class asks for": `{-# LANGUAGE InstanceSigs #-}
class Named a where
  nameOf :: a -> Int -> String
instance Named Bool where
  nameOf :: Show n => Bool -> n -> String
  nameOf b n = show b ++ show n
main = putStrLn (nameOf True 1)`,
  "a file that is indented below its module": `  import Data.Char
  import Control.Applicative
  digits :: String -> Int
  digits = length . filter isDigit
  main = print (digits "a1", Nothing <|> Just 1)`,
  "a pattern with a type": `{-# LANGUAGE ScopedTypeVariables #-}
main = do
  line <- getLine
  let numbers :: [Int] = map read (words line)
      first = head numbers
  print first`,
  "classes that a newtype takes over": `{-# LANGUAGE GeneralizedNewtypeDeriving #-}
import Control.Applicative
newtype Bag a = Bag [a] deriving (Show, Functor, Applicative, Monad, Alternative)
main = print (Bag [1] <|> (Bag [2] >>= pure))`,
  "a local constant of a type that only GHC knows": `import qualified Data.Array as A
isSmaller :: A.Array Int a -> A.Array Int a -> Bool
isSmaller a b = m <= n
  where
    m = A.bounds a
    n = A.bounds b
main = print (isSmaller (A.listArray (0, 1) "ab") (A.listArray (0, 1) "ab"))`,
  "a type that shares its name with a qualified one": `import qualified Control.Monad.ST as S
import qualified Data.Map as M
newtype Map = Map (M.Map String Int)
type ST = (S.ST () Int, Map)
size :: Map -> Int
size (Map m) = M.size m
names :: M.Map String Int -> [String]
names = M.keys
main = print (size (Map (M.fromList [("a", 1)])), names (M.fromList []))`,
  "types that belong to a class": `{-# LANGUAGE TypeFamilies #-}
class Container f where
  type Elem f
  empty :: f
  insert :: Elem f -> f -> f
  items :: f -> [Elem f]
instance Container [a] where
  type Elem [a] = a
  empty = []
  insert = (:)
  items all = all
data Counted f = Counted (Elem f) Int
first :: Container f => f -> Elem f
first = head . items
main = print (items (insert (1 :: Int) [])) >> print (first [True])`,
  "types that are computed from types": `{-# LANGUAGE TypeFamilies #-}
type family Next a
type instance Next Bool = Int
next :: Bool -> Next Bool
next b = if b then 1 else 0
main = print (next True + 1)`,
  "qualified operators": `import qualified Data.Map as M
import qualified Data.Sequence as Seq
second :: Seq.Seq a -> Maybe a
second (_ Seq.:<| (x Seq.:<| _)) = Just x
second _ = Nothing
at :: Int -> M.Map Int a -> a
at k = (M.! k)
main = print (M.fromList [(1, 2)] M.! 1 + at 1 (M.fromList [(1, 2)]), second (Seq.fromList "ab" Seq.|> 'c'))`,
  "own classes with instances of many forms": `{-# LANGUAGE FlexibleInstances, DeriveAnyClass, StandaloneDeriving #-}
type Label = String
class Show a => Named a where
  nameOf :: a -> String
  nameOf = show
data Mode = Go | Halt deriving (Show, Named)
newtype Box a = Box a deriving Show
instance Named Label where
  nameOf label = label
instance Named Bool
deriving instance Named Int
instance Named a => Named (Maybe a)
instance Show a => Named (Box a)
instance (Named a, Named b) => Named (a, b)
main = do
  putStrLn (nameOf "a" ++ nameOf Go ++ nameOf True ++ nameOf (1 :: Int))
  putStrLn (nameOf (Just Halt) ++ nameOf (Box 'x') ++ nameOf ("b", False))`,
  "an own class for every type": `{-# LANGUAGE FlexibleInstances #-}
class Sized a where
  sizeOf :: a -> Int
instance Sized a where
  sizeOf _ = 1
main = print (sizeOf 'x' + sizeOf [True])`,
  "an own class for a type that is computed": `{-# LANGUAGE FlexibleInstances #-}
class Holder f where
  held :: f a -> Int
instance Holder Maybe where
  held = length
instance Holder ((->) r) where
  held _ = 1
instance Holder (Either e) where
  held = length
main = print (held (Just 1), held not, held (Left 'x'))`,
  "an own class that shares its name with the Prelude's": `import Prelude hiding (Monoid, mempty)
class Monoid a where
  mempty :: a
instance Monoid (a, b) where
  mempty = undefined
instance Monoid Bool where
  mempty = False
main = print (mempty || True)`,
  "an instance for one list beside the Prelude's": `{-# LANGUAGE FlexibleInstances #-}
data Mode = Go
instance {-# OVERLAPPING #-} Show [Mode] where
  show _ = "modes"
main = print [Go]`,
  "instances that the Prelude does not have": `instance Num a => Num (Maybe a) where
  (+) = undefined
  (*) = undefined
  abs = id
  signum = id
  negate = id
  fromInteger = Just . fromInteger
instance Show (a -> b) where
  show _ = "a function"
main = print (1 :: Maybe Int) >> print not`,
  "signatures apart from their definitions": `{-# LANGUAGE PatternSynonyms #-}
low, high :: Int
(low, high) = (1, 2)
(<+>) :: Int -> Int -> Int
infixl 6 <+>
a <+> b = a + b
apart :: Int
low' :: Int -> Int
low' n = n
apart = k 1
  where
    k, j :: Int -> Int
    j n = n
    k n = j n
main = print (low <+> high, apart)`,
  "the Prelude as a qualifier": `size :: Prelude.String -> Prelude.Int
size name = Prelude.length name Prelude.+ 1
main = print (size "a")`,
  "strings beside text under OverloadedStrings": `{-# LANGUAGE OverloadedStrings #-}
import qualified Data.Map as M
names :: M.Map String Int
names = M.fromList [("a", 1)]
main = putStrLn "hello" >> print (M.lookup "a" names) >> mapM_ putStrLn ["b", "c"]`,
  "constructors in types": `{-# LANGUAGE DataKinds, KindSignatures, GADTs #-}
data Nat = Z | S Nat
data Vec (n :: Nat) a where
  Nil :: Vec Z a
  Cons :: a -> Vec n a -> Vec (S n) a
type One = S Z
first :: Vec (S n) a -> a
first (Cons x _) = x
one :: Vec One Bool
one = Cons True Nil
main = print (first one)`,
  "names for patterns": `{-# LANGUAGE PatternSynonyms, ViewPatterns #-}
pattern Two x y = [x, y]
pattern x :> rest <- x : rest
  where
    x :> rest = x : rest
pattern Point {across, up} = (across, up)
pattern One, Other :: Int
pattern One = 1
pattern Other <- (odd -> False)
f :: [Int] -> Int
f (Two x y) = x + y
f (One :> _) = 1
f (Other :> rest) = f rest
f rest = length (3 :> rest)
main = print (f [1, 2] + across (Point 1 2) + up (3, 4))`,
  "steps that use each other's names": `{-# LANGUAGE RecursiveDo #-}
stream :: Maybe [Int]
stream = do
  rec xs <- Just (1 : ys)
      let ys = 2 : xs
  return (take 3 (map negate xs) ++ take 1 ys)
main = print stream`,
  "another name for a type of a module that is not read": `import Foreign.C.String (CStringLen)
import Foreign.Ptr
size :: CStringLen -> Int
size (_, n) = n
none :: CStringLen
none = (nullPtr, 0)
sizes :: [CStringLen] -> [(Int, Int)]
sizes all = zip (map snd all) (map (succ . size) all)
main = print (size none, sizes [none])`,
  "names of a module that is imported as a whole, also those that Rosy and the Prelude have": `import Prelude hiding ((<>))
import Text.PrettyPrint
title :: Int -> Doc
title n = text "robot" <> parens (text (show n))
main = putStrLn (render (title 1))`,
  "constructors of a GADT that are operators": `{-# LANGUAGE GADTs #-}
infixr 5 :::
data All a where
  Nil :: All ()
  (:::) :: t -> All ts -> All (t, ts)
  (:+), (:-) :: Int -> All Int
size :: All a -> Int
size Nil = 0
size (_ ::: rest) = 1 + size rest
size ((:+) n) = n
size ((:-) n) = n
main = print (size (True ::: "a" ::: Nil))`,
  "fields with a type that holds for all types": `{-# LANGUAGE RankNTypes, ExistentialQuantification #-}
class Shape s where
  leaf :: s a
newtype Depth a = Depth Int
newtype Name a = Name String
instance Shape Depth where
  leaf = Depth 1
instance Shape Name where
  leaf = Name "leaf"
data Tree a = Tree (forall s. Shape s => s a)
data Keep = Keep {pass :: forall b. b -> b, times :: Int}
both :: Tree a -> (Int, String)
both (Tree t) = (depth t, name t)
  where
    depth (Depth n) = n
    name (Name n) = n
changed :: Keep -> Keep
changed k = k {pass = id, times = 2}
used :: Keep -> (Int, Bool)
used (Keep p n) = (p n, p True)
main = print (both (Tree leaf), used (changed (Keep id 1)))`,
  "fields with text and numbers in their types": `{-# LANGUAGE DataKinds, KindSignatures #-}
import GHC.TypeLits
newtype Field (n :: Symbol) v = Field v
data Person = Person (Field "age" Int) (Field "name" String) Bool
me :: Person
me = Person (Field 56) (Field "Simon") True
main = case me of Person (Field n) (Field text) _ -> print (n + 1, text ++ "!")`,
  "whole numbers that look like fractions": `{-# LANGUAGE NumDecimals #-}
kilo :: Int
kilo = 1e3 + 1.5e1
main = print kilo`,
  "lists as numbers": `{-# LANGUAGE FlexibleContexts #-}
f y = y + z ++ x
  where
    z = 1
    x = 2
main = print 1`,
  "instances for types of one name from two modules": `{-# LANGUAGE FlexibleInstances #-}
import qualified Data.ByteString as B
import qualified Data.ByteString.Lazy as L
class Sized a where
  sizeOf :: a -> Int
instance Sized B.ByteString where
  sizeOf = B.length
instance Sized L.ByteString where
  sizeOf = fromIntegral . L.length
main = print (sizeOf B.empty + sizeOf L.empty)`,
  "a constraint that holds for all types": `{-# LANGUAGE QuantifiedConstraints, RankNTypes #-}
class Made a where
  made :: a
one :: (forall x. Made (f x)) => f Int
one = made
main = print 1`,
  "variables of an instance and of a class in annotations of their methods": `{-# LANGUAGE ScopedTypeVariables, DefaultSignatures #-}
import GHC.Generics
class Parts f where
  parts :: [f a]
class Sized a where
  sizeOf :: a -> Int
  start :: a
  both :: a -> Int
  both x = sizeOf (y :: a) + sizeOf (start :: a)
    where
      y :: a
      y = x
instance (Parts f, Constructor c) => Parts (M1 i c f) where
  parts =
    let name = conName (undefined :: t c f a)
     in map M1 (if null name then [] else parts)
main = print 1`,
  "more arguments behind the constructor of a GADT": `{-# LANGUAGE GADTs #-}
data Count f xs ys where
  One :: Count (a -> b) [a] [b]
  Succ :: Count x y z -> Count (a -> x) [a] (y -> z)
apply :: Count f xs ys -> f -> xs -> ys
apply One f xs = map f xs
apply (Succ n) f xs = \\ys -> apply n (f (head xs)) ys
main = print (apply One not [True])`,
  "a type of the Prelude that is hidden with its constructors": `import Prelude hiding (Bool (..))
data Bool = False | True
f :: Bool -> Int
f False = 0
f True = 1
main = print (f True)`,
  "operators that imported types are made with": `{-# LANGUAGE TypeOperators #-}
import Data.List.NonEmpty (NonEmpty (..))
import GHC.Generics
some :: NonEmpty Int
some = 1 :| [2, 3]
swap :: (f :*: g) a -> (g :*: f) a
swap (a :*: b) = b :*: a
main = print some >> print (swap ([1] :*: Just 2))`,
  "a name for types that is an arrow of its own": `{-# LANGUAGE TypeOperators, RankNTypes #-}
type (⇒) f g = forall a. f a -> g a
first :: [] ⇒ Maybe
first [] = Nothing
first (x : _) = Just x
main = print (first "a")`,
  "two dots that take the names of fields": `{-# LANGUAGE RecordWildCards #-}
data Place = Place {across :: Int, up :: Double}
place :: [String] -> Place
place all = Place {..}
  where
    across = read (head all)
    up = read (all !! 1)
main = print (across (place ["1", "2"]))`,
  "a class of several types that decides one of them": `{-# LANGUAGE FunctionalDependencies, FlexibleInstances #-}
class Lift a b | b -> a where
  lift :: a -> b
instance Lift (IO Int) (IO Double) where
  lift = fmap fromIntegral
raised :: Lift a b => a -> b
raised = lift
half :: IO Double
half = do
  n <- raised readLn
  return (n / 2)
main = half >>= print`,
  "a context in brackets": `{-# LANGUAGE RankNTypes, FlexibleContexts #-}
with :: Int -> (Show Int => r) -> r
with n x = if n > 0 then x else x
main = putStrLn (with 1 (show (2 :: Int)))`,
}

export const refused: {readonly [name: string]: readonly [TypeProblem["kind"], string]} = {
  "a type in place of a constraint": [
    "bad-signature",
    `f :: Int => Int
f x = x
main = print (f 1)`,
  ],
  "a value that a forall does not allow": [
    "mismatch",
    `{-# LANGUAGE RankNTypes, ScopedTypeVariables #-}
same :: forall a. a -> a
same x = True
main = print (same 'x')`,
  ],
  "a variable of a forall that is another one inside": [
    "mismatch",
    `{-# LANGUAGE RankNTypes, ScopedTypeVariables #-}
same :: forall a. a -> a
same x = other x
  where
    other :: forall b. b -> a
    other y = y
main = print (same 'x')`,
  ],
  "a class that a forall does not promise": [
    "too-general",
    `{-# LANGUAGE RankNTypes, ScopedTypeVariables #-}
shown :: forall a. a -> String
shown x = show x
main = putStrLn (shown 'x')`,
  ],
  "a type without its argument": [
    "kind",
    `f :: Maybe -> Int
f _ = 1
main = print 1`,
  ],
  "a type with too many arguments": [
    "kind",
    `f :: Int Bool -> Int
f _ = 1
main = print 1`,
  ],
  "a part without its argument": [
    "kind",
    `data Box = Box Maybe
main = print 1`,
  ],
  "Show derived for a function": [
    "no-instance",
    `data Rule = Rule (Int -> Int) deriving Show
main = print 1`,
  ],
  "Eq derived for a part without Eq": [
    "no-instance",
    `data Rule = Rule (Int -> Int)
data Rules = Rules [Rule] deriving (Show, Eq)
main = print 1`,
  ],
  "equations with different numbers of arguments": [
    "clause-arity",
    `f :: Int -> Int -> Int
f 0 = \\n -> n
f m n = m + n
main = print (f 1 2)`,
  ],
  "Ord derived without Eq": [
    "missing-superclass",
    `import qualified Data.Map as M
data Mode = Go | Halt deriving Ord
main = print 1`,
  ],
  "an instance without its superclass": [
    "no-instance",
    `newtype Step a = Step a
instance Monad Step where
  Step a >>= f = f a
main = print 1`,
  ],
  "a method with another type than its class asks for": [
    "mismatch",
    `{-# LANGUAGE InstanceSigs #-}
newtype Box a = Box a
instance Functor Box where
  fmap :: (a -> a) -> Box a -> Box a
  fmap f (Box a) = Box (f a)
main = print 1`,
  ],
  "a type that is a name for itself": [
    "unknown-type",
    `type Way = (Way, Way, Way)
f :: Way -> Unknown
f _ = f
main = print 1`,
  ],
  "an unknown class in a signature": [
    "unknown-class",
    `f :: Showable a => a -> Int
f _ = 1
main = print (f True)`,
  ],
  "an unknown class of an instance": [
    "unknown-class",
    `data Mode = Go
instance Shows Mode where
  show Go = "go"
main = print 1`,
  ],
  "an unknown derived class": [
    "unknown-class",
    `data Mode = Go deriving (Shown)
main = print 1`,
  ],
  "an own type without an instance of an own class": [
    "no-instance",
    `class Shape a where
  area :: a -> Double
data Square = Square Double
instance Shape Square where
  area (Square n) = n * n
data Dot = Dot
main = print (area (Square 1) + area Dot)`,
  ],
  "a Prelude type without an instance of an own class": [
    "no-instance",
    `class Shape a where
  area :: a -> Double
instance Shape a => Shape [a] where
  area = sum . map area
main = print (area [True])`,
  ],
  "a superclass of an own class without an instance": [
    "no-instance",
    `class Show a => Pretty a where
  pretty :: a -> String
data Rule = Rule (Int -> Int)
instance Pretty Rule where
  pretty _ = "a rule"
main = putStrLn (pretty (Rule id))`,
  ],
  "an unknown superclass": [
    "unknown-class",
    `class Showable a => Pretty a where
  pretty :: a -> String
main = print 1`,
  ],
  "an instance that the Prelude has": [
    "second-instance",
    `import Data.Monoid
instance (Monoid a, Monoid b) => Monoid (a, b) where
  mempty = (mempty, mempty)
main = print 1`,
  ],
  "a type without an equation": [
    "no-binding",
    `f :: Int -> Int
main = print 1`,
  ],
  "an operator with a type and no equation": [
    "no-binding",
    `(<+>) :: Int -> Int -> Int
infixl 6 <+>
main = print 1`,
  ],
  "a local type without an equation": [
    "no-binding",
    `main = print (f 1)
  where
    f n = n
    g :: Int`,
  ],
  "a qualified type without its import": [
    "unknown-type",
    `import Data.Map
names :: M.Map Int String -> Int
names _ = 1
main = print 1`,
  ],
  "a missing Show": [
    "too-general",
    `f :: a -> String
f n = show n
main = putStrLn (f 1)`,
  ],
  "a constructor in a type that does not exist": [
    "unknown-type",
    `{-# LANGUAGE DataKinds, KindSignatures #-}
data Nat = Z | S Nat
data Vec (n :: Nat) a = Nil
first :: Vec (T n) a -> Int
first _ = 1
main = print 1`,
  ],
  "a constructor in a type without DataKinds": [
    "unknown-type",
    `data Nat = Z | S Nat
data Vec n a = Nil
first :: Vec (S n) a -> Int
first _ = 1
main = print 1`,
  ],
  "a pattern without a name beside one that has a name": [
    "unknown-name",
    `{-# LANGUAGE PatternSynonyms #-}
pattern Two x y = [x, y]
f (Three x y) = x + y
main = print (f [1, 2])`,
  ],
  "a name that steps do not make": [
    "unknown-name",
    `{-# LANGUAGE RecursiveDo #-}
stream :: Maybe [Int]
stream = do
  rec xs <- Just (1 : xs)
  return (map negate zs)
main = print stream`,
  ],
  "a part of a known type beside one that is not read": [
    "mismatch",
    `import Foreign.C.String (CStringLen)
size :: CStringLen -> Maybe Int -> Int
size _ (_, n) = n
main = print 1`,
  ],
  "a wrong input beside a module that is imported as a whole": [
    "mismatch",
    `import Text.PrettyPrint
title :: Doc
title = if not "a" then text "b" else text "c"
main = print title`,
  ],
  "a wrong field beside one with a type that holds for all types": [
    "mismatch",
    `{-# LANGUAGE RankNTypes #-}
data Keep = Keep {pass :: forall b. b -> b, times :: Int}
changed :: Keep -> Keep
changed k = k {pass = id, times = True}
main = print (times (changed (Keep id 1)))`,
  ],
  "a fraction as a whole number": [
    "no-instance",
    `{-# LANGUAGE NumDecimals #-}
kilo :: Int
kilo = 1.5
main = print kilo`,
  ],
  "a list as a number": [
    "no-instance",
    `f y = y + z ++ x
  where
    z = 1
    x = 2
main = print 1`,
  ],
  "a list as a number under a signature": [
    "no-instance",
    `{-# LANGUAGE FlexibleContexts #-}
f :: [a] -> [a]
f y = y + y
main = print 1`,
  ],
  "two instances for one type of a module": [
    "second-instance",
    `{-# LANGUAGE FlexibleInstances #-}
import qualified Data.ByteString as B
class Sized a where
  sizeOf :: a -> Int
instance Sized B.ByteString where
  sizeOf = B.length
instance Sized B.ByteString where
  sizeOf _ = 1
main = print (sizeOf B.empty)`,
  ],
  "a wrong input in a method of a class whose members use its variable": [
    "mismatch",
    `{-# LANGUAGE ScopedTypeVariables #-}
class Sized a where
  sizeOf :: a -> Int
  both :: a -> Bool
  both x = not (sizeOf (x :: a))
main = print 1`,
  ],
  "an argument for a variable of a signature": [
    "too-many-arguments",
    `f :: a -> Int
f x = x 1
main = print (f 'x')`,
  ],
  "an operator that no imported type is made with": [
    "unknown-name",
    `import Data.List.NonEmpty (NonEmpty (..))
some :: NonEmpty Int
some = 1 :|: [2, 3]
main = print some`,
  ],
  "two dots that take a name of another type": [
    "mismatch",
    `{-# LANGUAGE RecordWildCards #-}
data Place = Place {across :: Int, up :: Double}
place :: Bool -> Place
place across = Place {up = 1, ..}
main = print (across (place True))`,
  ],
  "a type that nothing decides beside a class of several types": [
    "ambiguous",
    `{-# LANGUAGE FunctionalDependencies #-}
class Lift a b | b -> a where
  lift :: a -> b
size :: String -> Int
size text = length (show (read text))
main = print (size "1")`,
  ],
}
