module Rosy (main) where

main = simulate (Velocity 0 0)
