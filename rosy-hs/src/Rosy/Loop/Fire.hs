{-# LANGUAGE BangPatterns #-}

-- |
-- Module      : Rosy.Loop.Fire
-- Description : One function: what makes it fire (rules 1 to 5), and what its firing does (rules 6, 7, 9, 11).
module Rosy.Loop.Fire
  ( -- * Firing
    fire,
    atOnce,
    abandon,
    cleanUp,
    reportOf,

    -- * What makes a function fire
    liven,
    offerTo,
    offerIf,
  )
where

import Data.Bits ((.|.))
import qualified Data.IntMap.Strict as IntMap
import qualified Data.Map.Strict as Map
import Rosy.Core
import Rosy.Loop.State

-- | Fire with inputs that are there: one transaction (rule 6).
fire :: ScopeId -> FunctionName -> Telling n -> (n -> Effects) -> Reading n -> Step ()
fire scope name tell give (Reading _ used' look) = Step $ \w k ->
  let before = env w
      here = if envScope before == scope then before else before {envScope = scope}
      inputs = look here
      effects = give inputs
      w' = if used' == 0 then w else w {env = withoutGenerators used' before}
   in Fires (Firing name (tell inputs []) effects (cleanUp w)) (carryOut scope name effects w' (k ()))

-- | Do what a firing says, in order.
carryOut :: ScopeId -> FunctionName -> Effects -> World -> (World -> Turn) -> Turn
carryOut _ _ Nothing' !w k = k w
carryOut scope name (Then effect rest) !w k = carryOut scope name rest (w `after` effect) k
  where
    after v (Act action) = v {actions = action : actions v}
    after v (Emit value text) =
      v {queue = Event (emitted v) value text : queue v, emitted = emitted v + 1, heard = text : heard v}
    after v (Remember key value) =
      v {env = (env v) {envMemories = IntMap.insertWith (\_ old -> Map.insert key value old) scope (Map.singleton key value) (envMemories (env v))}}
    after v (Share key value) = v {env = (env v) {envParams = Map.insert key value (envParams (env v))}}
    after v (End value) = case ending v of
      Nothing -> v {ending = Just (Given name value)}
      Just _ -> v
    after v (Feed value) = v {fed = value : fed v}
    after v (StartCall calling) = v {begun = calling : begun v}

-- | End the program at once.
abandon :: Outcome -> World -> Turn
abandon outcome = Closes outcome . cleanUp

-- | Give all live tasks their clean-up, youngest first, each once; one that throws is passed over.
cleanUp :: World -> Turn
cleanUp w = case IntMap.maxViewWithKey (cleanups w) of
  Nothing -> Ended (reportOf w)
  Just ((scope, Function name inputs give), rest) ->
    let w' = w {cleanups = rest}
     in runStep (atOnce scope name inputs give) w' (const cleanUp)

-- | Fire if all inputs can be read now; functions that would have to wait are passed over.
atOnce :: ScopeId -> FunctionName -> Sense n -> (n -> Effects) -> Step ()
atOnce scope name (Sense tell shape) give = case shape of
  Triggered _ -> pure ()
  Level reading -> do
    there <- world (arrived . env)
    if needsOdometry reading && not there then pure () else fire scope name tell give reading

-- | What the steps since the last look have left for the outside.
reportOf :: World -> Report
reportOf w = Report (reverse (actions w)) (reverse (heard w))

-- | A function with fresh inputs.
liven :: Int -> Function -> Live
liven born (Function name (Sense tell shape) give) = case shape of
  Level reading -> Steady name (if needsOdometry reading then odometryInterest else interestIn Tick) tell reading give
  Triggered t -> case passing t of
    Just arrivals -> Passing name (kinds t) born tell arrivals [] give
    Nothing -> Keeping name (kinds t) born tell t (unused t) [] give
  where
    kinds t = if mayWait t then interest t .|. odometryInterest else interest t

-- | Let a function that listens see what happened, and fire as often as it has unused values. Stops at a 'Done'.
offerTo :: ScopeId -> Occurrence -> Live -> Step Live
offerTo scope occurrence live = case live of
  Steady name _ tell reading give -> live <$ fire scope name tell give reading
  Passing name kinds born tell arrivals waiting0 give -> do
    there <- world (arrived . env)
    let fires = fire scope name tell give
        same waiting = Passing name kinds born tell arrivals waiting give
        late [] = go (arrivals occurrence)
        late (r : rs) = fires r >> unlessOver (same []) (late rs)
        go NoMore = pure (if null waiting0 then live else same [])
        go (Arrival reading more) = fires reading >> unlessOver (same []) (go more)
        -- Some of several arrivals may have to wait while others do not.
        sift waiting NoMore = pure (same waiting)
        sift waiting (Arrival reading more)
          | needsOdometry reading = sift (waiting ++ [reading]) more
          | otherwise = fires reading >> unlessOver (same waiting) (sift waiting more)
    if there then late waiting0 else sift waiting0 (arrivals occurrence)
  Keeping name kinds born tell trigger state0 waiting0 give -> do
    there <- world (arrived . env)
    let fires = fire scope name tell give
        same s waiting = Keeping name kinds born tell trigger s waiting give
        late [] = turn [] 0 state0
        late (r : rs) = fires r >> unlessOver (same state0 []) (late rs)
        turn waiting i s
          | i == turns trigger = pure (same s waiting)
          | otherwise =
            let !s' = offer trigger i occurrence s
             in case ready trigger s' of
                  Nothing -> turn waiting (i + 1) s'
                  Just reading ->
                    let !s'' = used trigger s'
                     in if needsOdometry reading && not there
                          then turn (waiting ++ [reading]) (i + 1) s''
                          else fires reading >> unlessOver (same s'' waiting) (turn waiting (i + 1) s'')
    if there then late waiting0 else turn waiting0 0 state0

-- | 'offerTo', for a function that may not listen.
offerIf :: ScopeId -> Occurrence -> Live -> Step Live
offerIf scope occurrence live
  | listens (interestIn occurrence) occurrence live = offerTo scope occurrence live
  | otherwise = pure live

-- | Go on, unless a 'Done' was given: then this is what is left.
unlessOver :: a -> Step a -> Step a
unlessOver left (Step go) = Step $ \w k -> case ending w of
  Nothing -> go w k
  Just _ -> k left w
