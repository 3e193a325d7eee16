module Main where

import Rosy

-- A program with everything a tidy editor would change.
f::Int->Int
f x=x+1   
g  ::  Int  ->  Int
g   x   =   x   *   2   

h :: Int
  -> Int
h
  x
  =
  f
    (g
      x
    )

k :: Int -> Int ; k 0 = 1 ; k n = n * k (n-1)

{-# INLINE f #-}
op :: (Int->Int)->[Int]->[Int]
op _ []=[]
op q (y:ys)=q y:op q ys

w :: Int
w = a where a = b
            b = c where c = 3

main::IO ()
main=simulate$Velocity 0 0
