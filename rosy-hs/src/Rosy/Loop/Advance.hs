{-# LANGUAGE BangPatterns #-}

-- |
-- Module      : Rosy.Loop.Advance
-- Description : Tasks (rule R10): beginning, ending, calling and stopping them.
module Rosy.Loop.Advance
  ( -- * Getting on
    stepLimit,
    advance,
    afterStart,
    afterOnce,
    beside,
    against,
    finish,
    isMark,

    -- * Calls
    startCalls,
    reports,
    turn,

    -- * Stopping
    stopRunning,
  )
where

import Data.Dynamic (Dynamic, dynTypeRep, fromDynamic, toDyn)
import qualified Data.IntMap.Strict as IntMap
import Data.List (partition)
import Rosy.Arbitration (arbitrate, arbitrateProgram, forgetController, forgetSender, isUnheld, ownedBy)
import Rosy.Channel (Channel (..))
import Rosy.Core
import Rosy.Loop.Fire
import Rosy.Loop.State

-- | The most steps that one task takes in one instant: tasks begun, commands given with @once@.
-- A choice of ours, equal to 'roundLimit' and for the same reason: every instant ends.
stepLimit :: Int
stepLimit = 64

-- | Go on until something has to be waited for, or the steps of this instant are used up.
advance :: Int -> Program r -> Step (Running r)
advance !left program = case program of
  Return x -> pure (Returned x)
  _ | left <= 0 -> pure (Paused program)
  Within name rest -> Step (\w k -> Enters name (cleanUp w) (runStep (advance left rest) w k))
  RunTask spec k -> startTask left spec k
  Once function rest -> do
    scope <- freshScope
    begunNow <- tryNow scope (marked function)
    if begunNow
      then afterOnce left scope rest
      else do
        born <- world emitted
        pure (Giving scope (liven born (marked function)) rest)
  WaitFor seconds rest -> do
    now <- world (envTime . env)
    if seconds <= 0 then advance (left - 1) rest else pure (Waiting (now + seconds) rest)
  Both a b k -> do
    x <- advance (left - 1) a
    y <- advance (left - 1) b
    beside (left - 1) x y k
  First a b k -> do
    x <- advance (left - 1) a
    case x of
      Returned v -> advance (left - 1) (k (Left v))
      _ -> do
        y <- advance (left - 1) b
        against (left - 1) x y k

-- | Two tasks beside each other, as far as they are.
beside :: Int -> Running a -> Running b -> ((a, b) -> Program r) -> Step (Running r)
beside left (Returned x) (Returned y) k = advance left (k (x, y))
beside _ x y k = pure (Beside x y k)

-- | A race whose left side has not ended.
against :: Int -> Running a -> Running b -> (Either a b -> Program r) -> Step (Running r)
against left x y k = case y of
  Returned v -> do
    stopRunning x
    advance left (k (Right v))
  _ -> pure (Against x y k)

-- | From here on tasks begin and end because of this.
turn :: Cause -> Step ()
turn cause = changeTasks (\t -> t {turning = cause})

-- | A scope of its own: a new, empty memory.
freshScope :: Step ScopeId
freshScope = do
  scope <- getTasks nextScope
  scope <$ changeTasks (\t -> t {nextScope = scope + 1})

-- | Says that a function with this mark has fired.
data Fired = Fired

-- | Whether the value of an ending is only this mark.
isMark :: Dynamic -> Bool
isMark value = case fromDynamic value of
  Just Fired -> True
  Nothing -> False

-- | The function, marked so that the ending tells whether it fired.
marked :: Function -> Function
marked (Function name inputs give) = Function name inputs (append . give)
  where
    append Nothing' = Then (End (toDyn Fired) "") Nothing'
    append (Then effect rest) = Then effect (append rest)

-- | The ending, unless it is only the mark.
ofDone :: Given -> Maybe Given
ofDone given@(Given _ value) = if isMark value then Nothing else Just given

-- | Fire if all inputs can be read now; says whether it did.
tryNow :: ScopeId -> Function -> Step Bool
tryNow scope (Function name (Sense tell shape) give) = case shape of
  Triggered _ -> pure False
  Level reading -> do
    now <- world env
    cause <- getTasks turning
    if canRead now reading then True <$ fire cause scope name tell give reading else pure False

startTask :: Int -> Spec end -> (end -> Program r) -> Step (Running r)
startTask left spec k = do
  scope <- freshScope
  born <- world emitted
  case specStart spec of
    Nothing -> install left scope born spec k
    Just function -> do
      begunNow <- tryNow scope (marked function)
      if begunNow
        then afterStart left scope born spec k
        else pure (Starting scope (liven born (marked function)) spec k)

-- | The start has fired: install the controller, unless the start has ended the task.
afterStart :: Int -> ScopeId -> Int -> Spec end -> (end -> Program r) -> Step (Running r)
afterStart left scope born spec k = do
  turn (ByTask scope)
  over <- takeEnding
  case over >>= ofDone of
    Just given -> finish left scope given [] spec k
    Nothing -> install left scope born spec k

install :: Int -> ScopeId -> Int -> Spec end -> (end -> Program r) -> Step (Running r)
install left scope born spec k = do
  case specStopped spec of
    Nothing -> pure ()
    Just function -> changeTasks (\t -> t {cleanups = IntMap.insert scope function (cleanups t)})
  changeTasks (\t -> t {begun = reverse (specTasks spec) ++ begun t})
  called <- startCalls (left - 1) scope
  pure (Working scope (map (liven born) (specFunctions spec)) called spec k)

-- | A command given once is no task: nothing may end there, and nothing may be called, for nothing stays to hear of it.
afterOnce :: Int -> ScopeId -> Program r -> Step (Running r)
afterOnce left scope rest = do
  turn (ByTask scope)
  over <- takeEnding
  called <- getTasks begun
  changeTasks (\t -> t {begun = []})
  forget scope
  case over of
    Just given | Just _ <- ofDone given -> wrongEnd given "nothing: it is not in a task"
    Just (Given name _) | not (null called) -> Step (\w _ -> abandon (CalledInOnce (nameText name)) w)
    _ -> advance (left - 1) rest

-- | The task has ended: its functions are gone, its calls are stopped, the value is handed on (rule R10).
finish :: Int -> ScopeId -> Given -> [Called] -> Spec end -> (end -> Program r) -> Step (Running r)
finish left scope given@(Given _ value) called spec k = case specEnd spec value of
  Nothing -> wrongEnd given (specType spec)
  Just x -> do
    turn (ByTask scope)
    mapM_ stopCalled called
    changeTasks (\t -> t {cleanups = IntMap.delete scope (cleanups t), begun = []})
    forget scope
    advance (left - 1) (k x)

wrongEnd :: Given -> String -> Step a
wrongEnd (Given name value) wanted =
  Step (\w _ -> abandon (EndedWrongly (nameText name) (show (dynTypeRep value)) wanted) w)

forget :: ScopeId -> Step ()
forget scope = change (withoutHolds . withoutMemory)
  where
    withoutMemory w =
      if IntMap.member scope (envMemories (env w))
        then w {env = (env w) {envMemories = IntMap.delete scope (envMemories (env w))}}
        else w
    withoutHolds w = if isUnheld (holds (tasks w)) then w else w {tasks = (tasks w) {holds = forgetController scope (holds (tasks w))}}

-- | Stop all that is live in there, children first, each clean-up once.
stopRunning :: Running r -> Step ()
stopRunning running = case running of
  Returned _ -> pure ()
  Starting scope _ _ _ -> forget scope
  Giving scope _ _ -> forget scope
  Working scope _ called _ _ -> do
    mapM_ stopCalled called
    before <- getTasks id
    case IntMap.lookup scope (cleanups before) of
      Nothing -> pure ()
      Just (Function name inputs give) -> do
        changeTasks (\t -> t {cleanups = IntMap.delete scope (cleanups t)})
        atOnce scope name inputs give
        -- A task that is being stopped can neither end nor call.
        changeTasks (\t -> t {ending = ending before, begun = begun before})
    standStill scope
    forget scope
  Waiting _ _ -> pure ()
  Paused _ -> pure ()
  Beside a b _ -> stopRunning a >> stopRunning b
  Against a b _ -> stopRunning a >> stopRunning b

-- | Tell the robot to stand if a function of this scope set it in motion last (rule R10).
standStill :: ScopeId -> Step ()
standStill scope = change $ \w -> case (partition ((== scope) . snd) (moving (tasks w)), tasks w) of
  (([], _), before) | isUnheld (holds before) -> w
  (([], _), before) -> w {tasks = before {holds = forgetSender scope (holds before)}}
  ((own, others), before) -> w {actions = [Action c rest | (c, _) <- own, Just rest <- [channelRest c]] ++ actions w, tasks = before {moving = others, holds = forgetSender scope (holds before)}}

stopCalled :: Called -> Step ()
stopCalled (Called running _ _ _) = stopRunning running

-- | Start the tasks that were called since the last look.
startCalls :: Int -> ScopeId -> Step [Called]
startCalls left scope = do
  calls <- getTasks begun
  case calls of
    [] -> pure []
    _ -> do
      changeTasks (\t -> t {begun = []})
      cause <- getTasks turning
      concat <$> mapM (\calling -> turn cause >> start calling) (reverse calls)
  where
    -- What the caller's functions ended with is not for the called, and comes first.
    start (Calling arbiters program canceller feedback response) = do
      born <- world emitted
      outer <- takeFed
      ended <- takeEnding
      running <- advance left (arbitrateProgram (map (ownedBy scope) arbiters) program)
      called <- reports outer scope (Called running (fmap (liven born) canceller) (fmap arbitrated . feedback) (arbitrated . response))
      case ended of
        Nothing -> pure called
        Just _ -> called <$ changeTasks (\t -> t {ending = ended})
      where
        arbitrated function = if null arbiters then function else arbitrate arbiters function

-- | Carry out what the caller does with feedback and with the end. Feedback that is not taken here goes further out.
reports :: [Dynamic] -> ScopeId -> Called -> Step [Called]
reports outer scope called@(Called running _ feedback response) = do
  own <- takeFed
  changeTasks (\t -> t {fed = outer})
  cause <- getTasks turning
  mapM_ tell (reverse own)
  case running of
    Returned x -> [] <$ (turn cause >> carry (response x))
    _ -> pure [called]
  where
    tell value = case feedback value of
      Just function -> turn ByFeedback >> carry function
      Nothing -> changeTasks (\t -> t {fed = value : fed t})
    carry (Function name inputs give) = atOnce scope name inputs give
