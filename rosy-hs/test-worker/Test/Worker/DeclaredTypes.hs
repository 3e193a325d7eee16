{-# LANGUAGE OverloadedStrings #-}

-- |
-- Module      : Test.Worker.DeclaredTypes
-- Description : Tests of what a declared type gets: derived instances as in GHC, and a default for its memory or a refusal.
--
-- Each row is a program: what is said about it before it runs, or what it says when it runs.
module Test.Worker.DeclaredTypes (tests) where

import Data.Aeson (Value (..), object, toJSON, (.=))
import Data.Foldable (toList)
import Data.Text (Text)
import qualified Data.Text as Text
import Test.Tasty (TestTree, testGroup)
import Test.Tasty.HUnit
import Test.Worker.Client

tests :: IO Worker -> TestTree
tests borrow =
  testGroup
    "Declared types"
    [ testGroup
        "deriving works as in GHC"
        [ "a newtype of a number is a number" `says` "Count 3" $ ["newtype Count = Count Int deriving (Eq, Ord, Show, Num, Enum, Real, Integral)", shows' "Count 1 + 2"],
          "the newtype strategy" `says` "5" $ ["newtype Count = Count Int deriving newtype (Show, Num)", shows' "Count 2 + 3"],
          "the stock strategy beside it" `says` "Count 5" $ ["newtype Count = Count Int deriving stock Show deriving newtype Num", shows' "Count 2 + 3"],
          "via another type" `says` "3" $ ["import Data.Monoid", "newtype Total = Total Int deriving (Semigroup, Monoid) via (Sum Int) deriving newtype Show", shows' "Total 1 <> Total 2"],
          "standing alone, with each strategy" `says` "(C 1,2,3,4)" $
            ["newtype C = C Int", "newtype D = D Int", "newtype E = E Int", "newtype F = F Int", "deriving stock instance Show C", "deriving newtype instance Show D", "deriving via Int instance Show E", "deriving newtype instance Show F", "deriving instance Num F", shows' "(C 1, D 2, E 3, F 4)"],
          "a class of the program with default methods" `says` "hello hello" $
            ["class Greets a where", "  greet :: a -> String", "  greet _ = \"hello\"", "data A = A deriving (Greets)", "data B = B deriving anyclass (Greets)", "main = simulate (Say (greet A ++ \" \" ++ greet B))"],
          "a newtype of a pair is a functor" `says` "P (2,3)" $ ["newtype P a = P (Int, a) deriving (Functor, Show)", shows' "fmap (+ 1) (P (2, 2))"],
          "the pragma of another program" `says` "Count 1" $ ["{-# LANGUAGE GeneralizedNewtypeDeriving, DerivingVia #-}", "newtype Count = Count Int deriving (Show, Num)", shows' "Count 1"],
          "the classes of Rosy" `says` "x" $ ["data Hit = Hit deriving (Sensor, Command)", "main = simulate (Hit, f)", "f :: Hit -> Say", "f _ = Say \"x\""],
          "a type that is sensed and sent as another" `says` "0.0" $
            ["newtype Speed = Speed Velocity deriving newtype (Sensor, Command)", "main = simulate f", "f :: Speed -> Say", "f (Speed v) = Say (show (velocityLinear v))"],
          "an instance left incomplete" `isRefused` ["missing-method"] $ ["data Vec = Vec Int Int deriving (Num)", stand],
          "an instance left incomplete by a strategy" `isRefused` ["missing-method"] $ ["newtype Count = Count Int deriving anyclass (Num)", stand],
          "a class that the type inside does not have" `isRefused` ["calculation"] $ ["newtype Word' = Word' String deriving (Num)", stand]
        ],
      testGroup
        "a name of Rosy's that the program defines as a type or as a constructor only"
        [ "a type: Rosy's constructor stays" `says` "0.3" $ ["data Velocity = Fast | Slow", "main = simulate (Say (show (linear (Velocity 0.3 0))))", "linear (Velocity v _) = v", "other :: Velocity -> Bool", "other Fast = True", "other Slow = False"],
          "a constructor: Rosy's type stays" `says` "Velocity 0.3" $ ["data Speed = Velocity Double deriving Show", "main = simulate (Say (show (Velocity 0.3)), keep)", "keep :: Velocity -> Velocity", "keep v = v"]
        ],
      testGroup
        "an event is shown as its derived Show would"
        [ "a constructor with fields" `isEvent` "Hit (-1) (Just 2.5)" $ ["data Hit = Miss | Hit Int (Maybe Double)", sends "Hit" "Hit (-1) (Just 2.5)"],
          "labels" `isEvent` "Hit {force = -1.0, from = [Hit {force = 2.0, from = []}]}" $ ["data Hit = Hit {force :: Double, from :: [Hit]}", sends "Hit" "Hit (-1) [Hit 2 []]"],
          "GADT syntax" `isEvent` "Hit 'x' Miss" $ ["data Hit where { Hit, Near :: Char -> Hit -> Hit; Miss :: Hit }", sends "Hit" "Hit 'x' Miss"],
          "parameters" `isEvent` "Pair (Pair 1 True) \"\"" $ ["data Pair a b = Pair a !b", sends "Pair (Pair Int Bool) String" "Pair (Pair 1 True) []"],
          "an operator" `isEvent` "1 :+ (2 :+ End)" $ ["data Sum' = Int :+ Sum' | End", sends "Sum'" "1 :+ (2 :+ End)"],
          "operators with their precedence" `isEvent` "Of (One 1 :+ (2 :* 3 :+ End))" $ ["infixr 5 :+", "infixl 7 :*", "data Sum' = Product :+ Sum' | End | Of Sum'", "data Product = Int :* Int | One Int", sends "Sum'" "Of (One 1 :+ (2 :* 3) :+ End)"],
          "an operator before its fields" `isEvent` "(:+) 1 2" $ ["data Sum' = (:+) Int Int", sends "Sum'" "1 :+ 2"],
          "an operator in GADT syntax" `isEvent` "1 :+ 2" $ ["infix 4 :+", "data Sum' where (:+) :: Int -> Int -> Sum'", sends "Sum'" "1 :+ 2"],
          "an operator in GADT syntax without a precedence" `isEvent` "(:+) 1 2" $ ["data Sum' where (:+) :: Int -> Int -> Sum'", sends "Sum'" "1 :+ 2"],
          "a constructor between its fields" `isEvent` "1 `And` 2" $ ["data Both = Int `And` Int", sends "Both" "1 `And` 2"],
          "a parameter of a higher kind" `isEvent` "Wrapped _" $ ["newtype Wrapped f = Wrapped (f Int)", sends "Wrapped Maybe" "Wrapped (Just 1)"],
          "a function" `isEvent` "Does _ 1" $ ["data Does = Does (Int -> Int) Int", sends "Does" "Does (+ 1) 1"],
          "a type of its own inside" `isEvent` "_" $ ["{-# LANGUAGE RankNTypes #-}", "newtype Same = Same (forall a. a -> a)", sends "Same" "Same id"],
          "texts that are literals of another type" `isEvent` "Hit \"a\"" $ ["{-# LANGUAGE OverloadedStrings #-}", "data Hit = Hit String", sends "Hit" "Hit \"a\""]
        ],
      testGroup
        "a memory starts with a finite default"
        [ "the first constructor that has one" `says` "Empty" $ ["data Stack = Push Int Stack | Empty deriving Show", remembers "Stack"],
          "through containers" `says` "Rose 0 []" $ ["data Rose a = Rose a [Rose a] deriving Show", remembers "(Rose Int)"],
          "of the program's own choice" `says` "Again 0" $ ["data Loop = Again Int | More Loop deriving Show", "instance Default Loop where defaultValue = Again 0", remembers "Loop"],
          "none" `isRefused` ["no-default"] $ ["data Loop = Again Loop | More Int Loop deriving Show", remembers "Loop"],
          "none, through other types and a synonym" `isRefused` ["no-default"] $ ["data A = A B deriving Show", "data B = B (Maybe Int, A) deriving Show", "type C = (Int, A)", remembers "C"],
          "none, of a type without constructors" `isRefused` ["no-default"] $ ["data Empty", "main = simulate f", "f :: Bumper -> Memory Empty", "f _ = Memory undefined"],
          "none in a parameter" `isRefused` ["no-default"] $ ["data Loop = Loop Loop deriving Show", "data Pair a = Pair a a deriving Show", "main = simulate f", "f :: Bumper -> Param (Pair Loop) -> Say", "f _ (Param p) = Say (show p)"],
          "none, written and never read" `isRefused` ["no-default"] $ ["data Loop = Loop Loop", "main = simulate f", "f :: Bumper -> Memory Loop", "f _ = Memory (let l = Loop l in l)"],
          "a type without a default that is in no memory" `says` "ok" $ ["data Loop = Loop Loop", "main = simulate (Say \"ok\", f)", "f :: Loop -> Velocity", "f _ = Velocity 0 0"]
        ]
    ]
  where
    says name wanted source = testCase name $ do
      answered <- firstStep name source
      [text "data" (field "msg" l) | l <- answered, text "topic" l == "/rosy/say"] @?= [wanted]
    isEvent name wanted source = testCase name $ do
      answered <- firstStep name source
      [e | l <- answered, text "op" l == "settled", String e <- elements (field "events" l)] @?= [wanted]
    -- What a program answers to the first step.
    firstStep :: String -> [Text] -> IO [Value]
    firstStep name source = do
      worker <- borrow
      withRun worker (toJSON name) (Text.unlines source) (64 * 1024 * 1024) $ \link -> do
        started <- hear worker
        assertEqual (show started) "started" (text "op" started)
        say link (object ["op" .= ("start" :: Text), "protocol" .= (1 :: Int), "seed" .= (1 :: Int), "trace" .= True])
        _ <- linesUntil "ready" link
        say link odometry
        say link (object ["op" .= ("step" :: Text), "step" .= (0 :: Int), "time" .= (0 :: Int)])
        answered <- linesUntil "settled" link
        say link (object ["op" .= ("stop" :: Text)])
        _ <- linesUntil "ended" link
        gone <- hear worker
        text "op" gone @?= "gone"
        pure answered
    isRefused name kinds source = testCase name $ do
      worker <- borrow
      tell worker (check (toJSON name) (Text.unlines source))
      answer <- answerOf worker (toJSON name)
      [text "kind" p | p <- elements (field "problems" answer), text "severity" p == "error"] @?= kinds
    elements v = case v of
      Array xs -> toList xs
      _ -> []
    shows' expression = "main = simulate (Say (show (" <> expression <> ")))"
    sends t value = "main = simulate f\nf :: Seconds -> " <> t <> "\nf _ = " <> value
    stand = "main = simulate (Velocity 0 0)"
    remembers t = "main = simulate f\nf :: Memory " <> t <> " -> Say\nf (Memory m) = Say (show m)"
    odometry =
      object
        [ "op" .= ("publish" :: Text),
          "topic" .= ("/odom" :: Text),
          "msg"
            .= object
              [ "pose" .= object ["pose" .= object ["position" .= object ["x" .= zero, "y" .= zero], "orientation" .= object ["z" .= zero, "w" .= (1 :: Int)]]],
                "twist" .= object ["twist" .= object ["linear" .= object ["x" .= zero], "angular" .= object ["z" .= zero]]]
              ]
        ]
    zero = 0 :: Int
