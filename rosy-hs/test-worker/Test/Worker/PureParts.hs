{-# LANGUAGE OverloadedStrings #-}

-- |
-- Module      : Test.Worker.PureParts
-- Description : Tests of the pure modules: line buffer, requests, positions, sentences.
module Test.Worker.PureParts (tests) where

import Control.Monad (void, (>=>))
import Data.Aeson (Value (..), eitherDecodeFileStrict', object, (.:), (.=))
import Data.Aeson.Types (parseEither)
import Data.Bifunctor (bimap)
import qualified Data.ByteString as ByteString
import qualified Data.ByteString.Char8 as Char8
import Data.Either (isLeft)
import qualified Data.Text as Text
import Rosy.Worker.Explanation.MessageText
import Rosy.Worker.Explanation.RobotVocabulary (robotLimits)
import Rosy.Worker.Explanation.SyntaxErrors (explainSyntax)
import Rosy.Worker.Explanation.TextRepair (programOf)
import Rosy.Worker.Explanation.TextualMistakes (textualMistakes)
import Rosy.Worker.MemoryCeiling
import Rosy.Worker.Problem
import Rosy.Worker.Protocol
import Rosy.Worker.Sentence
import Rosy.Worker.TabStops
import Test.Tasty (TestTree, testGroup)
import Test.Tasty.HUnit
import Test.Tasty.QuickCheck

tests :: TestTree
tests =
  testGroup
    "The pure parts"
    [ testProperty "a stream gives the same lines however it is split" $ \pieces ->
        let bytes = map Char8.pack pieces
            feed s [] = ([], s)
            feed s (b : bs) = let (ls, s') = splitLines s b; (more, end') = feed s' bs in (ls ++ more, end')
            -- How the unfinished line is kept is its own business: finish it.
            linesOf parts = fst (feed emptyLineBuffer (parts ++ ["\n"]))
         in linesOf bytes == linesOf [ByteString.concat bytes],
      testCase "a line that is too long is reported once, and the next one is heard" $ do
        let long = ByteString.replicate (maxLineBytes + 5) 65
            (first, s) = splitLines emptyLineBuffer long
            (second, _) = splitLines s "more\nnext\n"
        (first, second) @?= ([TooLong], [Line "next"]),
      testGroup
        "a request that is wrong says so"
        [ testCase (show l) (assertBool "" (isLeft (parseRequest l)))
          | l <- ["", "{", "[]", "3", "{\"op\":\"check\"}", "{\"op\":\"check\",\"id\":1}", "{\"op\":\"dance\",\"id\":1}", "{\"id\":1}", "{\"op\":\"run\",\"id\":1,\"source\":\"\",\"memory\":\"much\"}", "\xff\xfe"]
        ],
      testCase "a source may have two hundred thousand characters and no more" $ do
        let request n = parseRequest ("{\"op\":\"check\",\"id\":1,\"source\":\"" <> ByteString.replicate n 97 <> "\"}")
        void (request 200000) @?= Right ()
        assertBool "" (isLeft (request 200001)),
      testCase "a byte order mark in front of a source is no part of it" $
        parseRequest "{\"op\":\"check\",\"id\":1,\"source\":\"\\ufeffa = 1\"}" @?= Right (Ask (Number 1) (Check "a = 1")),
      testCase "a request keeps the id it was given" $
        parseRequest "{\"op\":\"kill\",\"id\":\"a\"}" @?= Right (Kill (String "a")),
      testProperty "without tabs, a column is a column" $ \(Positive l) (Positive c) ->
        positionFromGhc (tabStopsOf "no tabs\nhere") l c == Position l c,
      testCase "a tab counts as one character" $
        map (column . positionFromGhc (tabStopsOf "a\tb\tc") 1) [1, 2, 9, 10, 17] @?= [1, 2, 3, 4, 5],
      testProperty "a span is never empty and never reversed" $ \(Positive a') (Positive b') ->
        let s = spanFromGhc (tabStopsOf "\t\tx\ty") (1, a') (1, b') in start s < end s,
      testProperty "any text that cannot be read gets one sentence" $ \source (Positive l) (Positive c) ->
        let at = Position l c
            p = explainSyntax (Text.pack source) Nothing "parse error" (Just (Span at at {column = c + 1}))
         in not (Text.null (english (message p))) && Text.any (== '.') (english (message p)),
      testCase "a sentence is its template with the arguments as English has them" $ do
        let given = ["x" =: "Int", "f" =: "Bumper -> Sound", "n" =# 3, "many" =# 13, "names" =* ["a", "b", "c"]]
            said t = english (trWith t given)
        map said ["{x}", "{a x}", "{a f}", "{count n} {n}", "{count many}", "{or names}", "{then names}"]
          @?= ["Int", "an ‘Int’", "a function ‘Bumper -> Sound’", "three 3", "13", "‘a’, ‘b’ or ‘c’", "a ‘a’, then a ‘b’, then a ‘c’"]
        said "{starting = …} {y} {x" @?= "{starting = …} {y} {x"
        (sentenceId (tr "One."), sentenceId (verbatim "GHC")) @?= (Just (object ["id" .= ("One." :: Text.Text)]), Nothing),
      testProperty "the children that may stay fit below both ceilings, and no child ends without need" $ \sizes (Positive most) (Positive each) ->
        let usages = [Usage pid ([Prepared, Compiling, Running] !! (does `mod` 3)) (fromIntegral (size `mod` 1000)) | (pid, (does, size)) <- zip [1 ..] (sizes :: [(Int, Int)])]
            limits = ceilings (fromIntegral (most :: Int)) (fromIntegral (each :: Int))
            ended = overdraft limits usages
            left = filter ((`notElem` ended) . process) usages
            fits us = sum (map bytes (filter ((/= Running) . activity) us)) <= compilingTotal limits && sum (map bytes us) <= allTotal limits
         in counterexample (show ended) (fits left && (not (fits usages) || null ended)),
      testCase "the largest compilation ends first" $
        overdraft (ceilings 100 50) [Usage 1 Running 60, Usage 2 Compiling 20, Usage 3 Compiling 30, Usage 4 Compiling 5] @?= [3],
      testCase "what is only prepared ends before what compiles, and that before what runs" $
        overdraft (ceilings 100 80) [Usage 1 Running 60, Usage 2 Compiling 70, Usage 3 Prepared 5, Usage 4 Prepared 6] @?= [4, 3, 2],
      testCase "advice about speeds knows the robot's own limits" $ do
        robot <- either assertFailure pure =<< eitherDecodeFileStrict' "protocol/robots/kobuki.json"
        let limit name = parseEither ((.: "limits") >=> (.: name) >=> (.: "value")) robot
        (limit "speed", limit "turn") @?= bimap Right Right robotLimits,
      testGroup
        "no rule about the text finds a mistake in a program without one"
        [ testCase (Text.unpack (Text.takeWhile (/= '\n') program)) (map (english . message) (textualMistakes (programOf program)) @?= [])
          | program <-
              [ "points = [(1,2), (3,4)]\nlist = [1,2,3]",
                "f = g . h\nrange = [1..5]\nx = 1.5e-3",
                "type family Elem c\ndata Mode = Go | Stop",
                "go s | s > 1, x <- s = [y | y <- [x], y > 2]",
                "main = simulate $ do\n  drive 50\n  turn 90",
                "main = simulate $ do drive 50; turn 90",
                "run = forever $ do\n  wait 0.5\n  beep",
                "f (Bumper LeftBumper Pressed) = Velocity 0 (-1)\nf _ = Velocity 0 0",
                "f x = case x of\n  Just y -> y * 2\n  _ -> 0",
                "f :: (Num a, Ord a) => a -> a\nf x = if x > 0 && not (x > 3) then x else 2 * x",
                "d = let c = 1; e = c - 1 in c + e\n-- | a comment\n--- another",
                "name' = 'x'\ntext = \"it's – fine, 1,5 cm\"",
                "module Main where\nimport Data.List (sort)",
                "e = Robot {speed = 1, side = 'l'}"
              ]
        ],
      testCase "a type is taken apart at its outer arrows" $
        splitArrows "(a -> b) -> [c] -> Maybe d" @?= ["(a -> b)", "[c]", "Maybe d"],
      testCase "what Rosy added is taken out of GHC's words" $
        withoutGeneratedNames "In the expression: (simulateNamed Names [Name \"a(\", Name \"b\"]) (a, b)" @?= "In the expression: simulate (a, b)"
    ]
