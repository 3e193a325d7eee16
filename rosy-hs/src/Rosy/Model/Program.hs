-- |
-- Module      : Rosy.Model.Program
-- Description : Programs as the model has them, what happens to them, and what they say.
--
-- The model is untyped: a type is a name, a value is a small tree, a function is its input, its name and what it gives.
module Rosy.Model.Program
  ( -- * Programs
    Program (..),
    Spec (..),
    Function (..),
    Calling (..),
    Arbiter (..),
    Side (..),
    arbitrated,
    Input (..),
    Output (..),
    Outlet (..),
    Value (..),
    Type,

    -- * Time
    Happening (..),
    Said (..),
    Ending (..),

    -- * Provenance
    Firing (..),
    Cause (..),
    Read (..),
  )
where

import Data.IntSet (IntSet)
import Prelude hiding (Read, reads)
import qualified Prelude

-- ---------------------------------------------------------------------------------------------
-- Programs

-- | The name of a type.
type Type = String

-- | Enough values to tell things apart.
data Value = Int Int | InLeft Value | InRight Value | Tuple [Value]
  deriving (Eq, Ord, Show, Prelude.Read)

-- | What a function takes.
data Input
  = -- | Every message or emitted value of the type. The tick is the event @"()"@.
    Event Type
  | -- | What odometry said last.
    State
  | -- | The memory of the task, of a type.
    Memory Type
  | -- | The memory of the program, of a type.
    Param Type
  | -- | The time, in milliseconds.
    Time
  | -- | The time as hours, minutes, seconds and milliseconds, round the clock.
    Clock
  | -- | A random generator of its own: the first one of the program is 0, the next one 1.
    Chance
  | -- | All of these: curried arguments, tuples.
    All [Input]
  | -- | Either, as it comes. @Maybe a@ is @Either a (Event "()")@.
    Either Input Input
  deriving (Eq, Show)

-- | What a function gives.
data Output
  = Command Value
  | -- | A velocity; 0 is standing still.
    Drive Int
  | -- | The colour of a light.
    Light Int
  | -- | A velocity or a light that passes these arbiters, the innermost first; or the call of a task whose commands do.
    Arbitrated [Arbiter] Output
  | Write Type Value
  | Share Type Value
  | Emit Type Value
  | -- | The type is that of the value.
    Done Type Value
  | Feedback Value
  | Call Calling
  | -- | Something that cannot be computed.
    Fail

-- | A function of the program.
data Function = Function
  { name :: String,
    input :: Input,
    -- | All that it may give, as its type says; only rule R12 looks at it.
    outlets :: [Outlet],
    body :: Value -> [Output]
  }

-- | What a function may give, apart from commands: the memory of a type, a user event of a type, what concerns tasks ('Done', 'Feedback', 'Call').
data Outlet = MayWrite Type | MayShare Type | MayEmit Type | MayTurn
  deriving (Eq, Show)

-- | Tasks in sequence and side by side, up to the value at the end.
data Program
  = Return Value
  | Task Spec (Value -> Program)
  | Once Function Program
  | Wait Int Program
  | Both Program Program (Value -> Program)
  | First Program Program (Value -> Program)

-- | A task. A controller outside tasks is one without a start, and of a type that no 'Done' has.
data Spec = Spec
  { -- | The type of the value that it ends with.
    ends :: Type,
    start :: Maybe Function,
    functions :: [Function],
    -- | Tasks of the controller: they start with it and run beside its functions.
    tasks :: [Calling],
    stopped :: Maybe Function
  }

-- | A task that is started beside its caller.
data Calling = Calling
  { -- | What the commands of the task pass besides its own arbiters.
    arbiters :: [Arbiter],
    called :: Program,
    -- | Gives any output to cancel.
    cancel :: Maybe Function,
    feedback :: Value -> Maybe Function,
    response :: Value -> Function
  }

-- | One side of a priority (rule R25), by its number in the controller.
data Arbiter = Arbiter Int Side
  deriving (Eq, Show)

-- | The controller that goes before the other, for so many milliseconds after its last command, or the other one.
data Side = Leads Int | Follows
  deriving (Eq, Show)

-- | A function whose commands pass an arbiter.
arbitrated :: Arbiter -> Function -> Function
arbitrated arbiter f = f {body = map through . body f}
  where
    through out = case out of
      Drive _ -> Arbitrated [arbiter] out
      Light _ -> Arbitrated [arbiter] out
      Call _ -> Arbitrated [arbiter] out
      Arbitrated inner o -> Arbitrated (inner ++ [arbiter]) o
      _ -> out

-- ---------------------------------------------------------------------------------------------
-- Time

-- | What an instant is about. Rule R1 calls the first an event; odometry refreshes the state. The last two come from outside, between
-- two instants: the program is told to stop, and the connection to the robot is lost.
data Happening = Happens Type Value | Odometry Int | Tick | Stop | Loss
  deriving (Eq, Show)

-- | What is heard of a program: the names of functions that fire, commands, velocities, and how it ended.
data Said = Fired String | Commanded Value | Driven Int | Lit Int | Over Ending
  deriving (Eq, Show)

-- | How a program ends. Three ways name the function that is to blame.
data Ending
  = Finished
  | Stopped
  | -- | The program has no listener any more. What stands between it and the robot must tell the robot to stop.
    Lost
  | Failed String
  | -- | It gave a 'Done' of another type than its task's.
    EndedWrongly String
  | -- | It gave a 'Call' where nothing is left to hear from the called task.
    CalledInOnce String
  deriving (Eq, Show)

-- ---------------------------------------------------------------------------------------------
-- Provenance (rule R12)

-- | One firing of a run. Firings, instants and user events are numbered from 0, tasks by their scope.
data Firing = Firing
  { firedAt :: Int,
    firedBy :: String,
    inTask :: Int,
    cause :: Cause,
    reads :: [(Read, Value)],
    gave :: [Output],
    -- | The instants that it may depend on, whichever others there were.
    dependsOn :: IntSet
  }

-- | Why a function fired then.
data Cause
  = -- | The happening of this instant completed its inputs.
    Occurred Int
  | -- | A user event did, which this firing sent.
    Received Int Int
  | -- | It was carried out at once: because the program began,
    Began
  | -- | because a wait was over in this instant,
    Resumed Int
  | -- | because of what this firing gave,
    Followed Int
  | -- | or because the program ends.
    Ended
  deriving (Eq, Show)

-- | Where a firing took a value from. A memory has the firing that wrote it, a state the instant of its odometry, a generator its number.
data Read
  = ReadEvent
  | ReadState Int
  | ReadMemory Type (Maybe Int)
  | ReadParam Type (Maybe Int)
  | ReadTime
  | ReadChance Int
  deriving (Eq, Show)
