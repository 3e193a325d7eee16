{-# LANGUAGE BangPatterns #-}
{-# LANGUAGE ScopedTypeVariables #-}
{-# LANGUAGE UnboxedTuples #-}

-- |
-- Module      : Rosy.Sense
-- Description : Making inputs and putting them together: both, either, either as it comes.
--
-- The combinators behind the instances of "Rosy.Sensor". Their meaning over lists of occurrences is in "Rosy.Model".
module Rosy.Sense
  ( -- * Making one
    event,
    tick,
    sensedEvent,
    sensedState,
    sample,
    chance,
    never,
    nothing,

    -- * Putting together
    both,
    oneOf,
    convert,
  )
where

import Data.Bits ((.&.), (.|.))
import qualified Data.IntMap.Strict as IntMap
import Rosy.Channel (Channel (..), Field)
import Rosy.Core
import Rosy.Value (Value, shown)
import System.Random (StdGen, split)

telling :: Value a => Source -> a -> [InputValue] -> [InputValue]
telling source x rest = InputValue source (shown x) : rest

-- | An input that has a value when the occurrence says so. It keeps the newest value that was not used.
event :: Value a => Interest -> (Occurrence -> Maybe a) -> Sense a
event kinds pick =
  Sense
    (telling FromEvent)
    ( Triggered
        Trigger
          { interest = kinds,
            mayNeed = 0,
            turns = 1,
            unused = Nothing,
            offer = \turn occurrence old ->
              if turn /= 0
                then old
                else case pick occurrence of
                  Just !x -> Just x
                  Nothing -> old,
            ready = fmap given,
            used = const Nothing,
            passing =
              Just
                ( \occurrence -> case pick occurrence of
                    Just !x -> Arrival (given x) NoMore
                    Nothing -> NoMore
                )
          }
    )

-- | The tick of the default rate, 10 Hz.
tick :: Sense ()
tick = event (interestIn Tick) ticked
  where
    ticked Tick = Just ()
    ticked _ = Nothing

-- | A value that is known already.
given :: a -> Reading a
given x = Reading 0 0 look
  where
    look _ = (# x #)

-- | The messages of a channel whose fields are a value.
sensedEvent :: Value a => Channel -> ([Field] -> Maybe a) -> Sense a
sensedEvent channel view = event (channelInterest channel) fromSensed
  where
    fromSensed (Sensed (Message c fields)) | c == channel = view fields
    fromSensed _ = Nothing

-- | The current value of a channel, or of a part of it.
sensedState :: Value a => Channel -> ([Field] -> Maybe a) -> Sense a
sensedState channel view = Sense (telling (FromState channel)) (Level (Reading (channelInterest channel) 0 look))
  where
    look env = case IntMap.lookup (channelNumber channel) (envStates env) of
      Just fields | Just x <- view fields -> (# x #)
      _ -> (# unarrived #)
    -- The loop reads a state only after it has arrived (rule R5), and links let no message in whose fields do not fit.
    unarrived = errorWithoutStackTrace "a state was read before it arrived"

-- | Something that can be read at any time.
sample :: Value a => Source -> (Env -> (# a #)) -> Sense a
sample source look = Sense (telling source) (Level (Reading 0 0 look))

-- | A random generator of one's own, new at each reading.
chance :: Sense StdGen
chance = Sense (const (InputValue FromGenerator "_" :)) (Level (Reading 0 1 (\env -> (# fst (split (envGen env)) #))))

-- | An input that never has a value.
never :: Sense a
never = Sense (const id) idle

-- | No input at all: always there, says nothing.
nothing :: Sense ()
nothing = Sense (const id) (Level (given ()))

-- | An input that is another one in different words.
convert :: (a -> b) -> (b -> a) -> Sense a -> Sense b
convert to from (Sense tell shape) = Sense (tell . from) (mapShape to shape)

mapShape :: (a -> b) -> Shape a -> Shape b
mapShape f (Triggered t) = Triggered (mapTrigger (mapReading f) t)
mapShape f (Level reading) = Level (mapReading f reading)

mapReading :: (a -> b) -> Reading a -> Reading b
mapReading f (Reading need n look) = Reading need n (\env -> case look env of (# x #) -> (# f x #))

mapTrigger :: (Reading a -> Reading b) -> Trigger s a -> Trigger s b
mapTrigger f t = t {ready = fmap f . ready t, passing = fmap (mapArrivals f .) (passing t)}

mapArrivals :: (Reading a -> Reading b) -> Arrivals a -> Arrivals b
mapArrivals _ NoMore = NoMore
mapArrivals f (Arrival reading more) = Arrival (f reading) (mapArrivals f more)

-- | The first, then the second.
inTurn :: Arrivals a -> Arrivals a -> Arrivals a
inTurn NoMore others = others
inTurn (Arrival reading more) others = Arrival reading (inTurn more others)

-- | All of these: has a value when both have one.
both :: Sense a -> Sense b -> Sense (a, b)
both (Sense tellA a) (Sense tellB b) = Sense (\(x, y) -> tellA x . tellB y) (bothShapes a b)

bothShapes :: Shape a -> Shape b -> Shape (a, b)
bothShapes (Triggered a) (Triggered b) =
  Triggered
    Trigger
      { interest = interest a .|. interest b,
        mayNeed = mayNeed a .|. mayNeed b,
        turns = max (turns a) (turns b),
        unused = Two (unused a) (unused b),
        offer = \turn occurrence (Two s t) -> Two (offer a turn occurrence s) (offer b turn occurrence t),
        ready = \(Two s t) -> case ready a s of
          Nothing -> Nothing
          Just x -> bothReadings x <$> ready b t,
        used = \(Two s t) -> Two (used a s) (used b t),
        passing = Nothing
      }
bothShapes (Triggered a) (Level y) = withLevel y (`bothReadings` y) a
bothShapes (Level x) (Triggered b) = withLevel x (bothReadings x) b
bothShapes (Level x) (Level y) = Level (bothReadings x y)

-- | An event together with something that is read when it happens.
withLevel :: Reading level -> (Reading a -> Reading b) -> Trigger s a -> Shape b
withLevel level join t = Triggered (mapTrigger join t) {mayNeed = mayNeed t .|. needs level}

-- | Read both; the second has generators that the first has not used.
bothReadings :: Reading a -> Reading b -> Reading (a, b)
bothReadings (Reading needA n lookA) (Reading needB m lookB)
  | n == 0 || m == 0 = reading id
  | otherwise = reading (withoutGenerators n)
  where
    reading later = Reading (needA .|. needB) (n + m) (\env -> case lookA env of (# x #) -> case lookB (later env) of (# y #) -> (# (x, y) #))
    {-# INLINE reading #-}

-- | Strict in both states, so that nothing piles up in an input that waits for its partner.
data Two s t = Two !s !t

-- | Either of these, as it comes: a new value of one side takes the place of an unused one.
-- When one occurrence gives both sides a value, the left one has its turn first.
oneOf :: forall a b. Sense a -> Sense b -> Sense (Either a b)
oneOf (Sense tellA shapeA) (Sense tellB shapeB) = Sense (either tellA tellB) (join (triggering shapeA) (triggering shapeB))
  where
    join (Triggered a) (Triggered b) =
      Triggered
        Trigger
          { interest = interest a .|. interest b,
            mayNeed = mayNeed a .|. mayNeed b,
            turns = turns a + turns b,
            unused = Slot (unused a) (unused b) Nothing,
            offer = \turn occurrence slot@(Slot s t _) ->
              if turn < turns a
                then
                  let s' = offer a turn occurrence s
                   in case ready a s' of
                        Just reading -> Slot (used a s') t (Just (mapReading Left reading))
                        Nothing -> slot {slotLeft = s'}
                else
                  let t' = offer b (turn - turns a) occurrence t
                   in case ready b t' of
                        Just reading -> Slot s (used b t') (Just (mapReading Right reading))
                        Nothing -> slot {slotRight = t'},
            ready = slotValue,
            used = \slot -> slot {slotValue = Nothing},
            passing = (\f g o -> inTurn (mapArrivals (mapReading Left) (f o)) (mapArrivals (mapReading Right) (g o))) <$> passing a <*> passing b
          }
    join _ _ = idle -- 'triggering' gives nothing else

data Slot s t r = Slot {slotLeft :: !s, slotRight :: !t, slotValue :: !(Maybe r)}

-- | Inside an 'Either' a state triggers like an event (rule R4); a sample still never causes anything.
triggering :: Shape a -> Shape a
triggering shape@(Triggered _) = shape
triggering (Level reading)
  | needs reading == 0 = idle
  | otherwise =
    Triggered
      Trigger
        { interest = needs reading,
          mayNeed = needs reading,
          turns = 1,
          unused = False,
          offer = \turn occurrence old -> old || (turn == 0 && refreshes occurrence),
          ready = \new -> if new then Just reading else Nothing,
          used = const False,
          passing = Just (\occurrence -> if refreshes occurrence then Arrival reading NoMore else NoMore)
        }
  where
    refreshes occurrence = interestIn occurrence .&. needs reading /= 0

-- | Never has a value.
idle :: Shape a
idle =
  Triggered
    Trigger
      { interest = 0,
        mayNeed = 0,
        turns = 1,
        unused = (),
        offer = \_ _ s -> s,
        ready = const Nothing,
        used = id,
        passing = Just (const NoMore)
      }
