{-# LANGUAGE BangPatterns #-}
{-# LANGUAGE UnboxedTuples #-}

-- |
-- Module      : Rosy.Loop.Fire
-- Description : One function: what makes it fire (rules R1 to R5), and what its firing does (rules R6, R7, R9, R11, R25).
module Rosy.Loop.Fire
  ( -- * Firing
    fire,
    atOnce,
    send,
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
import Rosy.Arbitration (isUnheld, pass, suppressing)
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
  | otherwise = Fires firing (carryOut scope name effects (dropGenerators used' w) next)
  where
    !w = if envScope (env w0) == scope then w0 else setScope scope w0
    here = env w
    effects = case look here of (# inputs #) -> if isUnheld held then give inputs else suppressing (envTime here) scope held (give inputs)
    held = holds (tasks w)
    -- Inputs are recomputed when provenance or an error message needs them; storing them would allocate in every firing.
    !firing = Firing name scope cause (case look here of (# inputs #) -> tell inputs []) effects (cleanUp w)

-- | Do what a firing says, in order.
carryOut :: ScopeId -> FunctionName -> Effects -> World -> (World -> Turn) -> Turn
carryOut scope name effects w next = case effects of
  Nothing' -> next w
  Then effect rest -> let !w' = w `after` effect in carryOut scope name rest w' next
  where
    after v (Act action) = act scope action v
    after v (Arbitrated arbiters action) = send scope arbiters action v
    after v (Suppressed arbiters action) = send scope arbiters action v
    after v (Emit value text) = v {queue = Event (emitted v) value text : queue v, emitted = emitted v + 1, heard = text : heard v}
    after v (Remember key value) = v {env = setMemory scope key value (env v)}
    after v (Share key value) = v {env = setParam key value (env v)}
    after v (End value _) = v {tasks = setEnding (Given name value) (tasks v)}
    after v (Feed value _) = v {tasks = addFeedback value (tasks v)}
    after v (StartCall calling) = v {tasks = addCall calling (tasks v)}

-- | Sends a command.
act :: ScopeId -> Action -> World -> World
act scope action@(Action c fields) w = case channelRest c of
  Just atRest | let moves = fields /= atRest, not (moves && isLatestMover c scope (moving (tasks w))) -> updateMoving moves c scope w {actions = action : actions w}
  _ -> w {actions = action : actions w}
{-# INLINE act #-}

-- | Sends a command if its arbiters let it pass.
send :: ScopeId -> [Arbiter] -> Action -> World -> World
send scope arbiters action w = if passes then act scope action kept else kept
  where
    (passes, !after) = pass (envTime (env w)) scope arbiters action (holds (tasks w))
    kept = w {tasks = (tasks w) {holds = after}}
{-# NOINLINE send #-}

-- Updates that few firings make. They are not inlined: GHC 9.0 loads a record's fields for all branches of a function, also for those not taken.

-- | Selects the scope whose memory is read.
setScope :: ScopeId -> World -> World
setScope scope w = w {env = (env w) {envScope = scope}}
{-# NOINLINE setScope #-}

-- | Advances the random generator past so many that were used.
dropGenerators :: Int -> World -> World
dropGenerators n w = w {env = withoutGenerators n (env w)}
{-# NOINLINE dropGenerators #-}

setMemory :: ScopeId -> TypeRep -> Kept -> Env -> Env
setMemory scope what value e = e {envMemories = IntMap.insert scope (maybe (Map.singleton key value) (Map.insert key value) (IntMap.lookup scope memories)) memories}
  where
    memories = envMemories e
    key = typeRepFingerprint what
{-# NOINLINE setMemory #-}

setParam :: TypeRep -> Kept -> Env -> Env
setParam what value e = e {envParams = Map.insert (typeRepFingerprint what) value (envParams e)}
{-# NOINLINE setParam #-}

-- | Stores the value of the first @Done@; later ones are ignored (rule R10).
setEnding :: Given -> Tasks -> Tasks
setEnding given t = case ending t of
  Nothing -> t {ending = Just given}
  Just _ -> t
{-# NOINLINE setEnding #-}

addFeedback :: Dynamic -> Tasks -> Tasks
addFeedback value t = t {fed = value : fed t}
{-# NOINLINE addFeedback #-}

addCall :: Calling -> Tasks -> Tasks
addCall calling t = t {begun = calling : begun t}
{-# NOINLINE addCall #-}

-- | Whether the scope sent the latest command that set something in motion, on this channel.
isLatestMover :: Channel -> ScopeId -> [(Channel, ScopeId)] -> Bool
isLatestMover c scope before = case before of
  (newest, by) : _ -> newest == c && by == scope
  [] -> False

-- | After a command of the scope on this channel, that leaves the robot in motion or not. The list is evaluated here: a thunk
-- of it would retain every earlier state of the loop.
updateMoving :: Bool -> Channel -> ScopeId -> World -> World
updateMoving isMoving c scope w = let !rest = others (moving (tasks w)) in w {tasks = (tasks w) {moving = if isMoving then (c, scope) : rest else rest}}
  where
    others [] = []
    others (entry : more)
      | fst entry == c = more
      | otherwise = let !more' = others more in entry : more'
{-# NOINLINE updateMoving #-}

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
    cause <- getTasks turning
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
offerThen scope !occurrence live w0 unchanged changed = case live of
  Steady name _ tell reading give
    | canRead (env w0) reading -> fireThen (ByOccurrence occurrence) scope name tell give reading w0 unchanged
    | otherwise -> unchanged w0
  Passing name kinds born tell arrivals waiting0 give -> case arrivals occurrence of
    NoMore | null waiting0 -> unchanged w0
    -- One value, which need not wait, and none that waits: by far the most.
    Arrival r NoMore | null waiting0, canRead (env w0) r -> fireThen (ByOccurrence occurrence) scope name tell give r w0 unchanged
    arrived ->
      let fireWith = fireThen (ByOccurrence occurrence) scope name tell give
          finishOffer waiting w = if null waiting && null waiting0 then unchanged w else changed (Passing name kinds born tell arrivals waiting give) w
          -- What waited for a state goes first.
          late waiting Empty w = sift waiting arrived w
          late waiting (r :<| rs) w
            | canRead (env w) r = fireWith r w (unlessOver (finishOffer waiting) (late waiting rs))
            | otherwise = late (waiting |> r) rs w
          -- Some of several arrivals may have to wait while others do not.
          sift waiting NoMore w = finishOffer waiting w
          sift waiting (Arrival r more) w
            | canRead (env w) r = fireWith r w (unlessOver (finishOffer waiting) (sift waiting more))
            | otherwise = sift (waiting |> r) more w
       in late Empty waiting0 w0
  Keeping name kinds born tell trigger state0 waiting0 give -> late Empty waiting0 w0
    where
      fireWith = fireThen (ByOccurrence occurrence) scope name tell give
      finishOffer s waiting = changed (Keeping name kinds born tell trigger s waiting give)
      late waiting Empty w = turn waiting 0 state0 w
      late waiting (r :<| rs) w
        | canRead (env w) r = fireWith r w (unlessOver (finishOffer state0 waiting) (late waiting rs))
        | otherwise = late (waiting |> r) rs w
      turn waiting i s w
        | i == turns trigger = finishOffer s waiting w
        | otherwise =
          let !s' = offer trigger i occurrence s
           in case ready trigger s' of
                Nothing -> turn waiting (i + 1) s' w
                Just r ->
                  let !s'' = used trigger s'
                   in if canRead (env w) r
                        then fireWith r w (unlessOver (finishOffer s'' waiting) (turn waiting (i + 1) s''))
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
