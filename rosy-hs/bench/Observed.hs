{-# LANGUAGE LambdaCase #-}

-- |
-- Module      : Observed
-- Description : What a step costs the program with and without provenance (rule R12), from the batch to the line that answers it.
module Observed
  ( Steps,
    steps,
    runSteps,
  )
where

import Data.ByteString.Builder (toLazyByteString)
import qualified Data.ByteString.Lazy as Lazy
import Data.IORef
import Network (Stimulus (..), network, what)
import Rosy.Link
import Rosy.Loop (What (..))
import Rosy.Program (Names (..))
import Rosy.Run (runOn)
import Rosy.Runnable (program)
import Rosy.Wire (Telling (..), writeAnswer)

-- | Steps of 20 ms.
type Steps = [Batch]

-- | So many steps as the simulator sends them: odometry in each, a tick in every fifth, a bumper in every fiftieth.
steps :: Int -> Bool -> Steps
steps n watched = [step k | k <- [0 .. n - 1]]
  where
    step k = Batch k (0.02 * fromIntegral k) (bumps k ++ odometry k) (k `mod` 5 == 0) False watched False
    bumps k = if k `mod` 50 == 49 then messages (Bump (k `mod` 100 == 99)) else []
    odometry k = messages (Odom (fromIntegral (k `mod` 7)))
    messages s = [m | Hear m <- [what s]]

-- | Run the network of the benchmark through these steps; gives the bytes of all answers.
runSteps :: Steps -> IO Int
runSteps todo = do
  left <- newIORef todo
  bytes <- newIORef 0
  let link =
        Link
          { open = const (pure (Opening 1 0)),
            next = atomicModifyIORef' left (\case [] -> ([], Nothing); batch : rest -> (rest, Just batch)),
            answer = \a -> modifyIORef' bytes (+ fromIntegral (Lazy.length (toLazyByteString (writeAnswer (Telling False False) a)))),
            end = \_ _ -> pure (),
            atWork = const (pure ()),
            atRest = pure ()
          }
  runOn link [] (program (Names [Name "hit", Name "accelerate", Name "play", Name "count"]) network)
  readIORef bytes
