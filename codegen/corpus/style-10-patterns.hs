{-# LANGUAGE BangPatterns, ViewPatterns, ScopedTypeVariables #-}
-- Patterns of all sorts.
module Patterns where

data P = P Int Int | Q { px, py :: Int, pn :: String } | Int :+: Int

infix 5 :+:

whole :: P -> (P, Int)
whole p@(P a b) = (p, a + b)
whole p@Q {px = a, py = b} = (p, a + b)
whole p@(a :+: b) = (p, a * b)

lazy :: (Int, Int) -> Int
lazy ~(a, b) = 1

strict :: Int -> Int -> Int
strict !acc 0 = acc
strict !acc n = strict (acc + n) (n - 1)

view :: String -> Int
view (length -> 0) = 0
view (words -> [_, w]) = length w
view s = length s

typed :: Int -> Int
typed (n :: Int) = n

nested :: Maybe (Either (Int, [Int]) String) -> Int
nested Nothing = 0
nested (Just (Left (n, x : _ : rest@(y : _)))) = n + x + y + length rest
nested (Just (Left (n, []))) = n
nested (Just (Left (n, [_]))) = -n
nested (Just (Left (_, _ : _ : []))) = 2
nested (Just (Right "stop")) = 0
nested (Just (Right ('a' : s))) = length s
nested (Just (Right _)) = 1

numbers :: Double -> String
numbers 0 = "zero"
numbers (-1) = "minus one"
numbers 0.5 = "half"
numbers 1e3 = "thousand"
numbers _ = "other"

(first, second) = (1 :: Int, 2 :: Int)
[one, two, three] = [1, 2, 3 :: Int]
Just four = Just (4 :: Int)
~(five, _) | first > 0 = (5 :: Int, ())
           | otherwise = (6, ())

units :: () -> [()] -> ()
units () [] = ()
units () (() : us) = units () us

main = simulate (Velocity 0 0)
