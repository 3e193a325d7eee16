{-# LANGUAGE ExistentialQuantification #-}
{-# LANGUAGE FlexibleInstances #-}
{-# LANGUAGE ScopedTypeVariables #-}
{-# OPTIONS_GHC -Wno-orphans #-}

-- |
-- Module      : Support.Translated
-- Description : Programs and happenings of the model as those of the runtime.
--
-- A program of the model is translated into what the classes of the language make of the same program. Each firing is said
-- aloud (@Say "!name"@), so that firings and commands come as one list.
module Support.Translated
  ( translated,
    cues,
  )
where

import Control.Monad ((>=>))
import Data.Dynamic (fromDynamic)
import qualified Rosy.Arbitration as R
import qualified Rosy.Command as R
import qualified Rosy.Core as R
import qualified Rosy.Loop as R
import Rosy.Model hiding (tasks)
import qualified Rosy.Model as Model (Spec (tasks))
import qualified Rosy.Robot as R
import qualified Rosy.Sense as R
import qualified Rosy.Sensor as R
import qualified Rosy.Time as R
import qualified Rosy.Value as V
import Support.Rehearsal
import Support.Story (moving)
import System.Random (StdGen, mkStdGen, split)

-- | What happens at one time comes as one step, whose tick is last.
cues :: [(Int, Happening)] -> [Cue]
cues days = case days of
  [] -> []
  (_, Stop) : rest -> Stops : cues rest
  (_, Loss) : rest -> Breaks : cues rest
  (t, _) : _ ->
    let (messages, rest) = span (\(t', h) -> t' == t && h `notElem` [Tick, Stop, Loss]) days
        (tick, rest') = splitAt 1 rest
        -- Multiplied, as the simulator's clock is, so that the last digits are rounded.
        step = Steps (fromIntegral t * 0.001) (map (message . snd) messages)
     in case tick of
          [(t', Tick)] | t' == t -> step True : cues rest'
          _ -> step False : cues rest

-- ---------------------------------------------------------------------------------------------
-- Translation

-- | Two events and two memories of the program's own.
newtype E0 = E0 Value deriving (Show)

newtype E1 = E1 Value deriving (Show)

newtype M0 = M0 Value deriving (Show)

newtype M1 = M1 Value deriving (Show)

-- | A type that no task ends with, but for those that end with nothing else.
newtype Other = Other Value deriving (Show)

instance V.Value Value where
  display = showsPrec
  settle n v = length (show v) `seq` n
  initial _ = Just (Int 0)

instance V.Value E0 where
  display _ _ = id
  settle n (E0 v) = V.settle n v
  initial _ = Just (E0 (Int 0))

instance V.Value E1 where
  display _ _ = id
  settle n (E1 v) = V.settle n v
  initial _ = Just (E1 (Int 0))

instance V.Value M0 where
  display _ _ = id
  settle n (M0 v) = V.settle n v
  initial _ = Just (M0 (Int 0))

instance V.Value M1 where
  display _ _ = id
  settle n (M1 v) = V.settle n v
  initial _ = Just (M1 (Int 0))

instance V.Value Other where
  display _ _ = id
  settle n (Other v) = V.settle n v
  initial _ = Just (Other (Int 0))

instance V.Default M0

instance V.Default M1

instance R.Sensor E0

instance R.Sensor E1

instance R.Command E0

instance R.Command E1

message :: Happening -> R.Message
message h = case h of
  Happens "Bumper" (Int n) -> R.BumperMessage (R.Bumper (toEnum (n `div` 2)) (toEnum (n `mod` 2)))
  Happens "Button" (Int n) -> R.ButtonMessage (R.Button (toEnum (n `div` 2)) (toEnum (n `mod` 2)))
  Odometry v | R.Hear m <- moving (fromIntegral v) -> m
  _ -> error ("no message: " ++ show h)

-- | Which of a program's random generators this is.
numberOf :: StdGen -> Int
numberOf g = length (takeWhile (/= g) (map (fst . split) (iterate (snd . split) (mkStdGen 1))))

-- | An input together with what its values are in the model.
data AnInput = forall a. AnInput (R.Sense a) (a -> Value)

inputOf :: Input -> AnInput
inputOf i = case i of
  Event "Bumper" -> AnInput R.sensor (\(R.Bumper s st) -> Int (2 * fromEnum s + fromEnum st))
  Event "Button" -> AnInput R.sensor (\(R.Button s st) -> Int (2 * fromEnum s + fromEnum st))
  Event "E0" -> AnInput R.sensor (\(E0 v) -> v)
  Event "E1" -> AnInput R.sensor (\(E1 v) -> v)
  Event _ -> AnInput R.sensor (\() -> Tuple [])
  State -> AnInput R.sensor (\(R.Velocity v _) -> Int (round v))
  Memory "M0" -> AnInput R.sensor (\(R.Memory (M0 v)) -> v)
  Memory _ -> AnInput R.sensor (\(R.Memory (M1 v)) -> v)
  Param "M0" -> AnInput R.sensor (\(R.Param (M0 v)) -> v)
  Param _ -> AnInput R.sensor (\(R.Param (M1 v)) -> v)
  Clock -> AnInput R.sensor (\(R.Clock h m s ms) -> Tuple (map Int [h, m, s, ms]))
  Time -> AnInput R.sensor (\(R.Seconds s) -> Int (round (s * 1000)))
  Chance -> AnInput R.sensor (Int . numberOf)
  Either a (Event "()") -> case inputOf a of
    -- The instance of Maybe, rebuilt for an input that is not known by its type.
    AnInput sa fa -> AnInput (R.oneOf sa R.tick) (either (InLeft . fa) (const (InRight (Tuple []))))
  Either a b -> case (inputOf a, inputOf b) of
    (AnInput sa fa, AnInput sb fb) -> AnInput (R.oneOf sa sb) (either (InLeft . fa) (InRight . fb))
  All members -> case foldr join (AnInput R.nothing (const (Tuple []))) (flat members) of
    AnInput s f -> AnInput s f
  where
    flat = concatMap (\m -> case m of All inner -> flat inner; _ -> [m])
    join m (AnInput s f) = case inputOf m of
      AnInput sm fm -> AnInput (R.both sm s) (\(x, rest) -> case f rest of Tuple vs -> Tuple (fm x : vs); v -> Tuple [fm x, v])

functionOf :: Function -> R.Function
functionOf f = case inputOf (input f) of
  AnInput s toValue -> R.Function (R.functionName (name f)) s (said' . effectsOf . body f . toValue)
  where
    said' = giving (R.Say ('!' : name f))

giving :: R.Command c => c -> R.Effects -> R.Effects
giving c = case R.command of
  R.Plain give -> give c
  R.Needing _ _ -> error "a plain command needs nothing"

effectsOf :: [Output] -> R.Effects
effectsOf = foldr one R.Nothing'
  where
    one out = case out of
      Command v -> giving (R.Say (show v))
      Drive v -> giving (R.Velocity (fromIntegral v) 0)
      Light v -> giving (R.Led1 (toEnum v))
      Arbitrated own o -> (R.throughArbiters (map arbiterOf own) (effectsOf [o]) `before`)
      Write "M0" v -> giving (R.Memory (M0 v))
      Write _ v -> giving (R.Memory (M1 v))
      Share "M0" v -> giving (R.Param (M0 v))
      Share _ v -> giving (R.Param (M1 v))
      Emit "E0" v -> giving (E0 v)
      Emit _ v -> giving (E1 v)
      Done "Value" v -> giving (R.Done v)
      Done _ v -> giving (R.Done (Other v))
      Fail -> const (errorWithoutStackTrace "it fails")
      Feedback v -> giving (R.Feedback v)
      Call c -> giving (R.Call (callingOf c))

    before effects rest = case effects of
      R.Nothing' -> rest
      R.Then effect more -> R.Then effect (before more rest)

arbiterOf :: Arbiter -> R.Arbiter
arbiterOf (Arbiter n side) = R.Arbiter Nothing [n] $ case side of
  Leads t -> R.Leads (fromIntegral t / 1000)
  Follows -> R.Follows

callingOf :: Calling -> R.Calling
callingOf c =
  R.Calling
    { R.callArbiters = map arbiterOf (arbiters c),
      R.callProgram = translated (called c),
      R.callCancel = cancelling <$> cancel c,
      R.callFeedback = fromDynamic >=> fmap functionOf . feedback c,
      R.callResponse = functionOf . response c
    }
  where
    -- In the model any output cancels; in the language it is a Done of the canceller's.
    cancelling f = functionOf f {body = \v -> [if isFail out then out else Done "Value" v | out <- take 1 (body f v)]}
    isFail Fail = True
    isFail _ = False

translated :: Program -> R.Program Value
translated p = case p of
  Return v -> R.Return v
  Task spec k ->
    R.RunTask
      R.Spec
        { R.specStart = functionOf <$> start spec,
          R.specFunctions = map functionOf (functions spec),
          R.specTasks = map callingOf (Model.tasks spec),
          R.specStopped = functionOf <$> stopped spec,
          R.specEnd = if ends spec == "Value" then fromDynamic else fmap (\(Other v) -> v) . fromDynamic,
          R.specType = ends spec
        }
      (translated . k)
  Once f rest -> R.Once (functionOf f) (translated rest)
  Wait t rest -> R.WaitFor (fromIntegral t / 1000) (translated rest)
  Both a b k -> R.Both (translated a) (translated b) (\(x, y) -> translated (k (Tuple [x, y])))
  First a b k -> R.First (translated a) (translated b) (translated . k . either InLeft InRight)
