{-# LANGUAGE FlexibleContexts #-}
{-# LANGUAGE ScopedTypeVariables #-}
{-# LANGUAGE TypeApplications #-}

-- |
-- Module      : Rosy.Task
-- Description : Activities that end with a value, one after the other, beside each other, or on call.
--
-- > turnLeft = task (Memory (Goal 0)) turnTowardsGoal
-- > square   = replicateM_ 4 (do { forwards; turnLeft })
--
-- = Decisions
--
-- * A controller of a task sees the events that its own start emitted and later ones, never older ones.
-- * @init@ and the start of a called task read states and samples at once, when odometry has arrived.
-- * 'stopped' is carried out when a task is stopped from outside (cancelled, beaten in a 'race', ended by an error, or by
--   the person at the page), once; not when the task ends by its own 'Done'.
-- * 'Feedback' reaches the nearest 'call' around the task whose 'onFeedback' takes that type.
-- * 'Memory' that 'onFeedback' and 'onEnd' write, and a 'Done' that they give, are those of the caller.
-- * 'once' does not last, so nothing would hear of a task that it calls: a 'call' there ends the program with an error.
-- * One task may take 64 steps (tasks begun and ended) in one instant; then it goes on in the next.
module Rosy.Task
  ( -- * What it is
    Task,

    -- * Making one
    task,
    once,
    say,
    wait,

    -- * With what happens when it is stopped
    taskWith,
    TaskOptions (..),
    taskOptions,

    -- * Together
    parallel,
    race,

    -- * Names of the original
    task',
    parallel_,
    race_,

    -- * From a controller
    Call,
    call,
    CallOptions (..),
    callOptions,

    -- * With names
    within,
    taskNamed,
    taskWithNamed,
    onceNamed,
    callNamed,
  )
where

import Data.Dynamic (fromDynamic)
import Data.Proxy (Proxy (..))
import Data.Typeable (Typeable, typeRep)
import Rosy.Command
import Rosy.Controller
import Rosy.Core
import Rosy.Robot
import Rosy.Sensor
import Rosy.Time

-- | A task that does @init@ once, then all that the controller says, until it gives 'Done'.
--
-- > task (Led1 Green) (\b -> case b of { Bumper _ Pressed -> Just (Done ()); _ -> Nothing })
task :: (Command init, Controller ctrl, Typeable end, Ends end ctrl) => init -> ctrl -> Task end
task = taskNamed (Names []) (Names [])

-- | 'task' with the names of its functions: of @init@, and of the controller.
taskNamed :: (Command init, Controller ctrl, Typeable end, Ends end ctrl) => Names -> Names -> init -> ctrl -> Task end
taskNamed nameOfInit names begin ctrl = fromSpec (single nameOfInit "start of a task" begin) Nothing (partsOf names ctrl)

-- | What a task does besides its controller.
data TaskOptions starting stopped = TaskOptions
  { -- | Once, before the controller begins.
    starting :: starting,
    -- | Once, when the task is stopped before its 'Done'. Inputs that would have to be waited for make it skip.
    stopped :: stopped
  }

-- | Nothing at the start, nothing when stopped. Change what you need: @taskOptions { stopped = Velocity 0 0 }@.
taskOptions :: TaskOptions () ()
taskOptions = TaskOptions () ()

-- | 'task' with options.
taskWith :: (Command starting, Command stopped, Controller ctrl, Typeable end, Ends end ctrl) => TaskOptions starting stopped -> ctrl -> Task end
taskWith = taskWithNamed (Names []) (Names []) (Names [])

-- | 'taskWith' with the names of its functions: of 'starting', of 'stopped', and of the controller.
taskWithNamed ::
  (Command starting, Command stopped, Controller ctrl, Typeable end, Ends end ctrl) =>
  Names ->
  Names ->
  Names ->
  TaskOptions starting stopped ->
  ctrl ->
  Task end
taskWithNamed nameOfStart nameOfStop names options ctrl =
  fromSpec
    (single nameOfStart "start of a task" (starting options))
    (Just (single nameOfStop "end of a task" (stopped options)))
    (partsOf names ctrl)

fromSpec :: forall end. Typeable end => Function -> Maybe Function -> ([Function], [Calling]) -> Task end
fromSpec start stop (list, tasks) = Task (RunTask (Spec (Just start) list tasks stop fromDynamic (show (typeRep (Proxy @end)))))

-- | The task, which stands in the definition of this name: what says how it goes on, and never does, is blamed on that. It is made
-- anew whenever it is begun, so that nothing keeps what it goes on with.
within :: String -> (() -> Task a) -> Task a
within name t = Task anew
  where
    anew k = Within (functionName name) (runTask (t ()) k)

-- | Do it once, and go on. What it does may wait for what it takes.
--
-- > once (\(Button _ _) -> Led1 Green)
once :: (Command c, Ends NotInATask c) => c -> Task ()
once = onceNamed (Names [])

-- | 'once' with the name of its function.
onceNamed :: (Command c, Ends NotInATask c) => Names -> c -> Task ()
onceNamed names c = Task (\k -> Once (single names "once" c) (k ()))

-- | Say a line, and go on.
say :: String -> Task ()
say = onceNamed (Name "say") . Say

-- | Let so many seconds pass.
wait :: Seconds -> Task ()
wait (Seconds s) = Task (\k -> WaitFor s (k ()))

-- | Two tasks beside each other; ends when both have ended.
parallel :: Task a -> Task b -> Task (a, b)
parallel a b = Task (Both (runTask a Return) (runTask b Return))

-- | Two tasks beside each other; ends with the first that ends, and the other is stopped. When both end at once the left one wins.
race :: Task a -> Task b -> Task (Either a b)
race a b = Task (First (runTask a Return) (runTask b Return))

-- | A task without a start. The name of 2019.
task' :: (Controller ctrl, Typeable end, Ends end ctrl) => ctrl -> Task end
task' = task ()

-- | The same as 'parallel'. The name of 2021, for tasks whose feedback is not used.
parallel_ :: Task a -> Task b -> Task (a, b)
parallel_ = parallel

-- | The same as 'race'. The name of 2021, for tasks whose feedback is not used.
race_ :: Task a -> Task b -> Task (Either a b)
race_ = race

-- | How a called task reports, and when it is to be stopped.
data CallOptions when feed see end res = CallOptions
  { -- | Gives 'Cancel' when the task is to be stopped.
    cancelOn :: when -> Maybe Cancel,
    -- | What to do with each 'Feedback' of the task.
    onFeedback :: feed -> see,
    -- | What to do with the value the task ends with.
    onEnd :: end -> res
  }

-- | Never cancelled, feedback and value ignored. Change what you need: @callOptions { onEnd = Done }@.
callOptions :: CallOptions Never () () end ()
callOptions = CallOptions (const Nothing) (const ()) (const ())

-- | A command that starts a task beside the functions that are running. The called task is stopped when the caller's task ends.
call :: (Sensor when, Typeable feed, Command see, Command res) => Task end -> CallOptions when feed see end res -> Call
call = callNamed (Names [])

-- | 'call' with the names of its functions: of 'cancelOn', 'onFeedback' and 'onEnd', in this order.
callNamed ::
  (Sensor when, Typeable feed, Command see, Command res) =>
  Names ->
  Task end ->
  CallOptions when feed see end res ->
  Call
callNamed names called options =
  Call
    Calling
      { callArbiters = [],
        callProgram = runTask called Return,
        callCancel = Just (single cancelName "cancel of a call" (cancels . cancelOn options)),
        callFeedback = fmap (single feedbackName "feedback of a call" . onFeedback options) . fromDynamic,
        callResponse = single endName "end of a call" . onEnd options
      }
  where
    (cancelName, feedbackName, endName) = case names of
      Names [a, b, c] -> (a, b, c)
      Name _ -> (names, names, names)
      _ -> (Names [], Names [], Names [])
    cancels = fmap (const (Done Cancel))
