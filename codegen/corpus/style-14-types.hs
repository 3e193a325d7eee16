{-# LANGUAGE GADTs, TypeFamilies, ExistentialQuantification, KindSignatures, RankNTypes #-}
{-# LANGUAGE TypeApplications #-}
{-# OPTIONS_GHC -Wno-unused-top-binds #-}
-- Types beyond what blocks show stay as text; all around them becomes blocks.
import Data.Kind (Type)

data Expr :: Type -> Type where
  Number :: Double -> Expr Double
  Truth  :: Bool -> Expr Bool
  If     :: Expr Bool -> Expr a -> Expr a -> Expr a
  Plus   :: Expr Double -> Expr Double -> Expr Double

eval :: Expr a -> a
eval (Number d) = d
eval (Truth b) = b
eval (If c t e) = if eval c then eval t else eval e
eval (Plus a b) = eval a + eval b

data Any = forall a. Show a => Any a | None

shown :: Any -> String
shown (Any a) = show a
shown None = "-"

type Handler e = forall a. e a -> a

with :: Handler Expr -> Expr Double -> Double
with h e = h e

newtype Wrap f a = Wrap { unwrap :: f a }

type family Elem c
type instance Elem [e] = e

whole :: Int
whole = read @Int "3" + maxBound @Int `mod` 7

both :: (forall a. [a] -> Int) -> ([Int], String) -> Int
both f (xs, s) = f xs + f s

annotated :: Int
annotated = (1 :: Int) + length ([] :: [Bool]) + (fromIntegral (2 :: Integer) :: Int)

context :: (Show a, Eq a) => a -> (a -> a) -> String
context x f
  | f x == x = show x
  | otherwise = "changed" :: String

main = simulate (Velocity (eval (If (Truth True) (Number 0.2) (Plus (Number 1) (Number 2)))) 0)
