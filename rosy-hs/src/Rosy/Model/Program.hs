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
    Input (..),
    Output (..),
    Value (..),
    Type,

    -- * Time
    Happening (..),
    Said (..),
    Ending (..),
  )
where

-- ---------------------------------------------------------------------------------------------
-- Programs

-- | The name of a type.
type Type = String

-- | Enough values to tell things apart.
data Value = Int Int | InLeft Value | InRight Value | Tuple [Value]
  deriving (Eq, Ord, Show, Read)

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
    body :: Value -> [Output]
  }

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
    stopped :: Maybe Function
  }

-- | A task that is started beside its caller.
data Calling = Calling
  { called :: Program,
    -- | Gives any output to cancel.
    cancel :: Maybe Function,
    feedback :: Value -> Maybe Function,
    response :: Value -> Function
  }

-- ---------------------------------------------------------------------------------------------
-- Time

-- | What an instant is about. Rule 1 calls the first an event; odometry refreshes the state. The last two come from outside, between
-- two instants: the program is told to stop, and the connection to the robot is lost.
data Happening = Happens Type Value | Odometry Int | Tick | Stop | Loss
  deriving (Eq, Show)

-- | What is heard of a program: 'Halt' is the command to stand still.
data Said = Fired String | Commanded Value | Halt | Over Ending
  deriving (Eq, Show)

-- | How a program ends. Three ways name the function that is to blame.
data Ending
  = Finished
  | Stopped
  | -- | Nobody hears the program any more. What stands between it and the robot must tell the robot to stop.
    Lost
  | Failed String
  | -- | It gave a 'Done' of another type than its task's.
    EndedWrongly String
  | -- | It gave a 'Call' where nobody is left to hear from the called task.
    CalledInOnce String
  deriving (Eq, Show)
