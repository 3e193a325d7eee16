module Main (main) where

import {-# SOURCE #-} Main

main = simulate (Velocity 0 0)
