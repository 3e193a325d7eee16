{-# LANGUAGE LambdaCase #-}

-- |
-- Description : Rosy's loop with the learner's functions as bytecode: run this with @ghc -e main@.
--
-- The loop, its driver and the wire's types are compiled, as in the worker; only what is in this folder is interpreted.
module Main (main) where

import Data.IORef
import Measure
import Network
import Rosy.Core (Message)
import Rosy.Link
import Rosy.Loop (What (..))
import Rosy.Program (Names (..))
import Rosy.Run (runOn)
import Rosy.Runnable (program)

main :: IO ()
main = do
  fired <- newIORef 0
  let once = run fired (replicate batchesOfOneRun (messages (stimuli instantsOfOneBatch)))
  once
  writeIORef fired 0
  once
  firings <- readIORef fired
  costs <- inTurn 7 [once]
  mapM_ (line "Rosy, bytecode" (batchesOfOneRun * instantsOfOneBatch) firings) costs
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
          { open = pure (Opening 1),
            next = atomicModifyIORef' left $ \case
              [] -> ([], Nothing)
              (k, batch) : rest -> (rest, Just (Batch k (0.02 * fromIntegral k) batch True False)),
            answer = \a -> modifyIORef' fired (+ length (answerFired a)),
            end = \_ _ -> pure (),
            atWork = const (pure ()),
            atRest = pure ()
          }
  runOn link (program (Names []) network)
