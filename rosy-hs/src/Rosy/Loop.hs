-- |
-- Module      : Rosy.Loop
-- Description : One deterministic loop: a network and an instant in, firings and commands and the next network out.
--
-- The rules are those of LANGUAGE.md section 2; "Rosy.Model" says them again without any care for speed, and is right in doubt.
-- Everything here is pure. A step comes out as a 'Turn': a chain of firings whose effects are not computed yet, so that
-- whoever drives the loop ("Rosy.Run") can say which function is at work, and catch what it throws, before going on.
module Rosy.Loop
  ( -- * What it is
    Network,
    Turn (..),
    Firing (..),
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

    -- * Limits
    roundLimit,
    stepLimit,
  )
where

import qualified Data.IntMap.Strict as IntMap
import qualified Data.Map.Strict as Map
import Rosy.Core
import Rosy.Loop.Advance
import Rosy.Loop.Deliver
import Rosy.Loop.Fire
import Rosy.Loop.State
import Rosy.Value (shown)
import System.Random (StdGen)

-- | The most rounds of user events in one instant (rule 8); what is pending then waits for the next instant.
roundLimit :: Int
roundLimit = 64

-- ---------------------------------------------------------------------------------------------
-- Running one

-- | How a program starts.
data Start = Start
  { -- | Seconds, see 'Rosy.Seconds'.
    startTime :: !Double,
    startGen :: !StdGen
  }

-- | Begin a program: start its tasks as far as they go without an input.
begin :: Start -> Program r -> Turn
begin start program = runStep (advance stepLimit program) world0 resting
  where
    world0 =
      World
        { env = Env Nothing (startTime start) (startGen start) 0 IntMap.empty Map.empty,
          queue = [],
          emitted = 0,
          actions = [],
          heard = [],
          ending = Nothing,
          fed = [],
          begun = [],
          nextScope = 0,
          cleanups = IntMap.empty
        }

-- | What an instant is about.
data What = Hear !Message | TickNow
  deriving (Eq, Show)

-- | One instant, at so many seconds: a message or a tick, and then rounds of the events that were emitted.
instant :: Double -> What -> Network -> Turn
instant time what (Network running w) = runStep (deliver occurrence running >>= rounds roundLimit) w' resting
  where
    occurrence = case what of
      Hear message -> Sensed message
      TickNow -> Tick
    w' = case what of
      Hear (OdometryMessage o) -> w {env = (env w) {envTime = time, envOdometry = Just o}, fed = []}
      Hear message -> w {env = (env w) {envTime = time}, heard = toldMessage message : heard w, fed = []}
      TickNow -> w {env = (env w) {envTime = time}, fed = []}

-- | Deliver what was emitted, round by round, and what that emits.
rounds :: Int -> Running r -> Step (Running r)
rounds left running
  | left == 0 = pure running
  | otherwise = case running of
    Returned _ -> pure running
    _ -> do
      pending <-
        Step
          ( \w k -> case queue w of
              [] -> k [] w
              found -> k (reverse found) w {queue = []}
          )
      case pending of
        [] -> pure running
        _ -> each pending running >>= rounds (left - 1)
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
collect (Network running w) = (reportOf w, Network running w {actions = [], heard = []})

-- | What the program remembers, the outermost task's memory first, then what its tasks share: type and value, as Haskell
-- writes them. The values are not computed yet.
remembered :: Network -> [(String, String)]
remembered (Network _ w) = concatMap (kept "Memory") (IntMap.elems (envMemories (env w))) ++ kept "Param" (envParams (env w))
  where
    kept of' memories = [(of' ++ ' ' : showsPrec 11 what "", text) | (what, Kept _ text) <- Map.toAscList memories]

toldMessage :: Message -> String
toldMessage message = case message of
  ButtonMessage b -> shown b
  BumperMessage b -> shown b
  CliffMessage c -> shown c
  WheelMessage x -> shown x
  StatusMessage s -> shown s
  OdometryMessage _ -> ""
