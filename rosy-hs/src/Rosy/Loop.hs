{-# LANGUAGE BangPatterns #-}

-- |
-- Module      : Rosy.Loop
-- Description : One deterministic loop: a network and an instant in, firings and commands and the next network out.
--
-- Implements rules R1 to R11 and R25 of rosy-hs/LANGUAGE.md. "Rosy.Model" states the same rules without regard to speed and is authoritative.
-- Everything here is pure. A step comes out as a 'Turn': a chain of firings whose effects are not computed yet, so that
-- the driver of the loop ("Rosy.Run") can say which function is at work, and catch what it throws, before going on.
module Rosy.Loop
  ( -- * What it is
    Network,
    Turn (..),
    Firing (..),
    Cause (..),
    Outcome (..),

    -- * Running one
    Start (..),
    begin,
    What (..),
    instant,
    stop,

    -- * What came of it
    Report (..),
    collect,
    remembered,
    emissionsOf,
    Quiescence (..),
    neverQuiet,
    quiescence,
    isMark,

    -- * Limits
    roundLimit,
    stepLimit,
  )
where

import Data.Bits ((.|.))
import Data.Dynamic (dynTypeRep)
import qualified Data.IntMap.Strict as IntMap
import Data.List (sortOn)
import qualified Data.Map.Strict as Map
import Rosy.Arbitration (Latest (..), isUnheld, overAt, release)
import Rosy.Channel (Channel (..), Field, Kind (..), tellMessage)
import Rosy.Core
import Rosy.Loop.Advance
import Rosy.Loop.Deliver
import Rosy.Loop.Fire
import Rosy.Loop.Quiescence
import Rosy.Loop.State
import System.Random (StdGen)

-- | The most rounds of user events in one instant (rule R8); what is pending then waits for the next instant.
roundLimit :: Int
roundLimit = 64

-- ---------------------------------------------------------------------------------------------
-- Running one

-- | How a program starts.
data Start = Start
  { -- | Seconds, see 'Rosy.Seconds'.
    startTime :: !Double,
    -- | The time of day at time 0, seconds since midnight or since another midnight; see 'Rosy.Clock'.
    startClock :: !Double,
    startGen :: !StdGen
  }

-- | Begin a program: start its tasks as far as they go without an input.
begin :: Start -> Program r -> Turn
begin start program = runStep (advance stepLimit program) world0 resting
  where
    world0 =
      World
        { env = Env IntMap.empty 0 (startTime start) (startClock start) (startGen start) 0 IntMap.empty Map.empty,
          actions = [],
          heard = [],
          queue = [],
          emitted = 0,
          tasks = Tasks {ending = Nothing, fed = [], begun = [], nextScope = 0, cleanups = IntMap.empty, moving = [], holds = mempty, turning = ByStart}
        }

-- | What an instant is about.
data What = Hear !Message | TickNow
  deriving (Eq, Show)

-- | One instant, at so many seconds: a message or a tick, and then rounds of the events that were emitted.
instant :: Double -> What -> Network -> Turn
instant time what (Network running w) = case what of
  Hear message@(Message channel fields) -> case channelKind channel of
    EventChannel -> at (Sensed message) (env w) {envTime = time} (tellMessage message : heard w)
    _ -> at (Sensed message) (setState time channel fields (env w)) (heard w)
  TickNow -> at Tick (env w) {envTime = time} (heard w)
  where
    at !occurrence !now told =
      let !w' = w {env = now, heard = told, tasks = dropFeedback (tasks w)}
       in runStep (deliver occurrence running) (if isUnheld (holds (tasks w')) then w' else released time w') (rounds roundLimit)

-- | Sends again what second controllers want, where the time of the first ones is over (rule R25).
released :: Double -> World -> World
released time w = foldl one w (overAt time (holds (tasks w)))
  where
    one v key = case release time key (holds (tasks v)) of
      Nothing -> v
      Just (latest, after) -> maybe id sendAgain latest v {tasks = (tasks v) {holds = after}}
    sendAgain (Latest scope arbiters action) = send scope arbiters action

-- | Stores a state message and the time at which it arrived.
setState :: Double -> Channel -> [Field] -> Env -> Env
setState time channel fields e =
  e {envTime = time, envStates = IntMap.insert (channelNumber channel) fields (envStates e), envArrived = envArrived e .|. channelInterest channel}

-- | Drops feedback that was not handled in the previous instant.
dropFeedback :: Tasks -> Tasks
dropFeedback t = if null (fed t) then t else t {fed = []}

-- | Deliver what was emitted, round by round, and what that emits.
rounds :: Int -> Running r -> World -> Turn
rounds !left running !w = case (queue w, running) of
  (_ : _, Returned _) -> resting running w
  (found@(_ : _), _) | left > 0 -> runStep (each (reverse found) running) w {queue = []} (rounds (left - 1))
  _ -> resting running w
  where
    each [] r = pure r
    each (e : es) r = deliver (Emitted e) r >>= each es

resting :: Running r -> World -> Turn
resting running w = case running of
  Returned _ -> abandon Finished w
  _ -> Settled (Network running w)

-- | End the program from outside: the clean-up of all live tasks, then 'Ended'.
stop :: Network -> Turn
stop (Network _ w) = cleanUp w

-- | Take what the steps since the last time have left for the outside.
collect :: Network -> (Report, Network)
collect network@(Network running w) = case reportOf w of
  report@(Report [] []) -> (report, network)
  report -> (report, Network running w {actions = [], heard = []})

-- | What the program remembers, the outermost task's memory first, then what its tasks share: type and value, as Haskell
-- writes them. The values are not computed yet.
remembered :: Network -> [(String, String)]
remembered (Network _ w) = concatMap (kept "Memory") (IntMap.elems (envMemories (env w))) ++ kept "Param" (envParams (env w))
  where
    -- By name: the order of type representations differs between versions of GHC.
    kept of' memories = sortOn fst [(of' ++ ' ' : showsPrec 11 (dynTypeRep value) "", text) | Kept value text <- Map.elems memories]

-- | How many user events the program has sent.
emissionsOf :: Network -> Int
emissionsOf (Network _ w) = emitted w
