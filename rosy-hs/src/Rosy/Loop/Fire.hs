{-# LANGUAGE BangPatterns #-}
{-# LANGUAGE UnboxedTuples #-}

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
    offerThen,
    offerIf,
  )
where

import Data.Bits ((.|.))
import Data.Dynamic (Dynamic)
import qualified Data.IntMap.Strict as IntMap
import qualified Data.Map.Strict as Map
import Data.Sequence (Seq (..), (|>))
import Data.Typeable (TypeRep, typeRepFingerprint)
import Rosy.Channel (Channel (..))
import Rosy.Core
import Rosy.Loop.State

-- | Fire with inputs that are there: one transaction (rule R6).
fire :: Cause -> ScopeId -> FunctionName -> Telling n -> (n -> Effects) -> Reading n -> Step ()
fire cause scope name tell give reading = Step (\w k -> fireThen cause scope name tell give reading w (k ()))
{-# INLINE fire #-}

-- | 'fire', with what follows.
fireThen :: Cause -> ScopeId -> FunctionName -> Telling n -> (n -> Effects) -> Reading n -> World -> (World -> Turn) -> Turn
fireThen cause scope name tell give (Reading _ used' look) w0 next
  | used' == 0 = Fires firing (carryOut scope name effects w next)
  | otherwise = Fires firing (carryOut scope name effects (w `without` used') next)
  where
    !w = if envScope (env w0) == scope then w0 else w0 `inside` scope
    here = env w
    effects = case look here of (# inputs #) -> give inputs
    -- The inputs are read again when somebody asks for them: that costs less than to keep them for each firing.
    !firing = Firing name scope cause (case look here of (# inputs #) -> tell inputs []) effects (cleanUp w)

-- | Do what a firing says, in order.
carryOut :: ScopeId -> FunctionName -> Effects -> World -> (World -> Turn) -> Turn
carryOut scope name effects w next = case effects of
  Nothing' -> next w
  Then effect rest -> let !w' = w `after` effect in carryOut scope name rest w' next
  where
    after v (Act action@(Action c fields)) = case channelRest c of
      Just atRest | let moves = fields /= atRest, not (moves && isInForce c scope (moving (tasks v))) -> moved moves c scope v {actions = action : actions v}
      _ -> v {actions = action : actions v}
    after v (Emit value text) = v {queue = Event (emitted v) value text : queue v, emitted = emitted v + 1, heard = text : heard v}
    after v (Remember key value) = v {env = remembering scope key value (env v)}
    after v (Share key value) = v {env = sharing key value (env v)}
    after v (End value _) = v {tasks = endedWith (Given name value) (tasks v)}
    after v (Feed value _) = v {tasks = feeding value (tasks v)}
    after v (StartCall calling) = v {tasks = calledWith calling (tasks v)}

-- What follows is not for every firing. It stands by itself, and is not inlined, so that a firing reads only what it needs of the state.

-- | From here on it is this scope's memory that is read.
inside :: World -> ScopeId -> World
inside w scope = w {env = (env w) {envScope = scope}}
{-# NOINLINE inside #-}

without :: World -> Int -> World
without w n = w {env = withoutGenerators n (env w)}
{-# NOINLINE without #-}

remembering :: ScopeId -> TypeRep -> Kept -> Env -> Env
remembering scope what value e = e {envMemories = IntMap.insert scope (maybe (Map.singleton key value) (Map.insert key value) (IntMap.lookup scope memories)) memories}
  where
    memories = envMemories e
    key = typeRepFingerprint what
{-# NOINLINE remembering #-}

sharing :: TypeRep -> Kept -> Env -> Env
sharing what value e = e {envParams = Map.insert (typeRepFingerprint what) value (envParams e)}
{-# NOINLINE sharing #-}

-- | The first one counts.
endedWith :: Given -> Tasks -> Tasks
endedWith given t = case ending t of
  Nothing -> t {ending = Just given}
  Just _ -> t
{-# NOINLINE endedWith #-}

feeding :: Dynamic -> Tasks -> Tasks
feeding value t = t {fed = value : fed t}
{-# NOINLINE feeding #-}

calledWith :: Calling -> Tasks -> Tasks
calledWith calling t = t {begun = calling : begun t}
{-# NOINLINE calledWith #-}

-- | Whether the scope sent the latest command that set something in motion, on this channel.
isInForce :: Channel -> ScopeId -> [(Channel, ScopeId)] -> Bool
isInForce c scope before = case before of
  (newest, by) : _ -> newest == c && by == scope
  [] -> False

-- | After a command of the scope on this channel, that leaves the robot in motion or not. The list is computed here: a promise of one
-- would keep every state of the loop since the last command that was at rest.
moved :: Bool -> Channel -> ScopeId -> World -> World
moved isMoving c scope w = let !rest = others (moving (tasks w)) in w {tasks = (tasks w) {moving = if isMoving then (c, scope) : rest else rest}}
  where
    others [] = []
    others (entry : more)
      | fst entry == c = more
      | otherwise = let !more' = others more in entry : more'
{-# NOINLINE moved #-}

-- | End the program at once.
abandon :: Outcome -> World -> Turn
abandon outcome = Closes outcome . cleanUp

-- | Give all live tasks their clean-up, youngest first, each once; one that throws is passed over.
cleanUp :: World -> Turn
cleanUp w = case IntMap.maxViewWithKey (cleanups (tasks w)) of
  Nothing -> Ended (reportOf w)
  Just ((scope, Function name inputs give), rest) ->
    let w' = w {tasks = (tasks w) {cleanups = rest, turning = ByEnd}}
     in runStep (atOnce scope name inputs give) w' (const cleanUp)

-- | Fire if all inputs can be read now; functions that would have to wait are passed over.
atOnce :: ScopeId -> FunctionName -> Sense n -> (n -> Effects) -> Step ()
atOnce scope name (Sense tell shape) give = case shape of
  Triggered _ -> pure ()
  Level reading -> do
    now <- world env
    cause <- tasked turning
    if canRead now reading then fire cause scope name tell give reading else pure ()

-- | What the steps since the last look have left for the outside.
reportOf :: World -> Report
reportOf w = Report (inOrder (actions w)) (inOrder (heard w))
  where
    inOrder found = case found of
      _ : _ : _ -> reverse found
      _ -> found

-- | A function with fresh inputs.
liven :: Int -> Function -> Live
liven born (Function name (Sense tell shape) give) = case shape of
  Level reading -> Steady name (if needs reading == 0 then interestIn Tick else clockInterest) tell reading give
  Triggered t -> case passing t of
    Just arrivals -> Passing name (kinds t) born tell arrivals Empty give
    Nothing -> Keeping name (kinds t) born tell t (unused t) Empty give
  where
    kinds t = Interests (interest t) (interest t .|. mayNeed t)

-- | Let a function that listens see what happened, and fire as often as it has unused values. Stops at a 'Done'. What follows
-- when the function is as it was, and when it is another.
offerThen :: ScopeId -> Occurrence -> Live -> World -> (World -> Turn) -> (Live -> World -> Turn) -> Turn
offerThen scope !occurrence live w0 asWas changed = case live of
  Steady name _ tell reading give
    | canRead (env w0) reading -> fireThen (ByOccurrence occurrence) scope name tell give reading w0 asWas
    | otherwise -> asWas w0
  Passing name kinds born tell arrivals waiting0 give -> case arrivals occurrence of
    NoMore | null waiting0 -> asWas w0
    -- One value, which need not wait, and none that waits: by far the most.
    Arrival r NoMore | null waiting0, canRead (env w0) r -> fireThen (ByOccurrence occurrence) scope name tell give r w0 asWas
    arrived ->
      let fires = fireThen (ByOccurrence occurrence) scope name tell give
          same waiting w = if null waiting && null waiting0 then asWas w else changed (Passing name kinds born tell arrivals waiting give) w
          -- What waited for a state goes first.
          late waiting Empty w = sift waiting arrived w
          late waiting (r :<| rs) w
            | canRead (env w) r = fires r w (unlessOver (same waiting) (late waiting rs))
            | otherwise = late (waiting |> r) rs w
          -- Some of several arrivals may have to wait while others do not.
          sift waiting NoMore w = same waiting w
          sift waiting (Arrival r more) w
            | canRead (env w) r = fires r w (unlessOver (same waiting) (sift waiting more))
            | otherwise = sift (waiting |> r) more w
       in late Empty waiting0 w0
  Keeping name kinds born tell trigger state0 waiting0 give -> late Empty waiting0 w0
    where
      fires = fireThen (ByOccurrence occurrence) scope name tell give
      same s waiting = changed (Keeping name kinds born tell trigger s waiting give)
      late waiting Empty w = turn waiting 0 state0 w
      late waiting (r :<| rs) w
        | canRead (env w) r = fires r w (unlessOver (same state0 waiting) (late waiting rs))
        | otherwise = late (waiting |> r) rs w
      turn waiting i s w
        | i == turns trigger = same s waiting w
        | otherwise =
          let !s' = offer trigger i occurrence s
           in case ready trigger s' of
                Nothing -> turn waiting (i + 1) s' w
                Just r ->
                  let !s'' = used trigger s'
                   in if canRead (env w) r
                        then fires r w (unlessOver (same s'' waiting) (turn waiting (i + 1) s''))
                        else turn (waiting |> r) (i + 1) s'' w
  where
    -- Go on, unless a 'Done' was given: then this is what is left.
    unlessOver left go w = case ending (tasks w) of
      Nothing -> go w
      Just _ -> left w

-- | 'offerThen', for a function that may not listen.
offerIf :: ScopeId -> Occurrence -> Live -> Step Live
offerIf scope occurrence live
  | listens (interestIn occurrence) occurrence live = Step (\w k -> offerThen scope occurrence live w (k live) k)
  | otherwise = pure live
