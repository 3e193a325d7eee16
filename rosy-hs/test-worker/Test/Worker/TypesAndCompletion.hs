{-# LANGUAGE OverloadedStrings #-}

-- |
-- Module      : Test.Worker.TypesAndCompletion
-- Description : Tests of the types of source spans and of code completion.
module Test.Worker.TypesAndCompletion (tests) where

import Control.Monad (forM_)
import Data.Aeson (Value (..), object, (.=))
import Data.Foldable (toList)
import Data.List (isInfixOf)
import Data.Maybe (listToMaybe)
import Data.Text (Text)
import qualified Data.Text as Text
import Test.Tasty (TestTree, testGroup)
import Test.Tasty.HUnit
import Test.Worker.Client

tests :: IO Worker -> TestTree
tests borrow =
  testGroup
    "Places in a program"
    [ testGroup
        "what the pointer is on has the type"
        [ testCase (Text.unpack (piece <> " :: " <> wanted)) $ do
            worker <- borrow
            pieces <- typesOf worker driving
            assertBool (show [t | (p, t) <- pieces, p == piece]) ((piece, wanted) `elem` pieces)
          | (piece, wanted) <-
              [ ("drive", "Bumper -> Memory Hit -> Either Stop Velocity"),
                ("hit", "Hit"),
                ("Velocity", "Double -> Double -> Velocity"),
                ("Left", "Stop -> Either Stop Velocity"),
                ("Right", "Velocity -> Either Stop Velocity"),
                ("Memory", "Hit -> Memory Hit"),
                ("0.5", "Double"),
                ("if hit then Left Stop else Right (Velocity 0.5 (turn 3))", "Either Stop Velocity"),
                ("turn 3", "Double"),
                ("twice", "(a -> a) -> a -> a"),
                ("f . f", "a -> a"),
                ("simulate drive", "IO ()"),
                ("_", "Bumper")
              ]
        ],
      testCase "pieces are in order, and nothing that was not written has a place" $ do
        worker <- borrow
        answer <- ask worker (check (Number 1) driving)
        let places = [map number (elements p) | p <- elements (field "at" (field "types" answer))]
            spans = [((l, c), (negate l', negate c')) | l : c : l' : c' : _ <- places]
        assertBool "in order" (and (zipWith (<=) spans (drop 1 spans)))
        assertBool "the derived code of Stop" (null [() | l : _ <- places, l == 1]),
      testCase "the name has the function's type in each equation, also where it stands between its patterns first" $ do
        worker <- borrow
        pieces <- typesOf worker "main = pure ()\n\npick :: Int -> Bool\npick 1 = True\npick 2 = False\npick\n  _ = True\n\nlater :: Int -> Int -> Char -> Bool\nlater 1 _ _ = True\n(_ `later` 2) _ = False\n(  3 `later` _) _ = False\nlater _ _ _ = True\n"
        [piece | (piece, "Int -> Bool") <- pieces] @?= replicate 3 "pick"
        let named = [piece | (piece, "Int -> Int -> Char -> Bool") <- pieces]
        assertBool (show named) (take 1 named == ["later"] && drop (length named - 1) named == ["later"] && all (`elem` ["later", "`later`"]) named),
      testCase "a program of a hundred lines has types of some ten kilobytes" $ do
        worker <- borrow
        answer <- ask worker (check (Number 2) (Text.unlines (driving : [Text.replace "N" (Text.pack (show n)) "stepN :: Bumper -> Memory Hit -> Either Stop Velocity\nstepN (Bumper _ Pressed) (Memory hit) = if hit then Left Stop else Right (Velocity (1 + N) 0)\nstepN _ _ = Left Stop" | n <- [1 .. 30 :: Int]])))
        let bytes = length (show (field "types" answer))
        assertBool (show bytes) (bytes > 1000 && length (elements (field "at" (field "types" answer))) < 1000),
      testCase "a program with a mistake has types for the rest" $ do
        worker <- borrow
        pieces <- typesOf worker (driving <> "\nwrong :: Double\nwrong = not 1\n")
        assertBool "" (("turn 3", "Double") `elem` pieces),
      testGroup
        "what can stand where the cursor is"
        [ testCase (Text.unpack program) $ do
            worker <- borrow
            answer <- ask worker (completeAt program)
            field "expected" answer @?= maybe Null String wanted
            let names = map (text "name") (elements (field "names" answer))
            assertBool (show (take 12 names)) (offered `isInfixOf` names)
            forM_ absent (\n -> assertBool (show n) (n `notElem` names))
          | (program, wanted, offered, absent) <-
              [ ("move :: Velocity\nmove = ‸\nhalt = Velocity 0 0\nmain = simulate move\n", Just "Velocity", ["halt", "move", "Velocity"], ["Stop", "True", "readFile"]),
                ("move :: Velocity\nmove = Vel‸ 1\nmain = simulate move\n", Just "t0 -> Velocity", [], ["move"]),
                ("move = Velocity 0.5 (ha‸lf 3)\nhalf x = x / 2\nmain = simulate move\n", Just "t0 -> Double", ["half"], ["Velocity"]),
                ("play :: Bumper -> Maybe Sound\nplay (Bumper _ ‸) = Nothing\nmain = simulate play\n", Just "BumperStatus", ["Pressed", "Released"], ["Bumper"]),
                ("play :: Bumper -> Maybe ‸\nplay _ = Nothing\nmain = simulate play\n", Nothing, ["Sound"], ["ErrorSound", "play"]),
                ("near :: Position -> Velocity -> Velocity\nnear p v = if ‸ then v else Velocity 0 0\nmain = simulate near\n", Just "Bool", ["False", "True", "otherwise"], ["p", "v"]),
                ("same :: a -> a -> a\nsame x y = ‸\nmain = pure ()\n", Just "a", ["x", "y"], ["True", "Velocity"]),
                ("import qualified Data.Map as Map\ntable :: Map.Map Int String\ntable = Map.‸\nmain = pure ()\n", Just "Map Int String", ["Map.empty"], ["empty"]),
                ("main = ((((‸\n", Nothing, [], ["main"]),
                ("import System.IO\nmain = ‸\n", Nothing, [], ["main"]),
                ("main = simulate \"‸\"\n", Nothing, [], ["main"])
              ]
        ],
      testCase "a cursor outside the text is answered" $ do
        worker <- borrow
        answers <- mapM (\(l, c) -> ask worker (asking "main = pure ()\n" l c)) [(0, 0), (-1, 5), (1, 99), (99, 1), (1, 0)]
        map (text "op") answers @?= replicate 5 "completed"
    ]

-- | Each piece with its type, once for each place.
typesOf :: Worker -> Text -> IO [(Text, Text)]
typesOf worker source = do
  answer <- ask worker (check (String "types") source)
  let found = field "types" answer
      names = map plain (elements (field "names" found))
  pure [(between source (l, c) (l', c'), names !! n) | [l, c, l', c', n] <- map (map number . elements) (elements (field "at" found))]
  where
    plain (String s) = s
    plain other = Text.pack (show other)

between :: Text -> (Int, Int) -> (Int, Int) -> Text
between source (l, c) (l', c') = Text.drop (offset l c) (Text.take (offset l' c') source)
  where
    offset line column = sum (map ((+ 1) . Text.length) (take (line - 1) (Text.lines source))) + column - 1

elements :: Value -> [Value]
elements (Array xs) = toList xs
elements _ = []

number :: Value -> Int
number (Number n) = round n
number _ = 0

-- | The cursor is written into the program.
completeAt :: Text -> Value
completeAt program = asking (before <> Text.drop 1 after) (length lines') (maybe 1 ((+ 1) . Text.length) (listToMaybe (reverse lines')))
  where
    (before, after) = Text.breakOn "‸" program
    lines' = Text.splitOn "\n" before

asking :: Text -> Int -> Int -> Value
asking source l c = object ["op" .= ("complete" :: Text), "id" .= (1 :: Int), "source" .= source, "line" .= l, "column" .= c]

driving :: Text
driving =
  Text.unlines
    [ "data Stop = Stop deriving (Eq, Show)",
      "type Hit = Bool",
      "drive :: Bumper -> Memory Hit -> Either Stop Velocity",
      "drive _ (Memory hit) = if hit then Left Stop else Right (Velocity 0.5 (turn 3))",
      "turn :: Double -> Double",
      "turn x = x / 2",
      "twice f = f . f",
      "main = simulate drive"
    ]
