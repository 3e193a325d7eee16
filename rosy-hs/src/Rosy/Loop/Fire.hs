{-# LANGUAGE BangPatterns #-}

-- |
-- Module      : Rosy.Loop.Fire
-- Description : One function: what makes it fire (rules R1 to R5), and what its firing does (rules R6, R7, R9, R11).
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
import Data.Sequence (Seq (..), (|>))
import Rosy.Channel (Channel (..))
import Rosy.Core
import Rosy.Loop.State

-- | Fire with inputs that are there: one transaction (rule R6).
fire :: Cause -> ScopeId -> FunctionName -> Telling n -> (n -> Effects) -> Reading n -> Step ()
fire cause scope name tell give (Reading _ used' look) = Step $ \w k ->
  let before = env w
      here = if envScope before == scope then before else before {envScope = scope}
      inputs = look here
      effects = give inputs
      w' = if used' == 0 then w else w {env = withoutGenerators used' before}
   in Fires (Firing name scope cause (tell inputs []) effects (cleanUp w)) (carryOut scope name effects w' (k ()))

-- | Do what a firing says, in order.
carryOut :: ScopeId -> FunctionName -> Effects -> World -> (World -> Turn) -> Turn
carryOut _ _ Nothing' !w k = k w
carryOut scope name (Then effect rest) !w k = carryOut scope name rest (w `after` effect) k
  where
    after v (Act action@(Action c fields)) = case channelRest c of
      Just rest -> v {actions = action : actions v, moving = [(c, scope) | fields /= rest] ++ filter ((/= c) . fst) (moving v)}
      Nothing -> v {actions = action : actions v}
    after v (Emit value text) =
      v {queue = Event (emitted v) value text : queue v, emitted = emitted v + 1, heard = text : heard v}
    after v (Remember key value) =
      v {env = (env v) {envMemories = IntMap.insertWith (\_ old -> Map.insert key value old) scope (Map.singleton key value) (envMemories (env v))}}
    after v (Share key value) = v {env = (env v) {envParams = Map.insert key value (envParams (env v))}}
    after v (End value _) = case ending v of
      Nothing -> v {ending = Just (Given name value)}
      Just _ -> v
    after v (Feed value _) = v {fed = value : fed v}
    after v (StartCall calling) = v {begun = calling : begun v}

-- | End the program at once.
abandon :: Outcome -> World -> Turn
abandon outcome = Closes outcome . cleanUp

-- | Give all live tasks their clean-up, youngest first, each once; one that throws is passed over.
cleanUp :: World -> Turn
cleanUp w = case IntMap.maxViewWithKey (cleanups w) of
  Nothing -> Ended (reportOf w)
  Just ((scope, Function name inputs give), rest) ->
    let w' = w {cleanups = rest, turning = ByEnd}
     in runStep (atOnce scope name inputs give) w' (const cleanUp)

-- | Fire if all inputs can be read now; functions that would have to wait are passed over.
atOnce :: ScopeId -> FunctionName -> Sense n -> (n -> Effects) -> Step ()
atOnce scope name (Sense tell shape) give = case shape of
  Triggered _ -> pure ()
  Level reading -> do
    now <- world env
    cause <- world turning
    if canRead now reading then fire cause scope name tell give reading else pure ()

-- | What the steps since the last look have left for the outside.
reportOf :: World -> Report
reportOf w = Report (reverse (actions w)) (reverse (heard w))

-- | A function with fresh inputs.
liven :: Int -> Function -> Live
liven born (Function name (Sense tell shape) give) = case shape of
  Level reading -> Steady name (if needs reading == 0 then interestIn Tick else clockInterest) tell reading give
  Triggered t -> case passing t of
    Just arrivals -> Passing name (kinds t) born tell arrivals Empty give
    Nothing -> Keeping name (kinds t) born tell t (unused t) Empty give
  where
    kinds t = Interests (interest t) (interest t .|. mayNeed t)

-- | Let a function that listens see what happened, and fire as often as it has unused values. Stops at a 'Done'.
offerTo :: ScopeId -> Occurrence -> Live -> Step Live
offerTo scope occurrence live = case live of
  Steady name _ tell reading give -> do
    now <- world env
    if canRead now reading then live <$ fire (ByOccurrence occurrence) scope name tell give reading else pure live
  Passing name kinds born tell arrivals waiting0 give -> do
    now <- world env
    let fires = fire (ByOccurrence occurrence) scope name tell give
        same waiting = Passing name kinds born tell arrivals waiting give
        -- What waited for a state goes first.
        late waiting Empty = sift waiting (arrivals occurrence)
        late waiting (r :<| rs)
          | canRead now r = fires r >> unlessOver (same waiting) (late waiting rs)
          | otherwise = late (waiting |> r) rs
        -- Some of several arrivals may have to wait while others do not.
        sift Empty NoMore = pure (if null waiting0 then live else same Empty)
        sift waiting NoMore = pure (same waiting)
        sift waiting (Arrival reading more)
          | canRead now reading = fires reading >> unlessOver (same waiting) (sift waiting more)
          | otherwise = sift (waiting |> reading) more
    late Empty waiting0
  Keeping name kinds born tell trigger state0 waiting0 give -> do
    now <- world env
    let fires = fire (ByOccurrence occurrence) scope name tell give
        same s waiting = Keeping name kinds born tell trigger s waiting give
        late waiting Empty = turn waiting 0 state0
        late waiting (r :<| rs)
          | canRead now r = fires r >> unlessOver (same state0 waiting) (late waiting rs)
          | otherwise = late (waiting |> r) rs
        turn waiting i s
          | i == turns trigger = pure (same s waiting)
          | otherwise =
            let !s' = offer trigger i occurrence s
             in case ready trigger s' of
                  Nothing -> turn waiting (i + 1) s'
                  Just reading ->
                    let !s'' = used trigger s'
                     in if canRead now reading
                          then fires reading >> unlessOver (same s'' waiting) (turn waiting (i + 1) s'')
                          else turn (waiting |> reading) (i + 1) s''
    late Empty waiting0

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
