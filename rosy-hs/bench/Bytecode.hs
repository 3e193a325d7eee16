{-# LANGUAGE LambdaCase #-}

-- |
-- Description : Rosy's loop with the learner's functions as bytecode: run this with @ghc -e main@.
--
-- The loop, its driver and the wire's types are compiled, as in the worker; only what is in this folder is interpreted.
module Main (main) where

import Data.IORef
import Data.Maybe (isJust)
import Measure
import Network
import Rosy.Channel (Message)
import Rosy.Link
import Rosy.Loop (What (..))
import Rosy.Program (Names (..))
import Rosy.Run (runOn)
import Rosy.Runnable (program)
import System.Environment (lookupEnv)

main :: IO ()
main = do
  fired <- newIORef 0
  small <- isJust <$> lookupEnv "ROSY_BENCH_SMALL"
  let batches = if small then 1 else batchesOfOneRun
      once = run fired (replicate batches (messages (stimuli instantsOfOneBatch)))
  once
  writeIORef fired 0
  once
  firings <- readIORef fired
  costs <- inTurn (if small then 1 else 7) [once]
  mapM_ (line "Rosy, bytecode" (batches * instantsOfOneBatch) firings) costs
  where
    messages todo = [message | Hear message <- map what todo]

batchesOfOneRun, instantsOfOneBatch :: Int
batchesOfOneRun = 100
instantsOfOneBatch = 1000

-- | Run the network on a link that hands out these batches and counts what fired.
run :: IORef Int -> [[Message]] -> IO ()
run fired batches = do
  left <- newIORef (zip [0 ..] batches)
  let link =
        Link
          { open = const (pure (Opening 1 0)),
            next = atomicModifyIORef' left $ \case
              [] -> ([], Nothing)
              (k, batch) : rest -> (rest, Just (Batch k (0.02 * fromIntegral k) batch True False False False)),
            answer = \a -> modifyIORef' fired (+ length (answerFired a)),
            end = \_ _ -> pure (),
            atWork = const (pure ()),
            atRest = pure ()
          }
  runOn link [] (program (Names []) network)
