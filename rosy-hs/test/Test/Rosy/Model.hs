{-# LANGUAGE ExistentialQuantification #-}
{-# LANGUAGE FlexibleInstances #-}
{-# LANGUAGE ScopedTypeVariables #-}
{-# OPTIONS_GHC -Wno-orphans #-}

-- |
-- Module      : Test.Rosy.Model
-- Description : The runtime means what the model says, on generated programs and happenings.
--
-- A program of the model is translated into what the classes of the language make of the same program; both are given the same
-- happenings, and must say the same at the same times.
module Test.Rosy.Model (tests) where

import Control.Monad ((>=>))
import Data.Dynamic (fromDynamic)
import qualified Rosy.Command as R
import qualified Rosy.Core as R
import Rosy.Loop (What (..))
import Rosy.Model
import qualified Rosy.Robot as R
import qualified Rosy.Sense as R
import qualified Rosy.Sensor as R
import qualified Rosy.Value as V
import Support.Story
import System.Random (StdGen, mkStdGen, split)
import Test.QuickCheck hiding (Function, function, label)
import Test.Tasty (TestTree, adjustOption, localOption, testGroup)
import Test.Tasty.QuickCheck (QuickCheckTests (..), testProperty)

tests :: TestTree
tests =
  adjustOption (max (QuickCheckTests 500)) . testGroup "Model: the runtime means what the model says" $
    [ testProperty "for controllers" (forAllShrink controllers (const []) (\(Shown _ p) -> agree p)),
      testProperty "for tasks" (forAllShrink tasks (const []) (\(Shown _ p) -> agree p)),
      localOption (QuickCheckTests 10) $
        testProperty "for functions that feed each other for ever" (\(Days days) -> agreeOn endless days)
    ]
  where
    agree p (Days days) = agreeOn p days

-- | Both say the same.
agreeOn :: Program -> [(Int, Happening)] -> Property
agreeOn p days = cover 40 (length said > 2) "programs that say something" (runtime p days === said)
  where
    said = meaning p days

-- | What the runtime says of the program.
runtime :: Program -> [(Int, Happening)] -> [(Int, Said)]
runtime p days = concatMap sayings (hearProgram (translated p) [(fromIntegral t / 1000, what h) | (t, h) <- days])
  where
    sayings h = [(round (heardAt h * 1000), s) | s <- interleaved h]
    interleaved h = map read' (heardCommands h) ++ [Over | heardEnd h == Just "Finished"]
    -- Firings and commands come as one list: the translation says each firing aloud.
    read' line = case read line of
      R.Say text -> case text of
        '!' : who -> Fired who
        _ -> Commanded (read text)

-- ---------------------------------------------------------------------------------------------
-- Translation

-- | Two events and two memories of the program's own.
newtype E0 = E0 Value deriving (Show)

newtype E1 = E1 Value deriving (Show)

newtype M0 = M0 Value deriving (Show)

newtype M1 = M1 Value deriving (Show)

instance V.Value Value where
  display = showsPrec
  settle n v = length (show v) `seq` n
  initial = Int 0

instance V.Value E0 where
  display _ _ = id
  settle n (E0 v) = V.settle n v
  initial = E0 (Int 0)

instance V.Value E1 where
  display _ _ = id
  settle n (E1 v) = V.settle n v
  initial = E1 (Int 0)

instance V.Value M0 where
  display _ _ = id
  settle n (M0 v) = V.settle n v
  initial = M0 (Int 0)

instance V.Value M1 where
  display _ _ = id
  settle n (M1 v) = V.settle n v
  initial = M1 (Int 0)

instance V.Default M0

instance V.Default M1

instance R.Sensor E0

instance R.Sensor E1

instance R.Command E0

instance R.Command E1

what :: Happening -> What
what h = case h of
  Happens "Bumper" (Int n) -> Hear (R.BumperMessage (R.Bumper (toEnum (n `div` 2)) (toEnum (n `mod` 2))))
  Happens _ (Int n) -> Hear (R.ButtonMessage (R.Button (toEnum (n `div` 2)) (toEnum (n `mod` 2))))
  Happens _ _ -> TickNow
  Odometry v -> moving (fromIntegral v)
  Tick -> TickNow

-- | Which of a program's random generators this is.
numberOf :: StdGen -> Int
numberOf g = length (takeWhile (/= g) (map (fst . split) (iterate (snd . split) (mkStdGen 1))))

-- | An input together with what its values are in the model.
data AnInput = forall a. AnInput (R.Sense a) (a -> Value)

inputOf :: Input -> AnInput
inputOf i = case i of
  Event "Bumper" -> AnInput R.sense (\(R.Bumper s st) -> Int (2 * fromEnum s + fromEnum st))
  Event "Button" -> AnInput R.sense (\(R.Button s st) -> Int (2 * fromEnum s + fromEnum st))
  Event "E0" -> AnInput R.sense (\(E0 v) -> v)
  Event "E1" -> AnInput R.sense (\(E1 v) -> v)
  Event _ -> AnInput R.sense (\() -> Tuple [])
  State -> AnInput R.sense (\(R.Velocity v _) -> Int (round v))
  Memory "M0" -> AnInput R.sense (\(R.Memory (M0 v)) -> v)
  Memory _ -> AnInput R.sense (\(R.Memory (M1 v)) -> v)
  Param "M0" -> AnInput R.sense (\(R.Param (M0 v)) -> v)
  Param _ -> AnInput R.sense (\(R.Param (M1 v)) -> v)
  Time -> AnInput R.sense (\(R.Seconds s) -> Int (round (s * 1000)))
  Chance -> AnInput R.sense (Int . numberOf)
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
      Write "M0" v -> giving (R.Memory (M0 v))
      Write _ v -> giving (R.Memory (M1 v))
      Share "M0" v -> giving (R.Param (M0 v))
      Share _ v -> giving (R.Param (M1 v))
      Emit "E0" v -> giving (E0 v)
      Emit _ v -> giving (E1 v)
      Done v -> giving (R.Done v)
      Feedback v -> giving (R.Feedback v)
      Call c ->
        giving . R.Call $
          R.Calling
            { R.callProgram = translated (called c),
              R.callCancel = cancelling <$> cancel c,
              R.callFeedback = fromDynamic >=> fmap functionOf . feedback c,
              R.callResponse = functionOf . response c
            }
    -- In the model any output cancels; in the language it is a Done of the canceller's.
    cancelling f = functionOf f {body = \v -> [Done v | not (null (body f v))]}

translated :: Program -> R.Program Value
translated p = case p of
  Return v -> R.Return v
  Task spec k ->
    R.RunTask
      R.Spec
        { R.specStart = functionOf <$> start spec,
          R.specFunctions = map functionOf (functions spec),
          R.specStopped = functionOf <$> stopped spec,
          R.specEnd = fromDynamic,
          R.specType = "Value"
        }
      (translated . k)
  Once f rest -> R.Once (functionOf f) (translated rest)
  Wait t rest -> R.WaitFor (fromIntegral t / 1000) (translated rest)
  Both a b k -> R.Both (translated a) (translated b) (\(x, y) -> translated (k (Tuple [x, y])))
  First a b k -> R.First (translated a) (translated b) (translated . k . either InLeft InRight)

-- ---------------------------------------------------------------------------------------------
-- Generated programs

-- | A program with a text, for the report of a failure.
data Shown = Shown String Program

instance Show Shown where
  show (Shown text _) = text

-- | Happenings in order of time.
newtype Days = Days [(Int, Happening)]
  deriving (Show)

instance Arbitrary Days where
  arbitrary = do
    n <- choose (0, 14)
    gaps <- vectorOf n (elements [0, 20, 20, 40])
    happenings <- vectorOf n happening
    pure (Days (zip (scanl1 (+) gaps) happenings))
    where
      happening =
        frequency
          [ (3, Happens "Bumper" . Int <$> choose (0, 5)),
            (2, Happens "Button" . Int <$> choose (0, 5)),
            (3, Odometry <$> choose (-3, 3)),
            (3, pure Tick)
          ]
  shrink (Days days) = Days <$> shrinkList (const []) days

anInput :: Int -> Gen Input
anInput depth =
  frequency $
    [ (4, Event <$> elements ["Bumper", "Button", "E0", "E0", "E1", "()"]),
      (2, pure State),
      (2, Memory <$> elements ["M0", "M1"]),
      (1, Param <$> elements ["M0", "M1"]),
      (2, elements [Time, Chance, All [Chance, Chance]])
    ]
      ++ [ (3, choose (0, 3) >>= fmap All . flip vectorOf (anInput (depth - 1))) | depth > 0
         ]
      ++ [(2, Either <$> anInput (depth - 1) <*> anInput (depth - 1)) | depth > 0]

-- | What a function gives: one of a few lists of outputs, chosen by its input. 'Nothing' stands for the input itself.
type Body = [[Template]]

data Template
  = TCommand Int
  | TWrite String
  | TShare String
  | TEmit String
  | TDone
  | TFeedback
  | TCall ATask

instance Show Template where
  showsPrec d t = case t of
    TCommand n -> showString "command " . shows n
    TWrite m -> showString "write " . showString m
    TShare m -> showString "share " . showString m
    TEmit e -> showString "emit " . showString e
    TDone -> showString "done"
    TFeedback -> showString "feedback"
    TCall task -> showString "call " . showsPrec d task

bodyOf :: Body -> Value -> [Output]
bodyOf choices v = concatMap out (choices !! (weight v `mod` length choices))
  where
    small = Int (weight v `mod` 7)
    out t = case t of
      TCommand n -> [Command (Int (n + weight v))]
      TWrite m -> [Write m small]
      TShare m -> [Share m small]
      TEmit e -> [Emit e small]
      TDone -> [Done small]
      TFeedback -> [Feedback small]
      TCall task -> [Call (callOf task)]

-- | A number that depends on every part.
weight :: Value -> Int
weight v = case v of
  Int n -> abs n
  InLeft w -> 3 + weight w
  InRight w -> 5 + weight w
  Tuple vs -> sum (zipWith (*) [1 ..] (map weight vs))

data AFunction = AFunction String Input Body
  deriving (Show)

fromA :: AFunction -> Function
fromA (AFunction n i b) = Function n i (bodyOf b)

-- | A program as it was generated. What follows a value is chosen without looking at it, except for being told.
data ATask
  = AReturn
  | ATask (Maybe AFunction) [AFunction] (Maybe AFunction) ATask
  | AOnce AFunction ATask
  | AWait Int ATask
  | ABoth ATask ATask ATask
  | AFirst ATask ATask ATask
  deriving (Show)

programOf :: Value -> ATask -> Program
programOf v a = case a of
  AReturn -> Return v
  ATask s fs c k -> Task (Spec (fromA <$> s) (map fromA fs) (fromA <$> c)) (`programOf` k)
  AOnce f k -> Once (fromA f) (programOf v k)
  AWait t k -> Wait t (programOf v k)
  ABoth x y k -> Both (programOf v x) (programOf v y) (`programOf` k)
  AFirst x y k -> First (programOf v x) (programOf v y) (`programOf` k)

-- | A call that is cancelled by button 0, tells its feedback and its end.
callOf :: ATask -> Calling
callOf task =
  Calling
    { called = programOf (Int 0) task,
      cancel = Just (Function "cancel" (Event "Button") (\v -> [Done v | v == Int 0])),
      feedback = \v -> if even (weight v) then Just (Function "feedback" (All []) (const [Command v])) else Nothing,
      response = \v -> Function "end" (Memory "M0") (\m -> [Command (Tuple [v, m])])
    }

-- | Which outputs a function may have: whether it may emit events, in a task or not, and how deep calls may go. A called task is silent
-- and calls no other: an event that starts a task that emits the event would multiply beyond counting.
aFunction :: Bool -> Bool -> Int -> String -> Gen AFunction
aFunction speaks inTask depth label = do
  i <- anInput 2
  n <- choose (1, 3)
  choices <- vectorOf n (choose (0, 3) >>= flip vectorOf (template (if speaks then emits i else [])))
  pure (AFunction label i choices)
  where
    -- Events that make events would multiply beyond counting in 64 rounds; 'endless' is the test of those.
    emits i
      | i `takes` "E1" = []
      | i `takes` "E0" = ["E1"]
      | otherwise = ["E0", "E1"]
    template events =
      frequency $
        [ (4, TCommand <$> choose (0, 100)),
          (2, TWrite <$> elements ["M0", "M1"]),
          (1, TShare <$> elements ["M0", "M1"])
        ]
          ++ [(2, TEmit <$> elements events) | not (null events)]
          ++ [(1, pure TDone) | inTask]
          ++ [(1, pure TFeedback) | inTask]
          ++ [(1, TCall <$> aTask False (depth - 1)) | depth > 0]

-- | Whether an input takes an event.
takes :: Input -> Type -> Bool
takes i t = case i of
  Event t' -> t == t'
  All members -> any (`takes` t) members
  Either a b -> takes a t || takes b t
  _ -> False

controllers :: Gen Shown
controllers = do
  n <- choose (1, 4)
  fs <- mapM (aFunction True False 0 . ("f" ++) . show) [1 .. n :: Int]
  let a = ATask Nothing fs Nothing AReturn
  pure (Shown (show a) (programOf (Int 0) a))

tasks :: Gen Shown
tasks = do
  a <- aTask True 3
  pure (Shown (show a) (programOf (Int 0) a))

aTask :: Bool -> Int -> Gen ATask
aTask speaks depth
  | depth <= 0 = frequency [(1, pure AReturn), (2, aLeaf), (1, AWait <$> elements [0, 20, 50] <*> pure AReturn)]
  | otherwise =
    frequency
      [ (5, aLeaf),
        (1, AOnce <$> aFunction speaks False 0 "once" <*> aTask speaks (depth - 1)),
        (1, AWait <$> elements [0, 20, 50] <*> aTask speaks (depth - 1)),
        (2, ABoth <$> aTask speaks (depth - 1) <*> aTask speaks (depth - 1) <*> aTask speaks (depth - 1)),
        (2, AFirst <$> aTask speaks (depth - 1) <*> aTask speaks (depth - 1) <*> aTask speaks (depth - 1))
      ]
  where
    aLeaf = do
      s <- frequency [(1, pure Nothing), (2, Just <$> aFunction speaks True 0 "start")]
      n <- choose (0, 3)
      fs <- mapM (aFunction speaks True (min 1 (depth - 1)) . ("f" ++) . show) [1 .. n :: Int]
      c <- frequency [(1, pure Nothing), (2, Just <$> aFunction speaks False 0 "stopped")]
      ATask s fs c <$> aTask speaks (depth - 1)

-- | Two functions that feed each other, and one that listens.
endless :: Program
endless = Task (Spec Nothing [ping, pong, listener] Nothing) Return
  where
    ping = Function "ping" (Either (Event "Bumper") (Event "E0")) (\v -> [Emit "E1" (Int (weight v `mod` 5))])
    pong = Function "pong" (Event "E1") (\v -> [Emit "E0" v, Write "M0" v])
    listener = Function "listener" (All [Event "Button", Memory "M0"]) (\v -> [Command v])
