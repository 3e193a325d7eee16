{-# LANGUAGE ExistentialQuantification #-}
{-# LANGUAGE PatternSynonyms #-}
{-# LANGUAGE RankNTypes #-}
{-# LANGUAGE StrictData #-}
{-# LANGUAGE UnboxedTuples #-}

-- |
-- Module      : Rosy.Core
-- Description : The parts of a running program as data: inputs, outputs, functions, tasks.
--
-- "Rosy.Sensor", "Rosy.Command", "Rosy.Controller" and "Rosy.Task" translate a learner's Haskell into
-- these types; "Rosy.Loop" gives them their meaning in time. Nothing here runs anything.
module Rosy.Core
  ( -- * What happens
    Occurrence (..),
    Message (..),
    Event (..),

    -- * What a function may read
    Env (..),
    Memories,
    Kept (..),
    ScopeId,
    withoutGenerators,

    -- * Inputs
    Sense (.., Sense),
    InputValue (..),
    Source (..),
    Shape (..),
    Trigger (..),
    Arrivals (..),
    Reading (..),
    Interest,
    interestedIn,
    interestIn,
    channelInterest,
    clockInterest,
    channelLimit,
    replyChannelNumber,
    lacks,
    noInterest,
    unite,
    tickInterest,

    -- * Outputs
    Plan (.., Plain),
    Effects (..),
    Effect (..),
    Action (..),
    Arbiter (..),
    Side (..),

    -- * Topics
    Topic (..),
    TopicUse (..),

    -- * Functions
    Function (..),
    FunctionName,
    functionName,
    nameText,
    nameBytes,

    -- * Tasks
    Task (..),
    Program (..),
    Spec (..),
    Call (..),
    Calling (..),
  )
where

import Control.Monad (ap, liftM)
import Data.Bits (bit, complement, unsafeShiftL, (.&.), (.|.))
import qualified Data.ByteString as ByteString
import qualified Data.ByteString.Builder as Builder
import qualified Data.ByteString.Lazy as Lazy
import Data.Dynamic (Dynamic)
import Data.IntMap.Strict (IntMap)
import Data.Map.Strict (Map)
import Data.Typeable (TypeRep)
import Data.Word (Word64)
import GHC.Fingerprint (Fingerprint)
import Rosy.Channel (Action (..), Channel (..), Field, Kind (..), Message (..))
import System.Random (StdGen, split)

-- ---------------------------------------------------------------------------------------------
-- What happens

-- | What may make a function fire.
data Occurrence
  = Sensed Message
  | Tick
  | Emitted Event

-- | A value of a declared type on its way from the function that emitted it to those that take it.
data Event = Event
  { -- | How many events the program had emitted before; set when it is queued.
    eventSerial :: Int,
    eventValue :: Dynamic,
    eventShown :: ~String
  }

-- ---------------------------------------------------------------------------------------------
-- What a function may read

-- | The number of a running task; 0 is the program outside tasks.
type ScopeId = Int

-- | One value per type, by the fingerprint of the type: two words, which are quicker to compare than types.
type Memories = Map Fingerprint Kept

-- | A value that is remembered, and how Haskell shows it: computed only when it is shown.
data Kept = Kept Dynamic ~String

-- | All that a function can read apart from events.
data Env = Env
  { -- | The current value of each state that has arrived, by the number of its channel.
    envStates :: IntMap [Field],
    -- | The channels of those states.
    envArrived :: Interest,
    -- | Seconds since the start of the program (rule R21).
    envTime :: Double,
    -- | The time of day at the start of the program, seconds.
    envClock :: Double,
    envGen :: StdGen,
    -- | Whose memory is read.
    envScope :: ScopeId,
    envMemories :: IntMap Memories,
    envParams :: Memories
  }

-- | The environment after so many random generators were used up.
withoutGenerators :: Int -> Env -> Env
withoutGenerators n env = env {envGen = iterate (snd . split) (envGen env) !! n}

-- ---------------------------------------------------------------------------------------------
-- Inputs

-- | A set of kinds of 'Occurrence', so that a function is offered only what it takes: one bit for ticks, one for user events, one for
-- messages that are a clock, and one per channel.
type Interest = Word64

-- | The kinds of an occurrence.
interestIn :: Occurrence -> Interest
interestIn occurrence = case occurrence of
  Sensed (Message channel _) -> case channelKind channel of
    ClockChannel -> channelInterest channel .|. clockInterest
    _ -> channelInterest channel
  Tick -> tickInterest
  Emitted _ -> bit 1

-- | The messages of one channel.
channelInterest :: Channel -> Interest
channelInterest channel = unsafeShiftL 1 (channelNumber channel + 3)

-- | The messages at which functions of states fire: odometry.
clockInterest :: Interest
clockInterest = bit 2

-- | The numbers of a robot's channels that a program can take are smaller than this; the last two bits are for the program's own topics, and
-- for the replies to its calls.
channelLimit :: Int
channelLimit = 59

-- | The replies to the program's calls of actions and services.
replyChannelNumber :: Int
replyChannelNumber = channelLimit + 1

-- | The empty set.
noInterest :: Interest
noInterest = 0

-- | What is in one of two sets.
unite :: Interest -> Interest -> Interest
unite = (.|.)

-- | The default-rate clock.
tickInterest :: Interest
tickInterest = bit 0

-- | Whether the second set lacks something of the first.
lacks :: Interest -> Interest -> Bool
lacks wanted there = wanted .&. complement there /= 0

-- | Whether the sets have something in common.
interestedIn :: Interest -> Interest -> Bool
interestedIn a b = a .&. b /= 0

-- | An input of a function: when it has a value, and how that value is told.
data Sense a = Sensing
  { -- | The topic that the program connects the type to.
    senseTopic :: Maybe Topic,
    senseTell :: a -> [InputValue] -> [InputValue],
    senseShape :: Shape a
  }

-- | An input of which it does not matter whether it is a topic.
pattern Sense :: (a -> [InputValue] -> [InputValue]) -> Shape a -> Sense a
pattern Sense tell shape <-
  Sensing _ tell shape
  where
    Sense tell shape = Sensing Nothing tell shape

{-# COMPLETE Sense #-}

-- | One value that a firing took: where it was read, and the value as Haskell shows it. The text is computed only when it is shown.
data InputValue = InputValue Source ~String

-- | What a function reads (rule R12).
data Source
  = -- | A message, a user event or the tick.
    FromEvent
  | -- | The current value of the channel.
    FromState Channel
  | -- | The memory of the task, of this type.
    FromMemory TypeRep
  | -- | The memory of the program, of this type.
    FromParam TypeRep
  | -- | The time since the start, or of the day.
    FromTime
  | FromGenerator
  deriving (Eq, Show)

-- | Events, states and samples (rules R1 to R3) in two constructors.
data Shape a
  = -- | Has a value only after something happened. The state @s@ keeps what has not been used yet.
    forall s. Triggered (Trigger s a)
  | -- | Can be read at any time: a state (its reading needs the message that carries it) or a sample.
    Level (Reading a)

-- | How an input follows what happens.
data Trigger s a = Trigger
  { interest :: Interest,
    -- | The states that its reading may need: a value waits until they have arrived.
    mayNeed :: Interest,
    -- | How many values one occurrence can give: one per side of an 'Either'.
    turns :: Int,
    -- | The state without any unused value.
    unused :: ~s,
    -- | In the given turn (from 0), what an occurrence of interest makes of the state.
    offer :: Int -> Occurrence -> s -> s,
    -- | The value, when every event of the input has one.
    ready :: s -> Maybe (Reading a),
    -- | The state after that value was taken.
    used :: s -> s,
    -- | For an input that never has to keep anything: what an occurrence brings, at once. It says the same as the fields
    -- above when every value is taken as it comes, and is there because most inputs are like this.
    passing :: Maybe (Occurrence -> Arrivals a)
  }

-- | What one occurrence brings, in order.
data Arrivals a = NoMore | Arrival (Reading a) (Arrivals a)

-- | A value that is there for the reading.
data Reading a = Reading
  { -- | Only once these states have arrived.
    needs :: Interest,
    -- | How many random generators it uses up.
    generators :: Int,
    -- | Reads the value. The unboxed tuple returns it without evaluating it and without a thunk for the read itself.
    readNow :: Env -> (# a #)
  }

-- ---------------------------------------------------------------------------------------------
-- Outputs

-- | How a value of type @c@ is carried out: at once, or after inputs of its own (it is a function).
data Plan c
  = -- | With the topic that the program connects the type to.
    Producing (Maybe Topic) (c -> Effects -> Effects)
  | forall n. Needing (Sense n) (c -> n -> Effects -> Effects)

-- | An output of which it does not matter whether it is a topic.
pattern Plain :: (c -> Effects -> Effects) -> Plan c
pattern Plain give <-
  Producing _ give
  where
    Plain give = Producing Nothing give

{-# COMPLETE Plain, Needing #-}

-- | What a firing does, in order. The spine is strict: when the first cell is there, all is computed.
data Effects = Nothing' | Then Effect Effects

-- | One thing a firing does.
data Effect
  = Act Action
  | -- | A command that passes these arbiters, the innermost first (rule R25).
    Arbitrated [Arbiter] Action
  | -- | One that an arbiter suppresses in this firing.
    Suppressed [Arbiter] Action
  | Emit Dynamic ~String
  | Remember TypeRep Kept
  | Share TypeRep Kept
  | -- | The value of a @Done@, and how Haskell shows it; likewise of a @Feedback@.
    End Dynamic ~String
  | Feed Dynamic ~String
  | StartCall Calling

-- | One side of a 'Rosy.priority' (rule R25).
data Arbiter = Arbiter
  { -- | The task in whose controller it stands; nothing when that is the task of the function.
    arbiterScope :: Maybe ScopeId,
    -- | Its place in that controller: the positions from the inside to the outside.
    arbiterPlace :: [Int],
    arbiterSide :: Side
  }

-- | The controller that goes before the other, for so many seconds after its last command, or the other one.
data Side = Leads Double | Follows

-- ---------------------------------------------------------------------------------------------
-- Topics

-- | A topic that the program names itself (rule R23): its name with a slash, the type of its messages, and what the program does with it.
data Topic = Topic
  { topicName :: String,
    topicType :: String,
    topicUse :: TopicUse
  }
  deriving (Eq, Show)

-- | Whether a program takes the messages of a topic or sends them.
data TopicUse = Taken | Sent
  deriving (Eq, Show)

-- ---------------------------------------------------------------------------------------------
-- Functions

-- | A function of the program with its name.
data Function = forall n. Function FunctionName (Sense n) (n -> Effects)

-- | A name in two forms: as text, and as the UTF-8 bytes that are copied out when the function starts.
data FunctionName = FunctionName
  { -- | As text.
    nameText :: String,
    -- | As UTF-8.
    nameBytes :: ByteString.ByteString
  }

instance Show FunctionName where
  showsPrec d = showsPrec d . nameText

-- | Name a function.
functionName :: String -> FunctionName
functionName text = FunctionName text (Lazy.toStrict (Builder.toLazyByteString (Builder.stringUtf8 text)))

-- ---------------------------------------------------------------------------------------------
-- Tasks

-- | An activity that ends with a value of type @end@. Tasks follow one another with @do@.
newtype Task end = Task {runTask :: forall r. (end -> Program r) -> Program r}

instance Functor Task where
  fmap = liftM

instance Applicative Task where
  pure x = Task (\k -> k x)
  (<*>) = ap
  Task m *> Task n = Task (m . const . n)

instance Monad Task where
  Task m >>= f = Task (\k -> m (\x -> runTask (f x) k))

-- | What remains to be done before an @r@ is there. Lazy in what follows, for a task may go on for ever.
data Program r
  = Return ~r
  | -- | From here on the definition of this name says what comes next.
    Within FunctionName ~(Program r)
  | forall end. RunTask (Spec end) (end -> Program r)
  | -- | Fire once and go on; no task of its own.
    Once Function ~(Program r)
  | -- | Go on when so many seconds have passed.
    WaitFor Double ~(Program r)
  | forall a b. Both ~(Program a) ~(Program b) ((a, b) -> Program r)
  | forall a b. First ~(Program a) ~(Program b) (Either a b -> Program r)

-- | One task: what it does first, what it does all the time, what it does when it is stopped.
data Spec end = Spec
  { specStart :: Maybe Function,
    specFunctions :: [Function],
    -- | Tasks of the controller, which run beside its functions.
    specTasks :: [Calling],
    specStopped :: Maybe Function,
    -- | The value of a @Done@, if it has the type of this task.
    specEnd :: Dynamic -> Maybe end,
    -- | That type, as Haskell writes it.
    specType :: ~String
  }

-- | A command that starts a task beside the functions that are running. Made with @call@.
newtype Call = Call Calling

-- | A task to start, and what to do with what comes out of it.
data Calling = forall end.
  Calling
  { -- | What the commands of the task pass besides its own arbiters.
    callArbiters :: [Arbiter],
    callProgram :: ~(Program end),
    -- | Ends with a value when the task is to be cancelled.
    callCancel :: Maybe Function,
    callFeedback :: Dynamic -> Maybe Function,
    callResponse :: end -> Function
  }
