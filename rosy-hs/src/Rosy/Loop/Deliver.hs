{-# LANGUAGE BangPatterns #-}
{-# LANGUAGE ExistentialQuantification #-}

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
    over <- tasked ending
    case over of
      Nothing -> pure (Starting scope live' spec k)
      Just _ -> afterStart stepLimit scope born spec k
  Giving scope live rest -> do
    live' <- offerIf scope occurrence live
    over <- tasked ending
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

-- | Instants come at sums of steps of 20 ms, whose last digits are rounded: a moment is reached when it is this near, seconds.
-- Far below the shortest time between two messages, far above the rounding of the seconds since 1970.
rounding :: Double
rounding = 1e-6

-- | An occurrence on its way through one task at work: its functions in order, then the tasks they called before, oldest first. The
-- first 'Done' ends it.
data Delivery r = forall end.
  Delivery
  { occurring :: !Occurrence,
    kindOf :: !Interest,
    inScope :: {-# NOUNPACK #-} !ScopeId,
    -- | The task as it was before: as it runs, its functions, what it has called.
    _before :: Running r,
    _functions :: ![Live],
    _called :: ![Called],
    _spec :: !(Spec end),
    _afterEnd :: end -> Program r,
    -- | What follows.
    _next :: Running r -> World -> Turn
  }

-- | The functions to come. As long as all are as they were and give neither ends nor calls, which is nearly always, nothing is made anew.
work :: Delivery r -> [Live] -> World -> Turn
work delivery live w0 = case thoseListening (kindOf delivery) (occurring delivery) live of
  l : rest ->
    let asWas w
          | uneventful w = work delivery rest w
          | otherwise = workAnew delivery rest l w
     in offerThen (inScope delivery) (occurring delivery) l w0 asWas (workAnew delivery rest)
  [] -> workedAll delivery w0

-- | All functions are as they were.
workedAll :: Delivery r -> World -> Turn
workedAll (Delivery occurrence _ scope running live called spec k next) w
  | null called = next running w
  | otherwise = runStep (workCalls occurrence scope spec k called [] live []) w next
{-# NOINLINE workedAll #-}

-- | Not so any more: before these is a function that is another now, or one that ended or called something.
workAnew :: Delivery r -> [Live] -> Live -> World -> Turn
workAnew (Delivery occurrence _ scope _ live called spec k next) rest l w = runStep (workOn occurrence scope called spec k (l : seen) rest) w next
  where
    seen = reverse (take (length live - length rest - 1) live)
{-# NOINLINE workAnew #-}

-- | From the first one on that listens.
thoseListening :: Interest -> Occurrence -> [Live] -> [Live]
thoseListening !kind !occurrence = go
  where
    go live = case live of
      l : rest | not (listens kind occurrence l) -> go rest
      _ -> live

-- | The same after a function that is not as it was, or that ended or called something: those that had their turn, newest first, and those to come.
workOn :: Occurrence -> ScopeId -> [Called] -> Spec end -> (end -> Program r) -> [Live] -> [Live] -> Step (Running r)
workOn occurrence scope called0 spec k = gave []
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
{-# NOINLINE workOn #-}

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
  none <- tasked (null . begun)
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
