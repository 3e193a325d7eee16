{-# LANGUAGE BangPatterns #-}
{-# LANGUAGE ExistentialQuantification #-}

-- |
-- Module      : Rosy.Loop.Deliver
-- Description : Tasks (rule R10): letting everything that runs see what happened.
module Rosy.Loop.Deliver
  ( deliver,
  )
where

import Rosy.Arbitration (rounding)
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
    over <- getTasks ending
    case over of
      Nothing -> pure (Starting scope live' spec k)
      Just _ -> afterStart stepLimit scope born spec k
  Giving scope live rest -> do
    live' <- offerIf scope occurrence live
    over <- getTasks ending
    case over of
      Nothing -> pure (Giving scope live' rest)
      Just _ -> afterOnce stepLimit scope rest
  Working scope live called spec k -> Step (\w next -> work (Delivery occurrence (interestIn occurrence) scope running live called spec k next) live w)
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

-- | An occurrence on its way through one task at work: its functions in order, then the tasks they called before, oldest first. The
-- first 'Done' ends it.
data Delivery r = forall end.
  Delivery
  { occurrenceOf :: !Occurrence,
    interestOf :: !Interest,
    scopeOf :: {-# NOUNPACK #-} !ScopeId,
    -- | The task as it was before: as it runs, its functions, what it has called.
    _before :: Running r,
    _functions :: ![Live],
    _called :: ![Called],
    _spec :: !(Spec end),
    _afterEnd :: end -> Program r,
    -- | What follows.
    _next :: Running r -> World -> Turn
  }

-- | Offers the occurrence to the remaining functions. The task is not rebuilt while its functions are unchanged and give neither @Done@ nor calls.
work :: Delivery r -> [Live] -> World -> Turn
work delivery live w0 = case dropUninterested (interestOf delivery) (occurrenceOf delivery) live of
  l : rest ->
    let unchanged w
          | uneventful w = work delivery rest w
          | otherwise = workChanged delivery rest l w
     in offerThen (scopeOf delivery) (occurrenceOf delivery) l w0 unchanged (workChanged delivery rest)
  [] -> finishUnchanged delivery w0

-- | After the last function, when the task is unchanged.
finishUnchanged :: Delivery r -> World -> Turn
finishUnchanged (Delivery occurrence _ scope running live called spec k next) w
  | null called = next running w
  | otherwise = runStep (workCalls occurrence scope spec k called [] live []) w next
{-# NOINLINE finishUnchanged #-}

-- | Continues on the slow path after a function that has changed, or that gave a @Done@ or a call.
workChanged :: Delivery r -> [Live] -> Live -> World -> Turn
workChanged (Delivery occurrence _ scope _ live called spec k next) rest l w = runStep (workRebuilding occurrence scope called spec k (l : seen) rest) w next
  where
    seen = reverse (take (length live - length rest - 1) live)
{-# NOINLINE workChanged #-}

-- | Drops functions up to the first one that listens.
dropUninterested :: Interest -> Occurrence -> [Live] -> [Live]
dropUninterested !kind !occurrence = go
  where
    go live = case live of
      l : rest | not (listens kind occurrence l) -> go rest
      _ -> live

-- | The slow path: the functions that have had their turn, newest first, and the remaining ones. It rebuilds the task.
workRebuilding :: Occurrence -> ScopeId -> [Called] -> Spec end -> (end -> Program r) -> [Live] -> [Live] -> Step (Running r)
workRebuilding occurrence scope called0 spec k = gave []
  where
    -- The calls that were begun in this turn come first.
    gave fresh seen ls = do
      quiet <- world uneventful
      if quiet then next fresh seen ls else eventful fresh seen ls
    eventful fresh seen ls = do
      more <- givenCalls scope
      over <- takeEnding
      case over of
        Nothing -> next (if null more then fresh else fresh ++ more) seen ls
        Just given -> finish stepLimit scope given (called0 ++ fresh ++ more) spec k
    next fresh seen [] = workCalls occurrence scope spec k called0 [] (reverse seen) fresh
    next fresh seen (l : ls) = do
      l' <- offerIf scope occurrence l
      gave fresh (l' : seen) ls
{-# NOINLINE workRebuilding #-}

-- | The tasks that were called before, those that had their turn, newest first, the functions of the caller, and the calls begun in this turn.
workCalls :: Occurrence -> ScopeId -> Spec end -> (end -> Program r) -> [Called] -> [Called] -> [Live] -> [Called] -> Step (Running r)
workCalls occurrence scope spec k = next
  where
    next [] kept live fresh = pure $! Working scope live (if null kept then fresh else reverse kept ++ fresh) spec k
    next (c : cs) kept live fresh = do
      result <- deliverCalled scope occurrence c
      more <- givenCalls scope
      over <- takeEnding
      case over of
        Nothing -> next cs (result ++ kept) live (if null more then fresh else fresh ++ more)
        Just given -> finish stepLimit scope given (reverse kept ++ result ++ cs ++ fresh ++ more) spec k
{-# NOINLINE workCalls #-}

-- | Start what the latest firing of the scope has called.
givenCalls :: ScopeId -> Step [Called]
givenCalls scope = do
  none <- getTasks (null . begun)
  if none then pure [] else turn (ByTask scope) >> startCalls stepLimit scope

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
