-- |
-- Description : Rosy's loop beside reactive-banana on the same network, in one run.
--
-- A compiled firing took 0.53 to 0.69 µs and 1,241 bytes, one of reactive-banana 2.9 to 3.5 µs and 5,623 bytes: 5.0 to 5.3 times the rate
-- (goal 5).
module Main (main) where

import Banana (runBanana)
import Control.Exception (evaluate)
import Control.Monad (unless, void)
import Data.Maybe (isJust)
import Measure
import Network
import Observed
import System.Environment (lookupEnv)

main :: IO ()
main = do
  small <- isJust <$> lookupEnv "ROSY_BENCH_SMALL"
  let n = if small then 1000 else 200000
      todo = stimuli n
  _ <- evaluate (length todo)
  (firings, ours) <- runRosy todo
  theirs <- runBanana todo
  unless (ours == theirs) (fail ("the networks differ: " ++ show ours ++ " and " ++ show theirs))
  costs <- inTurn (if small then 1 else 9) [void (runRosy todo), void (runBanana todo)]
  case costs of
    [rosy, banana] -> do
      line "Rosy, compiled" n firings rosy
      line "reactive-banana, compiled" n firings banana
      putStrLn ("Rosy does " ++ decimals 1 (ratio banana rosy) ++ " times as much in the same time (goal: 5).")
    _ -> fail "two were measured"
  observed small

-- | The cost of provenance (rule R12): goal, under 15 % of an observed step of 20 ms in the simulator; nothing when a run is not observed.
observed :: Bool -> IO ()
observed small = do
  let n = if small then 500 else 50000
      (plain, watched) = (steps n False, steps n True)
  plainBytes <- runSteps plain
  watchedBytes <- runSteps watched
  costs <- inTurn (if small then 1 else 9) [void (runSteps plain), void (runSteps watched)]
  case costs of
    [without, with] -> do
      putStrLn (perStep "A step, not observed" n without plainBytes)
      putStrLn (perStep "A step, observed" n with watchedBytes)
    _ -> fail "two were measured"
  where
    perStep name n cost size =
      name ++ ": " ++ decimals 2 (median (seconds cost) * 1e6 / fromIntegral n) ++ " µs, " ++ decimals 0 (fromIntegral size / fromIntegral n) ++ " bytes of answer"
