{-# LANGUAGE BangPatterns #-}

-- |
-- Module      : Rosy.Loop.Deliver
-- Description : Tasks (rule R10): letting everything that runs see what happened.
module Rosy.Loop.Deliver
  ( deliver,
  )
where

import Rosy.Core
import Rosy.Loop.Advance
import Rosy.Loop.Fire
import Rosy.Loop.State

-- | Let everything that runs see what happened, in the program's order.
deliver :: Occurrence -> Running r -> Step (Running r)
deliver occurrence running = case running of
  Returned _ -> pure running
  Starting scope live spec k -> do
    born <- world emitted
    live' <- offerIf scope occurrence live
    over <- world ending
    case over of
      Nothing -> pure (Starting scope live' spec k)
      Just _ -> afterStart stepLimit scope born spec k
  Giving scope live rest -> do
    live' <- offerIf scope occurrence live
    over <- world ending
    case over of
      Nothing -> pure (Giving scope live' rest)
      Just _ -> afterOnce stepLimit scope rest
  Working scope live called spec k -> work scope occurrence live called spec k
  Waiting moment rest
    | Emitted _ <- occurrence -> pure running
    | otherwise -> do
      now <- world (envTime . env)
      if now + rounding >= moment then turn ByInstant >> advance stepLimit rest else pure running
  Paused rest
    | Emitted _ <- occurrence -> pure running
    | otherwise -> turn ByInstant >> advance stepLimit rest
  Beside a b k -> do
    x <- deliver occurrence a
    y <- deliver occurrence b
    beside stepLimit x y k
  Against a b k -> do
    x <- deliver occurrence a
    case x of
      Returned v -> do
        stopRunning b
        advance stepLimit (k (Left v))
      _ -> do
        y <- deliver occurrence b
        against stepLimit x y k

-- | Instants come at sums of steps of 20 ms, whose last digits are rounded: a moment is reached when it is this near, seconds.
-- Far below the shortest time between two messages, far above the rounding of the seconds since 1970.
rounding :: Double
rounding = 1e-6

-- | One task at work: its functions in order, then the tasks they called before, oldest first. The first 'Done' ends it.
work :: ScopeId -> Occurrence -> [Live] -> [Called] -> Spec end -> (end -> Program r) -> Step (Running r)
work scope occurrence live0 called0 spec k = leaves live0 [] []
  where
    !kind = interestIn occurrence
    -- Functions that have had their turn, newest first; calls begun in this turn.
    leaves [] seen fresh = calls called0 [] (reverse seen) fresh
    leaves (l : ls) seen fresh | not (listens kind occurrence l) = leaves ls (l : seen) fresh
    leaves (l : ls) seen fresh = do
      l' <- offerTo scope occurrence l
      quiet <- world uneventful
      if quiet then leaves ls (l' : seen) fresh else leafDone l' ls seen fresh
    leafDone l' ls seen fresh = do
      more <- givenCalls scope
      over <- takeEnding
      case over of
        Nothing -> leaves ls (l' : seen) (if null more then fresh else fresh ++ more)
        Just given -> finish stepLimit scope given (called0 ++ fresh ++ more) spec k
    calls [] kept live fresh = pure (Working scope live (if null kept then fresh else reverse kept ++ fresh) spec k)
    calls (c : cs) kept live fresh = do
      result <- deliverCalled scope occurrence c
      more <- givenCalls scope
      over <- takeEnding
      case over of
        Nothing -> calls cs (result ++ kept) live (if null more then fresh else fresh ++ more)
        Just given -> finish stepLimit scope given (reverse kept ++ result ++ cs ++ fresh ++ more) spec k

-- | Start what the latest firing of the scope has called.
givenCalls :: ScopeId -> Step [Called]
givenCalls scope = do
  none <- world (null . begun)
  if none then pure [] else turn (ByTask scope) >> startCalls stepLimit scope

-- | Nothing ended or was called: by far the most firings.
uneventful :: World -> Bool
uneventful w = case ending w of
  Nothing -> null (begun w)
  Just _ -> False

-- | A called task sees what happened: first whether it is to be cancelled, then its own functions, then its reports.
deliverCalled :: ScopeId -> Occurrence -> Called -> Step [Called]
deliverCalled scope occurrence (Called running cancel feedback response) = do
  cancel' <- traverse (offerIf scope occurrence) cancel
  cancelled <- takeEnding
  case cancelled of
    Just _ -> [] <$ (turn (ByTask scope) >> stopRunning running)
    Nothing -> do
      outer <- takeFed
      running' <- deliver occurrence running
      reports outer scope (Called running' cancel' feedback response)
