-- |
-- Module      : Support.Generated
-- Description : Generated programs of the model, and what happens to them.
module Support.Generated
  ( Shown (..),
    Days (..),
    controllers,
    tasks,
    fragile,
    endless,
  )
where

import Rosy.Model hiding (inTask, tasks)
import Test.QuickCheck hiding (Function, function, label)

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
  | TDrive Int
  | TLight Int
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
    TDrive n -> showString "drive " . shows n
    TLight n -> showString "light " . shows n
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
      TDrive n -> [Drive (if even (weight v) then n else 0)]
      TLight n -> [Light ((n + weight v) `mod` 4)]
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

-- | The last are its arbiters, the innermost first.
data AFunction = AFunction String Input Body [Arbiter]
  deriving (Show)

fromA :: AFunction -> Function
fromA (AFunction n i b own) = foldl (flip arbitrated) (Function n i (concatMap outletsOf (concat b)) (bodyOf b)) own
  where
    outletsOf t = case t of
      TWrite m -> [MayWrite m]
      TShare m -> [MayShare m]
      TEmit e -> [MayEmit e]
      TDone _ -> [MayTurn]
      TFeedback -> [MayTurn]
      TCall _ -> [MayTurn]
      _ -> []

-- | A program as it was generated. What follows a value is chosen without looking at it, except for being told.
data ATask
  = AReturn
  | ATask Type (Maybe AFunction) [AFunction] [([Arbiter], ATask)] (Maybe AFunction) ATask
  | AOnce AFunction ATask
  | AWait Int ATask
  | ABoth ATask ATask ATask
  | AFirst ATask ATask ATask
  deriving (Show)

programOf :: Value -> ATask -> Program
programOf v a = case a of
  AReturn -> Return v
  ATask t s fs ts c k -> Task (Spec t (fromA <$> s) (map fromA fs) (map besideOf ts) (fromA <$> c)) (`programOf` k)
  AOnce f k -> Once (fromA f) (programOf v k)
  AWait t k -> Wait t (programOf v k)
  ABoth x y k -> Both (programOf v x) (programOf v y) (`programOf` k)
  AFirst x y k -> First (programOf v x) (programOf v y) (`programOf` k)

-- | A call that is cancelled by button 0, tells its feedback and its end.
callOf :: ATask -> Calling
callOf task =
  Calling
    { arbiters = [],
      called = programOf (Int 0) task,
      cancel = Just (Function "cancel" (Event "Button") [MayTurn] (\v -> [Done "Value" v | v == Int 0])),
      feedback = \v -> if even (weight v) then Just (Function "feedback" (All []) [] (const [Command v])) else Nothing,
      response = \v -> Function "end" (Memory "M0") [] (\m -> [Command (Tuple [v, m])])
    }

-- | A task of a controller: what it ends with is ignored.
besideOf :: ([Arbiter], ATask) -> Calling
besideOf (own, task) =
  Calling
    { arbiters = own,
      called = programOf (Int 0) task,
      cancel = Nothing,
      feedback = const Nothing,
      response = const (Function "end of a task" (All []) [] (const []))
    }

-- | Which outputs a function may have: whether it may emit events, in a task or not, and how deep calls may go. A called task is silent
-- and calls no other: an event that starts a task that emits the event would multiply beyond counting.
aFunction :: Manners -> Bool -> Int -> String -> Gen AFunction
aFunction manners inTask depth label = do
  i <- anInput 2
  n <- choose (1, 3)
  choices <- vectorOf n (choose (0, 3) >>= flip vectorOf (template (if speaks manners then emits i else [])))
  pure (AFunction label i choices [])
  where
    -- Events that make events would multiply beyond counting in 64 rounds; 'endless' is the test of those.
    emits i
      | i `takes` "E1" = []
      | i `takes` "E0" = ["E1"]
      | otherwise = ["E0", "E1"]
    template events =
      frequency $
        [ (4, TCommand <$> choose (0, 100)),
          (2, TDrive <$> choose (1, 3)),
          (1, TLight <$> choose (0, 3)),
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
  (fs', ts) <- withPriorities fs =<< besideTasks (Manners True False) 2
  let a = ATask "Nothing" Nothing fs' ts Nothing AReturn
  pure (Shown (show a) (programOf (Int 0) a))

-- | A controller of these functions and tasks, in every second one with priorities between its parts, nested or not.
withPriorities :: [AFunction] -> [ATask] -> Gen ([AFunction], [([Arbiter], ATask)])
withPriorities fs ts = do
  placed <- oneof [pure [], arbitersFor 2 0 (length fs + length ts)]
  let at i = [a | (j, a) <- placed, j == i]
  pure ([AFunction n i b (at k) | (k, AFunction n i b _) <- zip [0 ..] fs], [(at k, t) | (k, t) <- zip [length fs ..] ts])

-- | For so many parts their arbiters, the innermost first, with numbers from the given one on. The deeper ones have greater numbers.
arbitersFor :: Int -> Int -> Int -> Gen [(Int, Arbiter)]
arbitersFor depth number n
  | depth == 0 || n < 2 = pure []
  | otherwise = do
    held <- elements [0, 20, 47, 100, 1000]
    split <- choose (1, n - 1)
    first' <- arbitersFor (depth - 1) (2 * number + 1) split
    second <- arbitersFor (depth - 1) (2 * number + 2) (n - split)
    pure (first' ++ [(split + i, a) | (i, a) <- second] ++ [(i, Arbiter number (if i < split then Leads held else Follows)) | i <- [0 .. n - 1]])

-- | Tasks among the functions of a controller, in one of three.
besideTasks :: Manners -> Int -> Gen [ATask]
besideTasks manners depth = frequency [(2, pure []), (1, choose (1, 2) >>= flip vectorOf (aTask manners (depth - 1)))]

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
      ts <- besideTasks manners {speaks = False} (depth - 1)
      (fs', ts') <- withPriorities fs ts
      ATask t s fs' ts' c <$> aTask manners (depth - 1)

-- | Two functions that feed each other, and one that listens.
endless :: Program
endless = Task (Spec "Nothing" Nothing [ping, pong, listener] [] Nothing) Return
  where
    ping = Function "ping" (Either (Event "Bumper") (Event "E0")) [MayEmit "E1"] (\v -> [Emit "E1" (Int (weight v `mod` 5))])
    pong = Function "pong" (Event "E1") [MayEmit "E0", MayWrite "M0"] (\v -> [Emit "E0" v, Write "M0" v])
    listener = Function "listener" (All [Event "Button", Memory "M0"]) [] (\v -> [Command v])
