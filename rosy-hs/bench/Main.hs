-- |
-- Description : Rosy's loop beside reactive-banana on the same network, in one run.
module Main (main) where

import Banana (runBanana)
import Control.Exception (evaluate)
import Control.Monad (unless, void)
import Measure
import Network

main :: IO ()
main = do
  let n = 200000
      todo = stimuli n
  _ <- evaluate (length todo)
  (firings, ours) <- runRosy todo
  theirs <- runBanana todo
  unless (ours == theirs) (fail ("the networks differ: " ++ show ours ++ " and " ++ show theirs))
  costs <- inTurn 9 [void (runRosy todo), void (runBanana todo)]
  case costs of
    [rosy, banana] -> do
      line "Rosy, compiled" n firings rosy
      line "reactive-banana, compiled" n firings banana
      putStrLn ("Rosy does " ++ decimals 1 (ratio banana rosy) ++ " times as much in the same time (goal: 3).")
    _ -> fail "two were measured"
