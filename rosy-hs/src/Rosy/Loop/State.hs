{-# LANGUAGE BangPatterns #-}
{-# LANGUAGE ExistentialQuantification #-}
{-# LANGUAGE PatternSynonyms #-}

-- |
-- Module      : Rosy.Loop.State
-- Description : What the loop keeps while a program runs, and the monad in which it changes.
module Rosy.Loop.State
  ( -- * What comes out
    Turn (..),
    Firing (..),
    Cause (..),
    Outcome (..),
    Report (..),

    -- * The state
    Network (..),
    World (..),
    Tasks (..),
    uneventful,
    canRead,
    Given (..),
    Live (..),
    Interests (..),
    Telling,
    listens,
    Running (..),
    Called (..),

    -- * Steps
    Step (Step, runStep),
    world,
    change,
    getTasks,
    changeTasks,
    takeEnding,
    takeFed,
  )
where

import Data.Dynamic (Dynamic)
import Data.IntMap.Strict (IntMap)
import Data.Sequence (Seq)
import GHC.Exts (oneShot)
import Rosy.Arbitration (Holds)
import Rosy.Channel (Channel (..))
import Rosy.Core

-- ---------------------------------------------------------------------------------------------
-- What comes out

-- | One step, firing by firing.
data Turn
  = -- | A function is about to fire. Once its effects are computed, this is what follows.
    Fires !Firing Turn
  | -- | The definition of this name says what comes next; it is at work until a function fires. What follows when it throws: the
    -- clean-up of the tasks that are live, and 'Ended'. The second is what follows else.
    Enters !FunctionName Turn Turn
  | -- | The step is over; the program waits for the next.
    Settled !Network
  | -- | The program is over. What follows is the clean-up of all live tasks, then 'Ended'.
    Closes !Outcome Turn
  | -- | Nothing is left to do.
    Ended !Report

-- | A function at work.
data Firing = Firing
  { firingName :: !FunctionName,
    -- | The task that it belongs to.
    firingScope :: !ScopeId,
    firingCause :: !Cause,
    -- | What it was given, and where that was read. Computed only when something asks.
    firingInputs :: [InputValue],
    -- | Evaluating this is the firing. It throws what the function throws.
    firingEffects :: Effects,
    -- | What follows when it threw: the clean-up of the tasks that were live then, and 'Ended'.
    firingFailed :: Turn
  }

-- | Why a function fires (rule R12).
data Cause
  = -- | A message, the tick or a user event completed its inputs.
    ByOccurrence !Occurrence
  | -- | It is carried out at once, because the program began.
    ByStart
  | -- | It is carried out at once, because a time had passed, or the steps of the instant before were used up.
    ByInstant
  | -- | It is carried out at once, because of what the latest firing in this scope gave: a @Done@, a call, a start.
    ByTask !ScopeId
  | -- | It is carried out at once, because of the latest @Feedback@.
    ByFeedback
  | -- | It is a clean-up at the end of the program.
    ByEnd

-- | How a program ends by itself.
data Outcome
  = Finished
  | -- | A function gave a 'Rosy.Done' of another type than the task's: the function, the type, the task's type.
    EndedWrongly String String String
  | -- | A function that is done with 'Rosy.once' called a task: the function.
    CalledInOnce String
  deriving (Eq, Show)

-- | What a step leaves for the outside, in order.
data Report = Report
  { reportActions :: [Action],
    -- | Events sensed and emitted, as Haskell shows them.
    reportEvents :: [String]
  }

-- ---------------------------------------------------------------------------------------------
-- The state

-- | All that is running.
data Network = forall r. Network !(Running r) !World

-- | The state that all parts share. It has only the fields that most firings change, because each change copies all of them; 'Tasks' has the rest.
data World = World
  { env :: !Env,
    -- | Newest first; so are the events heard.
    actions :: ![Action],
    heard :: ![String],
    -- | Emitted and not yet delivered, newest first.
    queue :: ![Event],
    emitted :: !Int,
    tasks :: !Tasks
  }

-- | The part of the shared state that changes when tasks begin, end, call or report.
data Tasks = Tasks
  { -- | The value of the first @Done@ of the functions that are firing.
    ending :: !(Maybe Given),
    -- | Feedback on its way out, newest first.
    fed :: ![Dynamic],
    -- | Calls to start, newest first.
    begun :: ![Calling],
    nextScope :: !ScopeId,
    -- | What the live tasks do when they are stopped.
    cleanups :: !(IntMap Function),
    -- | The channels that are not at rest, each with the scope that sent its command in force.
    moving :: ![(Channel, ScopeId)],
    -- | What the arbiters keep (rule R25).
    holds :: !Holds,
    -- | What led to the latest change of tasks: the cause of what is carried out at once.
    turning :: !Cause
  }

-- | The value of a @Done@, and the function that gave it.
data Given = Given !FunctionName !Dynamic

-- | A function with the state of its inputs. Each has a name, what it listens to, how its inputs are told, and what it does.
-- Those that follow events have a birth: user events with a smaller serial were emitted before and are not for it.
-- Firings may wait for states that have not arrived, oldest first; a sequence, because events keep coming meanwhile.
data Live
  = -- | Nothing to keep: reads states and samples.
    forall n. Steady !FunctionName !Interest (Telling n) !(Reading n) !(n -> Effects)
  | -- | Takes every value as it comes.
    forall n. Passing !FunctionName {-# UNPACK #-} !Interests !Int (Telling n) !(Occurrence -> Arrivals n) !(Seq (Reading n)) !(n -> Effects)
  | -- | Keeps values until their partners come.
    forall n s. Keeping !FunctionName {-# UNPACK #-} !Interests !Int (Telling n) !(Trigger s n) !s !(Seq (Reading n)) !(n -> Effects)

-- | What a function that follows events is offered: the occurrences that bring it values, and with them the states that a value may wait for.
data Interests = Interests {bringing :: !Interest, offered :: !Interest}

-- | How inputs are told.
type Telling n = n -> [InputValue] -> [InputValue]

-- | Whether an occurrence of this kind may concern the function.
listens :: Interest -> Occurrence -> Live -> Bool
listens kind occurrence live = case live of
  Steady _ kinds _ _ _ -> interestedIn kinds kind
  Passing _ kinds born _ _ _ _ -> interestedIn (offered kinds) kind && notBefore born
  Keeping _ kinds born _ _ _ _ _ -> interestedIn (offered kinds) kind && notBefore born
  where
    notBefore born = case occurrence of
      Emitted e -> eventSerial e >= born
      _ -> True

-- | Whether all states that a reading needs have arrived.
canRead :: Env -> Reading a -> Bool
canRead e reading = not (needs reading `lacks` envArrived e)

-- | What runs until it gives an @r@.
data Running r
  = Returned r
  | -- | A task whose @init@ waits for its inputs.
    forall end. Starting !ScopeId !Live !(Spec end) (end -> Program r)
  | -- | A command given once, that waits for its inputs.
    Giving !ScopeId !Live (Program r)
  | -- | A task at work: its functions, and the tasks they called.
    forall end. Working !ScopeId ![Live] ![Called] !(Spec end) (end -> Program r)
  | -- | The moment to go on.
    Waiting !Double (Program r)
  | -- | Goes on in the next instant.
    Paused (Program r)
  | forall a b. Beside !(Running a) !(Running b) ((a, b) -> Program r)
  | forall a b. Against !(Running a) !(Running b) (Either a b -> Program r)

-- | A task that was called: how far it is, what may cancel it, what the caller does with feedback and with the end.
data Called = forall end. Called !(Running end) !(Maybe Live) (Dynamic -> Maybe Function) (end -> Function)

-- ---------------------------------------------------------------------------------------------
-- The monad: state, firings, and ending at once

-- | A change of the state with firings in it; it may end the program at once.
newtype Step a = MkStep {runStep :: World -> (a -> World -> Turn) -> Turn}

-- | Builds a step with 'oneShot' lambdas, so that GHC eta-expands functions that return steps and allocates no closure for each step.
pattern Step :: (World -> (a -> World -> Turn) -> Turn) -> Step a
pattern Step run <-
  MkStep run
  where
    Step run = MkStep (oneShot (\w -> oneShot (\k -> run w k)))

{-# COMPLETE Step #-}

{- HLINT ignore Step "Avoid lambda" -}

instance Functor Step where
  fmap f (Step m) = Step (\w k -> m w (k . f))
  {-# INLINE fmap #-}

instance Applicative Step where
  pure x = Step (\w k -> k x w)
  {-# INLINE pure #-}
  Step f <*> Step m = Step (\w k -> f w (\g w' -> m w' (k . g)))
  {-# INLINE (<*>) #-}

instance Monad Step where
  Step m >>= f = Step (\w k -> m w (\x w' -> runStep (f x) w' k))
  {-# INLINE (>>=) #-}

-- | Look at the state.
world :: (World -> a) -> Step a
world f = Step (\w k -> k (f w) w)
{-# INLINE world #-}

-- | Change the state.
change :: (World -> World) -> Step ()
change f = Step (\w k -> let !w' = f w in k () w')
{-# INLINE change #-}

-- | Look at the state of the tasks.
getTasks :: (Tasks -> a) -> Step a
getTasks f = world (f . tasks)
{-# INLINE getTasks #-}

-- | Change the state of the tasks.
changeTasks :: (Tasks -> Tasks) -> Step ()
changeTasks f = change (\w -> w {tasks = f (tasks w)})
{-# INLINE changeTasks #-}

-- | Whether no function has given a @Done@ or a call since the last look; true after most firings.
uneventful :: World -> Bool
uneventful w = case tasks w of
  Tasks {ending = Nothing, begun = []} -> True
  _ -> False

-- | Read and reset the ending of the functions that fired.
takeEnding :: Step (Maybe Given)
takeEnding = Step $ \w k -> case ending (tasks w) of
  Nothing -> k Nothing w
  found -> k found w {tasks = (tasks w) {ending = Nothing}}
{-# INLINE takeEnding #-}

-- | Read and reset the feedback that is on its way out.
takeFed :: Step [Dynamic]
takeFed = Step $ \w k -> case fed (tasks w) of
  [] -> k [] w
  found -> k found w {tasks = (tasks w) {fed = []}}
