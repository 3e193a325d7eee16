-- |
-- Description : Rosy's loop with the learner's functions as bytecode: run this with @ghc -e main@.
module Main (main) where

import Control.Exception (evaluate)
import Measure
import Network

main :: IO ()
main = do
  let n = 20000
      todo = stimuli n
  _ <- evaluate (length todo)
  (firings, _) <- runRosy todo
  seconds <- times 5 (runRosy todo >> pure ())
  line "Rosy, bytecode" n firings seconds
