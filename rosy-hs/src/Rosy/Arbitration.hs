{-# LANGUAGE BangPatterns #-}

-- |
-- Module      : Rosy.Arbitration
-- Description : Which of two controllers commands an actuator (rule R25).
--
-- The commands of the controllers of a 'Rosy.priority' pass an arbiter. It keeps, for each actuator, until when the first controller
-- has it, and the latest command of the second one. "Rosy.Controller" puts arbiters around functions, "Rosy.Loop" asks them.
module Rosy.Arbitration
  ( -- * Putting an arbiter around what commands
    arbitrate,
    throughArbiters,
    arbitrateCalling,
    arbitrateProgram,
    ownedBy,

    -- * What arbiters keep
    Holds,
    isUnheld,
    suppressing,
    pass,
    Latest (..),
    overAt,
    release,
    nextRelease,
    forgetController,
    forgetSender,

    -- * Time
    rounding,
  )
where

import qualified Data.Map.Strict as Map
import Data.Maybe (fromMaybe, isJust)
import Rosy.Channel
import Rosy.Core
import Rosy.Robot (sayChannel, soundChannel)

-- ---------------------------------------------------------------------------------------------
-- Putting an arbiter around what commands

-- | The commands of a function pass the arbiters, the innermost first.
arbitrate :: [Arbiter] -> Function -> Function
arbitrate arbiters (Function name inputs give) = Function name inputs (throughArbiters arbiters . give)

-- | What a firing does, with its commands on their way through the arbiters.
throughArbiters :: [Arbiter] -> Effects -> Effects
throughArbiters arbiters effects = case effects of
  Nothing' -> Nothing'
  Then effect rest -> Then (through effect) (throughArbiters arbiters rest)
  where
    through effect = case effect of
      Act action@(Action c _) | c /= sayChannel -> Arbitrated arbiters action
      Arbitrated inner action -> Arbitrated (inner ++ arbiters) action
      StartCall calling -> StartCall (arbitrateCalling arbiters calling)
      _ -> effect

-- | So do those of a task that is called.
arbitrateCalling :: [Arbiter] -> Calling -> Calling
arbitrateCalling arbiters calling = calling {callArbiters = callArbiters calling ++ arbiters}

-- | So do those of everything that a program does.
arbitrateProgram :: [Arbiter] -> Program r -> Program r
arbitrateProgram [] program = program
arbitrateProgram arbiters program = go program
  where
    go :: Program s -> Program s
    go p = case p of
      Return x -> Return x
      Within name rest -> Within name (go rest)
      RunTask spec k -> RunTask (inSpec spec) (go . k)
      Once function rest -> Once (inFunction function) (go rest)
      WaitFor seconds rest -> WaitFor seconds (go rest)
      Both a b k -> Both (go a) (go b) (go . k)
      First a b k -> First (go a) (go b) (go . k)
    inFunction = arbitrate arbiters
    inSpec spec =
      spec
        { specStart = inFunction <$> specStart spec,
          specFunctions = map inFunction (specFunctions spec),
          specTasks = map (arbitrateCalling arbiters) (specTasks spec),
          specStopped = inFunction <$> specStopped spec
        }

-- | The arbiter of a controller in this task.
ownedBy :: ScopeId -> Arbiter -> Arbiter
ownedBy scope arbiter = arbiter {arbiterScope = Just (fromMaybe scope (arbiterScope arbiter))}

-- ---------------------------------------------------------------------------------------------
-- What arbiters keep

-- | By arbiter and actuator.
type Holds = Map.Map Key Hold

-- | The task of the controller, the place in it, and the actuator.
type Key = (ScopeId, [Int], Actuator)

-- | The channel of a command, and which of several outputs or topics that share it.
data Actuator = Actuator !Int !(Maybe Selector)
  deriving (Eq, Ord)

data Selector = Output !Int | OnTopic !String
  deriving (Eq, Ord)

-- | When the first controller sent its last command, until when it has the actuator (both in seconds), and the second one's latest command.
data Hold = Hold !(Maybe (Double, Double)) !(Maybe Latest)

-- | A command that lasts, the task that sent it, and the arbiters that it has not passed yet.
data Latest = Latest !ScopeId ![Arbiter] !Action

actuatorOf :: Action -> Actuator
actuatorOf (Action c fields) = Actuator (channelNumber c) $ case fields of
  Whole i : _ | channelPlaces c > 0 -> Just (Output i)
  Text topic : Structure _ : _ -> Just (OnTopic topic)
  _ -> Nothing

-- | Whether no arbiter has had a command.
isUnheld :: Holds -> Bool
isUnheld = Map.null

-- | The effects of a firing at this time (seconds) in this task, in which suppressed commands are marked.
suppressing :: Double -> ScopeId -> Holds -> Effects -> Effects
suppressing now scope holds effects = case effects of
  Nothing' -> Nothing'
  Then effect rest -> Then (marked effect) (suppressing now scope holds rest)
  where
    marked effect = case effect of
      Arbitrated arbiters action | not (fst (pass now scope arbiters action holds)) -> Suppressed arbiters action
      _ -> effect

-- | A command on its way through arbiters: whether it passes all of them, and what they keep then.
pass :: Double -> ScopeId -> [Arbiter] -> Action -> Holds -> (Bool, Holds)
pass now scope arbiters action@(Action c _) holds = case arbiters of
  [] -> (True, holds)
  arbiter : outer ->
    let key = keyOf scope arbiter action
        Hold held latest = Map.findWithDefault (Hold Nothing Nothing) key holds
     in case arbiterSide arbiter of
          Leads time -> pass now scope outer action (Map.insert key (Hold (Just (now, now + time)) latest) holds)
          Follows ->
            let !kept = Map.insert key (Hold held (if lasts then Just (Latest scope outer action) else latest)) holds
             in if maybe False (isHeldAt now) held then (False, kept) else pass now scope outer action kept
  where
    lasts = c /= soundChannel && channelNumber c < channelLimit

keyOf :: ScopeId -> Arbiter -> Action -> Key
keyOf scope arbiter action = (fromMaybe scope (arbiterScope arbiter), arbiterPlace arbiter, actuatorOf action)

-- | In the instant of a command, and until its time is over.
isHeldAt :: Double -> (Double, Double) -> Bool
isHeldAt now (since, until') = now <= since + rounding || now + rounding < until'

-- | The arbiters, in order, whose first controller may not have the actuator any more at this time.
overAt :: Double -> Holds -> [Key]
overAt now holds = [key | (key, Hold (Just held) _) <- Map.toAscList holds, not (isHeldAt now held)]

-- | If that is so: the command of the second controller that holds again.
release :: Double -> Key -> Holds -> Maybe (Maybe Latest, Holds)
release now key holds = case Map.lookup key holds of
  Just (Hold (Just held) latest) | not (isHeldAt now held) -> Just (latest, Map.insert key (Hold Nothing latest) holds)
  _ -> Nothing

-- | When a command of a second controller will hold again; infinite when none waits for it.
nextRelease :: Holds -> Double
nextRelease holds = minimum ((1 / 0) : [until' | Hold (Just (_, until')) latest <- Map.elems holds, isJust latest])

-- | Without the arbiters of the controller of this task, which has ended.
forgetController :: ScopeId -> Holds -> Holds
forgetController scope = Map.filterWithKey (\(owner, _, _) _ -> owner /= scope)

-- | Without the commands of this task, which was stopped.
forgetSender :: ScopeId -> Holds -> Holds
forgetSender scope = Map.map $ \(Hold held latest) -> Hold held (case latest of Just (Latest sender _ _) | sender == scope -> Nothing; _ -> latest)

-- ---------------------------------------------------------------------------------------------
-- Time

-- | Instants come at sums of steps of 20 ms, whose last digits are rounded: a moment is reached when it is this near, seconds.
-- Far below the shortest time between two messages, far above the rounding of the seconds since 1970.
rounding :: Double
rounding = 1e-6
