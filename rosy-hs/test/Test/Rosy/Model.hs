{-# LANGUAGE ExistentialQuantification #-}
{-# LANGUAGE FlexibleInstances #-}
{-# LANGUAGE ScopedTypeVariables #-}
{-# OPTIONS_GHC -Wno-orphans #-}

-- |
-- Module      : Test.Rosy.Model
-- Description : The runtime means what the model says, on generated programs and happenings.
--
-- A program of the model is translated into what the classes of the language make of the same program; both are given the same
-- happenings, and must say the same at the same times. What the program says is read from the lines that a link would carry, after
-- "Rosy.Run" has driven it: failures, zero velocity at the end and whom a problem names are part of it.
module Test.Rosy.Model (tests) where

import Control.Monad ((>=>))
import Data.Dynamic (fromDynamic)
import Data.List (isPrefixOf)
import qualified Rosy.Command as R
import qualified Rosy.Core as R
import qualified Rosy.Loop as R
import Rosy.Model
import qualified Rosy.Robot as R
import qualified Rosy.Sense as R
import qualified Rosy.Sensor as R
import qualified Rosy.Value as V
import Support.Rehearsal
import Support.Story (moving)
import System.Random (StdGen, mkStdGen, split)
import Test.QuickCheck hiding (Function, function, label)
import Test.Tasty (TestTree, adjustOption, localOption, testGroup)
import Test.Tasty.QuickCheck (QuickCheckTests (..), testProperty)

tests :: TestTree
tests =
  adjustOption (max (QuickCheckTests 500)) . testGroup "Model: the runtime means what the model says" $
    [ testProperty "for controllers" (forAllShrink controllers (const []) (\(Shown _ p) -> agree p)),
      testProperty "for tasks" (forAllShrink tasks (const []) (\(Shown _ p) -> agree p)),
      testProperty "for tasks that fail, are stopped or lose their robot" (forAllShrink fragile (const []) (\(Shown _ p) (Days days) -> ending days (agreeOn p))),
      localOption (QuickCheckTests 10) $
        testProperty "for functions that feed each other for ever" (\(Days days) -> agreeOn endless (take 6 days))
    ]
  where
    agree p (Days days) = agreeOn p days
    -- Two in three of these runs are ended from outside, wherever they are.
    ending days run = forAll (choose (0, length days)) $ \at ->
      forAll (elements [[], [Stop], [Stop], [Loss]]) $ \last' ->
        let (before, after) = splitAt at days in run (before ++ [(if null before then 0 else fst (last before), h) | h <- last'] ++ after)

-- | Both say the same.
agreeOn :: Program -> [(Int, Happening)] -> Property
agreeOn p days =
  cover 40 (length said > 2) "programs that say something" . classify (or [True | (_, Fired "stopped") <- said]) "with a clean-up" . tabulate "ends" [takeWhile (/= ' ') (show e) | (_, Over e) <- said] $
    ioProperty (counterexample "the runtime, then the model:" . (=== said) <$> runtime p days)
  where
    said = meaning p days

-- | What the runtime says of the program.
runtime :: Program -> [(Int, Happening)] -> IO [(Int, Said)]
runtime p days = concatMap sayings <$> rehearse (cues days) (translated p)
  where
    sayings h = [(round (heardAt h * 1000), s) | s <- map read' (heardCommands h) ++ maybe [] ended (heardEnd h)]
    -- Firings and commands come as one list: the translation says each firing aloud.
    read' line
      | "Velocity" `isPrefixOf` line = Halt
      | otherwise = case read line of
        R.Say ('!' : who) -> Fired who
        R.Say text -> Commanded (read text)
    ended e = case e of
      Broken -> [Over Lost]
      End "done" Nothing Nothing -> [Over Finished]
      End "stopped" Nothing Nothing -> [Over Stopped]
      End "error" (Just "wrong-done") (Just who) -> [Over (EndedWrongly who)]
      End "error" (Just "call-in-once") (Just who) -> [Over (CalledInOnce who)]
      End "error" (Just "exception") (Just who) -> [Over (Failed who)]
      other -> error (show other)

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

instance V.Value Other where
  display _ _ = id
  settle n (Other v) = V.settle n v
  initial = Other (Int 0)

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
  Clock -> AnInput R.sense (\(R.Clock h m s ms) -> Tuple (map Int [h, m, s, ms]))
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
      Done "Value" v -> giving (R.Done v)
      Done _ v -> giving (R.Done (Other v))
      Fail -> const (errorWithoutStackTrace "it fails")
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
          R.specStopped = functionOf <$> stopped spec,
          R.specEnd = if ends spec == "Value" then fromDynamic else fmap (\(Other v) -> v) . fromDynamic,
          R.specType = ends spec
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
    n <- choose (0, 24)
    from <- oneof [pure 0, choose (0, day), pure (day - 50), (since1970 +) <$> choose (0, day)]
    gaps <- vectorOf n (elements [0, 20, 20, 40, 7])
    happenings <- vectorOf n happening
    pure (Days (zip (map (from +) (scanl1 (+) gaps)) happenings))
    where
      happening =
        frequency
          [ (3, Happens "Bumper" . Int <$> choose (0, 5)),
            (2, Happens "Button" . Int <$> choose (0, 5)),
            (3, Odometry <$> choose (-3, 3)),
            (3, pure Tick)
          ]
      -- Milliseconds. A robot's clock counts from 1970.
      day = 24 * 3600 * 1000
      since1970 = 1700000000123
  shrink (Days days) = Days <$> shrinkList (const []) days

anInput :: Int -> Gen Input
anInput depth =
  frequency $
    [ (4, Event <$> elements ["Bumper", "Button", "E0", "E0", "E1", "()"]),
      (2, pure State),
      (2, Memory <$> elements ["M0", "M1"]),
      (1, Param <$> elements ["M0", "M1"]),
      (2, elements [Time, Clock, Chance, All [Chance, Chance]])
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
  | TDone Type
  | TFail
  | TFeedback
  | TCall ATask

instance Show Template where
  showsPrec d t = case t of
    TCommand n -> showString "command " . shows n
    TWrite m -> showString "write " . showString m
    TShare m -> showString "share " . showString m
    TEmit e -> showString "emit " . showString e
    TDone t' -> showString "done " . showString t'
    TFail -> showString "fail"
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
      TDone t' -> [Done t' small]
      TFail -> [Fail]
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
  | ATask Type (Maybe AFunction) [AFunction] (Maybe AFunction) ATask
  | AOnce AFunction ATask
  | AWait Int ATask
  | ABoth ATask ATask ATask
  | AFirst ATask ATask ATask
  deriving (Show)

programOf :: Value -> ATask -> Program
programOf v a = case a of
  AReturn -> Return v
  ATask t s fs c k -> Task (Spec t (fromA <$> s) (map fromA fs) (fromA <$> c)) (`programOf` k)
  AOnce f k -> Once (fromA f) (programOf v k)
  AWait t k -> Wait t (programOf v k)
  ABoth x y k -> Both (programOf v x) (programOf v y) (`programOf` k)
  AFirst x y k -> First (programOf v x) (programOf v y) (`programOf` k)

-- | A call that is cancelled by button 0, tells its feedback and its end.
callOf :: ATask -> Calling
callOf task =
  Calling
    { called = programOf (Int 0) task,
      cancel = Just (Function "cancel" (Event "Button") (\v -> [Done "Value" v | v == Int 0])),
      feedback = \v -> if even (weight v) then Just (Function "feedback" (All []) (const [Command v])) else Nothing,
      response = \v -> Function "end" (Memory "M0") (\m -> [Command (Tuple [v, m])])
    }

-- | Which outputs a function may have: whether it may emit events, in a task or not, and how deep calls may go. A called task is silent
-- and calls no other: an event that starts a task that emits the event would multiply beyond counting.
aFunction :: Manners -> Bool -> Int -> String -> Gen AFunction
aFunction manners inTask depth label = do
  i <- anInput 2
  n <- choose (1, 3)
  choices <- vectorOf n (choose (0, 3) >>= flip vectorOf (template (if speaks manners then emits i else [])))
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
          ++ [(3, pure (TDone "Value")) | inTask]
          ++ [(1, elements [TFail, TFail, TDone "Other"]) | fails manners]
          ++ [(1, pure TFeedback) | inTask]
          ++ [(1, TCall <$> aTask manners {speaks = False} (depth - 1)) | depth > 0]

-- | Which bad things a program may do: emit events, and fail, give a 'Done' of another type than its task's or call in a 'Once'.
data Manners = Manners {speaks :: Bool, fails :: Bool}

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
  fs <- mapM (aFunction (Manners True False) False 0 . ("f" ++) . show) [1 .. n :: Int]
  let a = ATask "Nothing" Nothing fs Nothing AReturn
  pure (Shown (show a) (programOf (Int 0) a))

tasks :: Gen Shown
tasks = shownTask (Manners True False)

-- | Tasks, and controllers without any around them, in which every now and then something goes wrong.
fragile :: Gen Shown
fragile = shownTask (Manners True True)

shownTask :: Manners -> Gen Shown
shownTask manners = do
  a <- aTask manners 3
  pure (Shown (show a) (programOf (Int 0) a))

aTask :: Manners -> Int -> Gen ATask
aTask manners depth
  | depth <= 0 = frequency [(1, pure AReturn), (2, aLeaf), (2, AWait <$> elements [0, 20, 20, 40] <*> pure AReturn)]
  | otherwise =
    frequency
      [ (5, aLeaf),
        (1, AOnce <$> aFunction manners False (if fails manners then min 1 depth else 0) "once" <*> aTask manners (depth - 1)),
        (2, AWait <$> elements [0, 20, 20, 40] <*> aTask manners (depth - 1)),
        (2, ABoth <$> aTask manners (depth - 1) <*> aTask manners (depth - 1) <*> aTask manners (depth - 1)),
        (2, AFirst <$> aTask manners (depth - 1) <*> aTask manners (depth - 1) <*> aTask manners (depth - 1))
      ]
  where
    aLeaf = do
      s <- frequency [(1, pure Nothing), (2, Just <$> aFunction manners True 0 "start")]
      n <- choose (0, 3)
      fs <- mapM (aFunction manners True (min 1 (depth - 1)) . ("f" ++) . show) [1 .. n :: Int]
      c <- frequency [(1, pure Nothing), (2, Just <$> aFunction manners False 0 "stopped")]
      t <- if fails manners then elements ["Value", "Value", "Other"] else pure "Value"
      ATask t s fs c <$> aTask manners (depth - 1)

-- | Two functions that feed each other, and one that listens.
endless :: Program
endless = Task (Spec "Nothing" Nothing [ping, pong, listener] Nothing) Return
  where
    ping = Function "ping" (Either (Event "Bumper") (Event "E0")) (\v -> [Emit "E1" (Int (weight v `mod` 5))])
    pong = Function "pong" (Event "E1") (\v -> [Emit "E0" v, Write "M0" v])
    listener = Function "listener" (All [Event "Button", Memory "M0"]) (\v -> [Command v])
