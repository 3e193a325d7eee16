"""
Idioms of Haskell as they are typed by someone who knows Haskell and not Rosy.

Each defines ``answer :: String``. What an idiom does differently here is stated beside it.
"""

from __future__ import annotations

from dataclasses import dataclass

__all__ = ["IDIOMS", "Idiom"]


@dataclass(frozen=True)
class Idiom:
    """A program without ``main``, and why Rosy's answer differs from GHC's; empty where it does not."""

    name: str
    typed: str
    difference: str = ""


IDIOMS = [
    Idiom(
        "record update",
        """
data Config = Config { width :: Int, name :: String } deriving (Show, Eq)
defaults = Config { width = 3, name = "rosy" }
answer = show (defaults { width = 4 }) ++ show (defaults == defaults)
""",
    ),
    Idiom(
        "where with guards",
        """
grade :: Int -> String
grade n
  | s > 8 = "good"
  | s > 4 = "fair"
  | otherwise = "poor"
  where s = n `div` 10
answer = unwords (map grade [95, 60, 10])
""",
    ),
    Idiom(
        "local functions",
        """
answer = show (let go 0 acc = acc
                   go n acc = go (n - 1) (acc * n)
               in go (10 :: Integer) 1)
""",
    ),
    Idiom(
        "type class with a default method",
        """
class Shape a where
  area :: a -> Double
  describe :: a -> String
  describe x = "area " ++ show (area x)
data Square = Square Double
instance Shape Square where
  area (Square s) = s * s
answer = describe (Square 3)
""",
    ),
    Idiom(
        "Maybe monad",
        """
safeDiv :: Int -> Int -> Maybe Int
safeDiv _ 0 = Nothing
safeDiv a b = Just (a `div` b)
answer = show (do { x <- safeDiv 100 5; y <- safeDiv x 0; return (x + y) }, safeDiv 100 5 >>= safeDiv 60)
""",
    ),
    Idiom(
        "list comprehension",
        """
answer = show [(a, b, c) | c <- [1 .. 20], b <- [1 .. c], a <- [1 .. b], a * a + b * b == c * c]
""",
    ),
    Idiom(
        "let polymorphism",
        """
answer = let pair x = (x, x) in show (pair 1, pair "a", pair True)
""",
    ),
    Idiom(
        "point-free style",
        """
answer = (show . sum . map (* 2) . filter even) [1 .. 10]
""",
    ),
    Idiom(
        "Data.Map",
        """
import qualified Data.Map as Map
counts :: String -> Map.Map Char Int
counts = foldr (\\c -> Map.insertWith (+) c 1) Map.empty
answer = show (Map.toList (counts "mississippi"))
""",
    ),
    Idiom(
        "Data.Map.Strict and Data.Set",
        """
import qualified Data.Map.Strict as M
import qualified Data.Set as S
answer = show (M.foldr (+) 0 (M.fromListWith (+) [(1, 2), (1, 3)]))
  ++ show (S.toList (S.map (`mod` 3) (S.fromList [1 .. 9])))
""",
    ),
    Idiom(
        "a fold as a state machine",
        """
answer = show (foldl (\\(n, best) x -> let m = max 0 (n + x) in (m, max m best)) (0, 0) [-2, 1, -3, 4, -1, 2, 1, -5, 4])
""",
    ),
    Idiom(
        "a State monad of one's own",
        """
newtype State s a = State { runState :: s -> (a, s) }
instance Functor (State s) where
  fmap f (State g) = State (\\s -> let (a, t) = g s in (f a, t))
instance Applicative (State s) where
  pure a = State (\\s -> (a, s))
  State f <*> State g = State (\\s -> let (h, t) = f s; (a, u) = g t in (h a, u))
instance Monad (State s) where
  State g >>= k = State (\\s -> let (a, t) = g s in runState (k a) t)
tick :: State Int Int
tick = State (\\n -> (n, n + 1))
answer = show (runState (mapM (const tick) "abc") 5)
""",
    ),
    Idiom(
        "mutual recursion",
        """
isEven', isOdd' :: Int -> Bool
isEven' 0 = True
isEven' n = isOdd' (n - 1)
isOdd' 0 = False
isOdd' n = isEven' (n - 1)
answer = show (isEven' 10, isOdd' 7)
""",
    ),
    Idiom(
        "printf",
        """
import Text.Printf (printf)
answer = printf "%d apples, %.2f each" (3 :: Int) (0.5 :: Double) :: String
""",
    ),
    Idiom(
        "show and read",
        """
answer = show (read "[(1,True),(2,False)]" :: [(Int, Bool)]) ++ show (read "3.5" + 1 :: Double)
""",
    ),
    Idiom(
        "reads and Text.Read",
        """
import Text.Read (readMaybe)
answer = show (readMaybe "12" :: Maybe Int, readMaybe "x" :: Maybe Int, fst (head (reads "7 rest" :: [(Int, String)])))
""",
    ),
    Idiom(
        "lambda case",
        """
{-# LANGUAGE LambdaCase #-}
name :: Int -> String
name = \\case
  0 -> "zero"
  1 -> "one"
  _ -> "many"
answer = unwords (map name [0, 1, 2])
""",
    ),
    Idiom(
        "newtype deriving",
        """
{-# LANGUAGE GeneralizedNewtypeDeriving #-}
newtype Count = Count Int deriving (Eq, Ord, Show, Num)
answer = show (sum [Count 1, 2, 3])
""",
    ),
    Idiom(
        "deriving strategies",
        """
{-# LANGUAGE DerivingStrategies, GeneralizedNewtypeDeriving, DeriveAnyClass #-}
newtype Age = Age Int
  deriving stock (Show)
  deriving newtype (Eq, Ord, Num)
answer = show (Age 3 + 4)
""",
    ),
    Idiom(
        "Semigroup and Monoid",
        """
newtype Longest = Longest String deriving Show
instance Semigroup Longest where
  Longest a <> Longest b = if length b > length a then Longest b else Longest a
instance Monoid Longest where
  mempty = Longest ""
answer = show (mconcat (map Longest ["ab", "abcd", "abc"]))
""",
    ),
    Idiom(
        "monoids of Data.Monoid",
        """
import Data.Monoid
answer = show (getSum (foldMap Sum [1 .. 10]), getAll (foldMap (All . even) [2, 4]),
  getFirst (First (Just 1) <> First Nothing))
""",
    ),
    Idiom(
        "Foldable and Traversable",
        """
{-# LANGUAGE DeriveFunctor, DeriveFoldable, DeriveTraversable #-}
data Tree a = Leaf | Node (Tree a) a (Tree a) deriving (Show, Functor, Foldable, Traversable)
insert :: Ord a => a -> Tree a -> Tree a
insert x Leaf = Node Leaf x Leaf
insert x t@(Node l y r)
  | x < y = Node (insert x l) y r
  | x > y = Node l y (insert x r)
  | otherwise = t
tree = foldr insert Leaf [3, 1, 2 :: Int]
answer = show (sum tree, maximum tree, foldr (:) [] (fmap (* 2) tree))
  ++ show (fmap length (traverse (\\x -> if x > 0 then Just x else Nothing) tree))
""",
    ),
    Idiom(
        "mapM_, when and unless",
        """
import Control.Monad
answer = show (length (execute [1 .. 5]))
  where execute xs = concat [replicate n () | n <- xs, maybe False (const True) (when (n > 2) (Just ()))]
""",
    ),
    Idiom(
        "infinite lists",
        """
primes = sieve [2 ..] where sieve (p : xs) = p : sieve [x | x <- xs, x `mod` p /= 0]
answer = show (takeWhile (< 30) primes)
""",
        "the same value; Rosy warns without an option",
    ),
    Idiom(
        "laziness",
        """
answer = show (fst (1, undefined), take 3 (cycle "ab"), length [undefined, undefined])
""",
    ),
    Idiom(
        "knot tying",
        """
fibs = 0 : 1 : zipWith (+) fibs (tail fibs) :: [Integer]
answer = show (fibs !! 50)
""",
    ),
    Idiom(
        "seq and strict folds",
        """
import Data.List (foldl')
answer = show (foldl' (+) 0 [1 .. 10000 :: Int], let x = 3 in x `seq` x + 1)
""",
    ),
    Idiom(
        "bang patterns",
        """
{-# LANGUAGE BangPatterns #-}
mean xs = go 0 0 xs where { go !s !n [] = s / n; go !s !n (y : ys) = go (s + y) (n + 1) ys }
answer = show (mean [1, 2, 3, 4 :: Double])
""",
    ),
    Idiom(
        "GADTs",
        """
{-# LANGUAGE GADTs #-}
data Expr a where
  Lit :: Int -> Expr Int
  IsZero :: Expr Int -> Expr Bool
  If :: Expr Bool -> Expr a -> Expr a -> Expr a
eval :: Expr a -> a
eval (Lit n) = n
eval (IsZero e) = eval e == 0
eval (If c a b) = if eval c then eval a else eval b
answer = show (eval (If (IsZero (Lit 0)) (Lit 1) (Lit 2)))
""",
    ),
    Idiom(
        "existential types",
        """
{-# LANGUAGE ExistentialQuantification #-}
data Showable = forall a. Show a => Showable a
answer = concatMap (\\(Showable x) -> show x) [Showable 1, Showable True, Showable "a"]
""",
    ),
    Idiom(
        "type families",
        """
{-# LANGUAGE TypeFamilies #-}
class Container f where
  type Elem f
  toL :: f -> [Elem f]
instance Container [a] where
  type Elem [a] = a
  toL = id
answer = show (toL [1, 2, 3 :: Int])
""",
    ),
    Idiom(
        "multi-parameter classes",
        """
{-# LANGUAGE MultiParamTypeClasses, FlexibleInstances #-}
class Convert a b where
  convert :: a -> b
instance Convert Int String where
  convert = show
answer = convert (3 :: Int)
""",
    ),
    Idiom(
        "functional dependencies",
        """
{-# LANGUAGE MultiParamTypeClasses, FunctionalDependencies, FlexibleInstances #-}
class Box f a | f -> a where
  unbox :: f -> a
newtype IntBox = IntBox Int
instance Box IntBox Int where
  unbox (IntBox n) = n
answer = show (unbox (IntBox 3) + 1)
""",
    ),
    Idiom(
        "rank-N types",
        """
{-# LANGUAGE RankNTypes #-}
both :: (forall a. [a] -> Int) -> ([Int], String) -> (Int, Int)
both f (a, b) = (f a, f b)
answer = show (both length ([1, 2], "abc"))
""",
    ),
    Idiom(
        "type applications",
        """
{-# LANGUAGE TypeApplications #-}
answer = show (read @Int "42", maxBound @Int > 0)
""",
    ),
    Idiom(
        "tuple sections",
        """
{-# LANGUAGE TupleSections #-}
answer = show (map (,True) [1, 2])
""",
    ),
    Idiom(
        "multi-way if",
        """
{-# LANGUAGE MultiWayIf #-}
size n = if | n < 3 -> "small" | n < 10 -> "middle" | otherwise -> "large"
answer = unwords (map size [1, 5, 50])
""",
    ),
    Idiom(
        "record wildcards",
        """
{-# LANGUAGE RecordWildCards #-}
data P = P { px :: Int, py :: Int }
sumP P {..} = px + py
answer = show (sumP (P 3 4), let { px = 1; py = 2 } in sumP P {..})
""",
    ),
    Idiom(
        "view patterns",
        """
{-# LANGUAGE ViewPatterns #-}
firstWord (words -> (w : _)) = w
firstWord _ = ""
answer = firstWord "hello world"
""",
    ),
    Idiom(
        "pattern guards",
        """
find' k kvs | Just v <- lookup k kvs, v > 1 = "big" | Just _ <- lookup k kvs = "small" | otherwise = "none"
answer = unwords (map (`find'` [(1, 1), (2, 2)]) [1, 2, 3])
""",
    ),
    Idiom(
        "as patterns and irrefutable patterns",
        """
dup all'@(x : _) = x : all'
dup [] = []
lazyPair ~(a, b) = 0 :: Int
answer = show (dup [1, 2], lazyPair undefined)
""",
    ),
    Idiom(
        "zip, unzip, iterate, scanl",
        """
answer = show (zip3 [1, 2] "ab" [True, False], unzip [(1, 2), (3, 4)], take 4 (iterate (* 2) 1), scanl (+) 0 [1, 2, 3])
""",
    ),
    Idiom(
        "Data.List",
        """
import Data.List
import Data.Ord (comparing)
import Data.Function (on)
answer = show (sortBy (comparing negate) [3, 1, 2], nub [1, 1, 2], map length (group (sort "hello")),
  groupBy ((==) `on` even) [2, 4, 1], intercalate ", " ["a", "b"], partition even [1 .. 5])
""",
    ),
    Idiom(
        "Data.Char",
        """
import Data.Char
answer = map toUpper "abc" ++ show (ord 'a', digitToInt 'f', isSpace ' ')
""",
    ),
    Idiom(
        "Either for errors",
        """
check n = if n < 0 then Left ("negative: " ++ show n) else Right (n * 2)
answer = show (mapM check [1, 2]) ++ show (mapM check [1, -2, -3])
""",
    ),
    Idiom(
        "applicative style",
        """
answer = show ((+) <$> Just 3 <*> Just 4, (,) <$> [1, 2] <*> "ab", pure 3 :: Maybe Int)
""",
    ),
    Idiom(
        "the function monad",
        """
answer = show ((do { a <- (* 2); b <- (+ 10); return (a + b) }) 3, ((+) <$> (* 2) <*> (+ 10)) 3)
""",
    ),
    Idiom(
        "ST and STRef",
        """
import Control.Monad.ST
import Data.STRef
sumST :: [Int] -> Int
sumST xs = runST (do { r <- newSTRef 0; mapM_ (\\x -> modifySTRef r (+ x)) xs; readSTRef r })
answer = show (sumST [1 .. 10])
""",
        "refused, as all that changes in place: a fold does it here, a Memory from one firing to the next",
    ),
    Idiom(
        "arrays",
        """
import Data.Array
answer = show (listArray (0, 2) "abc" ! 1, bounds (accumArray (+) 0 (0, 3) [(1, 2), (1, 3)] :: Array Int Int))
""",
        "only modules of base, containers and random are there: Data.Map and Data.Sequence serve in its place",
    ),
    Idiom(
        "Data.Bits, Data.Ratio and Numeric",
        """
import Data.Bits
import Data.Ratio
import Numeric (showHex)
answer = show (5 .&. 3 :: Int, shiftL 1 4 :: Int, 3 % 6 :: Rational) ++ showHex (255 :: Int) ""
""",
    ),
    Idiom(
        "Data.Maybe",
        """
import Data.Maybe
answer = show (catMaybes [Just 1, Nothing], mapMaybe (`lookup` [(1, 'a')]) [1, 2], fromMaybe 0 Nothing)
""",
    ),
    Idiom(
        "operators of one's own",
        """
infixr 5 +++
(+++) :: [a] -> [a] -> [a]
xs +++ ys = foldr (:) ys xs
answer = show ([1] +++ [2] +++ [3])
""",
    ),
    Idiom(
        "sections and backquotes",
        """
answer = show (map (subtract 1) [1, 2], map (2 ^) [1, 2, 3], 7 `divMod` 2, (`elem` "abc") 'b')
""",
    ),
    Idiom(
        "Enum and Bounded",
        """
data Day = Mon | Tue | Wed deriving (Show, Eq, Ord, Enum, Bounded)
answer = show ([minBound .. maxBound :: Day], succ Mon, fromEnum Wed)
""",
    ),
    Idiom(
        "names of Rosy as one's own",
        """
turn :: Int -> Int
turn n = n + 1
drive = turn . turn
split c s = case break (== c) s of { (a, _ : b) -> a : split c b; (a, []) -> [a] }
answer = show (drive 1, split ',' "a,b")
""",
    ),
    Idiom(
        "names of the Prelude as one's own",
        """
lookup :: Int -> [(Int, a)] -> Maybe a
lookup k = foldr (\\(a, b) r -> if a == k then Just b else r) Nothing
answer = show (lookup 1 [(1, "x")])
""",
        "a name that the program defines hides the Prelude's (rule R20); in GHC the use of the name is ambiguous",
    ),
    Idiom(
        "hiding from the Prelude",
        """
import Prelude hiding (filter)
filter p xs = [x | x <- xs, not (p x)]
answer = show (filter even [1 .. 5])
""",
    ),
    Idiom(
        "monomorphism and defaulting",
        """
average xs = sum xs / fromIntegral (length xs)
answer = show (average [1, 2, 3], 2 ^ 10, round 2.5)
""",
    ),
    Idiom(
        "type error",
        """
answer = "a" ++ 1
""",
        "both refuse; Rosy says it in its own words",
    ),
    Idiom(
        "a missing instance",
        """
data T = T
answer = show T
""",
        "both refuse; Rosy says it in its own words",
    ),
    Idiom(
        "head of an empty list",
        """
answer = show (head ([] :: [Int]))
""",
        "both end with the error; Rosy names the function in which it happened",
    ),
    Idiom(
        "incomplete patterns",
        """
f :: Int -> String
f 0 = "zero"
answer = f 0
""",
        "the same value; Rosy warns without an option",
    ),
    Idiom(
        "unsafePerformIO",
        """
import System.IO.Unsafe
answer = unsafePerformIO (return "a")
""",
        "refused: it would break what keeps other people's programs harmless",
    ),
    Idiom(
        "IORef",
        """
import Data.IORef
answer = "made"
counter :: IO (IORef Int)
counter = newIORef 0
""",
        "refused: a robot program remembers with Memory",
    ),
    Idiom(
        "reading a file",
        """
import System.IO
contents = readFile "/etc/hostname"
answer = "defined"
""",
        "refused: a program has no files",
    ),
    Idiom(
        "Template Haskell",
        """
{-# LANGUAGE TemplateHaskell #-}
answer = $( [| "a" |] )
""",
        "refused: it runs code while compiling",
    ),
    Idiom(
        "mtl",
        """
import Control.Monad.State
answer = show (evalState (do { n <- get; put (n + 1); gets (* 2) }) 3)
""",
        "only modules of base, containers and random are there; see the program with a State monad of its own",
    ),
    Idiom(
        "where bound over several guards with shadowing",
        """
f x | y > 10 = "a" | y > 5 = "b" | otherwise = let y = x in show y where y = x * 2
answer = unwords [f 6, f 3, f 1]
""",
    ),
    Idiom(
        "string gaps, escapes and unicode",
        """
answer = "tab\\t" ++ "\\955" ++ "gap\\
  \\end" ++ show "ä\\n"
""",
    ),
    Idiom(
        "block arguments",
        """
{-# LANGUAGE BlockArguments #-}
import Data.Foldable (for_)
answer = show (maybe 0 id do Just 3)
""",
    ),
]
