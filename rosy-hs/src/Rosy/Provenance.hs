{-# LANGUAGE BangPatterns #-}

-- |
-- Module      : Rosy.Provenance
-- Description : Provenance of firings (rule R12): cause, reads with their versions, outputs.
--
-- The loop gives each firing with the occurrence that caused it. A 'Watch' follows the firings in order and adds what only the past
-- tells: which firing wrote a memory that is read, which firing sent an event, which message refreshed a state. It is kept only
-- while a run is observed; the loop itself keeps nothing for it. "Rosy.Model" says the same and is authoritative.
module Rosy.Provenance
  ( -- * Records
    Record (..),
    Reason (..),
    Input (..),
    Origin (..),
    Output (..),
    Sink (..),

    -- * Following a run
    Watch,
    watchFrom,
    Observed (..),
    follow,
  )
where

import Data.Dynamic (dynTypeRep)
import qualified Data.IntMap.Strict as IntMap
import qualified Data.Map.Strict as Map
import Data.Typeable (TypeRep)
import Rosy.BranchCoverage (TakenBranch)
import Rosy.Channel (Action (..), Channel (..), Message (..), tellAction, tellMessage)
import Rosy.Core hiding (Action, Message)
import Rosy.Loop

-- ---------------------------------------------------------------------------------------------
-- Records

-- | One firing of a run.
data Record = Record
  { -- | Its number among the firings, from 0.
    recordNumber :: !Int,
    recordFunction :: String,
    -- | The scope of its task; 0 is the first one of the program.
    recordTask :: !ScopeId,
    recordReason :: !Reason,
    recordInputs :: [Input],
    recordOutputs :: [Output],
    -- | The branches that it took, in their order, as far as the program was compiled to tell.
    recordBranches :: [TakenBranch]
  }

-- | Why it fired. Instants, firings and user events have numbers from 0; a firing before the observation began has none.
data Reason
  = -- | The message of this instant, as Haskell shows it.
    OfMessage !Int String
  | OfTick !Int
  | -- | A user event, and the firing that sent it.
    OfEvent !Int !(Maybe Int)
  | -- | It was carried out at once: because the program began, because a wait was over at this instant, because of what this firing
    -- gave, at the end of the program.
    OfStart
  | OfWait !Int
  | OfFiring !(Maybe Int)
  | OfEnd
  deriving (Eq, Show)

-- | A value that was read, as Haskell shows it.
data Input = Input !Origin String
  deriving (Eq, Show)

-- | Where a value comes from.
data Origin
  = -- | The occurrence itself, or an earlier one that waited for its partners.
    AnEvent
  | -- | The state of this channel, as the message of this instant gave it.
    AState String !(Maybe Int)
  | -- | The memory of this type, as this firing wrote it.
    AMemory String !(Maybe Int)
  | AParam String !(Maybe Int)
  | ATime
  | -- | The generator with this number, from the start of the observation.
    AGenerator !Int
  deriving (Eq, Show)

-- | A value that it gave, as Haskell shows it.
data Output = Output !Sink String
  deriving (Eq, Show)

-- | Where a value goes.
data Sink
  = -- | A command of this type.
    ACommand String
  | -- | A user event of this type, with this number.
    AnEmission String !Int
  | IntoMemory String
  | IntoParam String
  | ADone
  | AFeedback
  | ACall
  deriving (Eq, Show)

-- ---------------------------------------------------------------------------------------------
-- Following a run

-- | What was written and sent last, by which firing.
data Watch = Watch
  { firings :: !Int,
    instants :: !Int,
    generatorsRead :: !Int,
    emissions :: !Int,
    writers :: !(Map.Map (Maybe ScopeId, TypeRep) Int),
    emitters :: !(IntMap.IntMap Int),
    refreshers :: !(IntMap.IntMap Int),
    latestIn :: !(IntMap.IntMap Int),
    latestFeedback :: !(Maybe Int),
    -- | How the types that were met are shown, which is the same each time.
    typeTexts :: !(Map.Map TypeRep String)
  }

-- | The observation begins when so many user events have been sent.
watchFrom :: Int -> Watch
watchFrom sent = Watch 0 0 0 sent Map.empty IntMap.empty IntMap.empty IntMap.empty Nothing Map.empty

-- | What happened in order: an instant began, or a function fired and took these branches.
data Observed = AnInstant !What | AFiring !Firing [TakenBranch]

-- | The firings as records, and the watch after them.
follow :: Watch -> [Observed] -> (Watch, [Record])
follow watch = go watch []
  where
    -- Records newest first.
    go !w done observed = case observed of
      [] -> (w, reverse done)
      AnInstant what : rest -> go w {instants = instants w + 1, refreshers = refreshed w what} done rest
      AFiring firing branches : rest -> case recorded w firing branches of
        (w', found) -> go w' (found : done) rest
    refreshed w what = case what of
      Hear (Message channel _) -> IntMap.insert (channelNumber channel) (instants w) (refreshers w)
      TickNow -> refreshers w

-- | The firings of so many user events are known: many times what one instant delivers. A choice of ours, so that the map is bounded.
keptEmitters :: Int
keptEmitters = 4096

-- | Strict from firing to firing: what is suspended would be evaluated a moment later, at more cost.
recorded :: Watch -> Firing -> [TakenBranch] -> (Watch, Record)
recorded w firing branches = (w'' {firings = number + 1, latestIn = IntMap.insert scope number (latestIn w'')}, Record number (nameText (firingName firing)) scope reason inputs outputs branches)
  where
    number = firings w
    scope = firingScope firing
    now = instants w - 1
    reason = case firingCause firing of
      ByOccurrence (Sensed message) -> OfMessage now (tellMessage message)
      ByOccurrence Tick -> OfTick now
      ByOccurrence (Emitted event) -> OfEvent (eventSerial event) (IntMap.lookup (eventSerial event) (emitters w))
      ByStart -> OfStart
      ByInstant -> OfWait now
      ByTask s -> OfFiring (IntMap.lookup s (latestIn w))
      ByFeedback -> OfFiring (latestFeedback w)
      ByEnd -> OfEnd
    (w', inputs) = through input w (firingInputs firing)
    input v (InputValue source text) = case source of
      FromEvent -> (v, Input AnEvent text)
      FromState channel -> (v, Input (AState (channelName channel) (IntMap.lookup (channelNumber channel) (refreshers v))) text)
      FromMemory what -> typed v what (\u name -> (u, Input (AMemory name (Map.lookup (Just scope, what) (writers u))) text))
      FromParam what -> typed v what (\u name -> (u, Input (AParam name (Map.lookup (Nothing, what) (writers u))) text))
      FromTime -> (v, Input ATime text)
      FromGenerator -> (v {generatorsRead = generatorsRead v + 1}, Input (AGenerator (generatorsRead v)) text)
    (w'', outputs) = through output w' (listed (firingEffects firing))
    output v effect = case effect of
      Act action -> (v, commanded action)
      Arbitrated _ action -> (v, commanded action)
      Suppressed _ action -> (v, commanded action)
      Emit value text -> (v {emissions = emissions v + 1, emitters = IntMap.insert (emissions v) number (snd (IntMap.split (emissions v - keptEmitters) (emitters v)))}, Output (AnEmission (show (dynTypeRep value)) (emissions v)) text)
      Remember what (Kept _ text) -> typed v what (\u name -> (u {writers = Map.insert (Just scope, what) number (writers u)}, Output (IntoMemory name) text))
      Share what (Kept _ text) -> typed v what (\u name -> (u {writers = Map.insert (Nothing, what) number (writers u)}, Output (IntoParam name) text))
      End _ text -> (v, Output ADone text)
      Feed _ text -> (v {latestFeedback = Just number}, Output AFeedback text)
      StartCall _ -> (v, Output ACall "")
    commanded action@(Action channel _) = Output (ACommand (channelName channel)) (tellAction action)
    listed effects = case effects of
      Nothing' -> []
      Then (End value _) rest | isMark value -> listed rest
      Then effect rest -> effect : listed rest

-- | The state from left to right through a list.
through :: (state -> a -> (state, b)) -> state -> [a] -> (state, [b])
through step = go
  where
    go !s [] = (s, [])
    go !s (x : xs) = case step s x of
      (s', y) -> case go s' xs of
        (s'', ys) -> (s'', y : ys)

-- | With a type as it is shown.
typed :: Watch -> TypeRep -> (Watch -> String -> found) -> found
typed w what with = case Map.lookup what (typeTexts w) of
  Just known -> with w known
  Nothing -> let shown = showsPrec 11 what "" in with w {typeTexts = Map.insert what shown (typeTexts w)} shown
