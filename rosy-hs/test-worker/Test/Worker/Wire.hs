{-# LANGUAGE OverloadedStrings #-}

-- |
-- Module      : Test.Worker.Wire
-- Description : Lines, requests, places and words: the pure parts of the worker.
module Test.Worker.Wire (tests) where

import Control.Monad (void)
import Data.Aeson (Value (..))
import qualified Data.ByteString as ByteString
import qualified Data.ByteString.Char8 as Char8
import Data.Either (isLeft)
import qualified Data.Text as Text
import Rosy.Worker.Kind.Syntax (explainSyntax)
import Rosy.Worker.Kind.Words
import Rosy.Worker.Place
import Rosy.Worker.Problem
import Rosy.Worker.Wire
import Test.Tasty (TestTree, testGroup)
import Test.Tasty.HUnit
import Test.Tasty.QuickCheck

tests :: TestTree
tests =
  testGroup
    "The pure parts"
    [ testProperty "a stream gives the same lines however it is cut" $ \pieces ->
        let bytes = map Char8.pack pieces
            feed s [] = ([], s)
            feed s (b : bs) = let (ls, s') = cut s b; (more, end') = feed s' bs in (ls ++ more, end')
            -- How the unfinished line is kept is its own business: finish it.
            linesOf parts = fst (feed noLines (parts ++ ["\n"]))
         in linesOf bytes == linesOf [ByteString.concat bytes],
      testCase "a line that is too long is reported once, and the next one is heard" $ do
        let long = ByteString.replicate (longestLine + 5) 65
            (first, s) = cut noLines long
            (second, _) = cut s "more\nnext\n"
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
      testCase "a request keeps the id it was given" $
        parseRequest "{\"op\":\"kill\",\"id\":\"a\"}" @?= Right (Kill (String "a")),
      testProperty "without tabs, a column is a column" $ \(Positive l) (Positive c) ->
        placeOf (columnsOf "no tabs\nhere") l c == Place l c,
      testCase "a tab counts as one character" $
        map (column . placeOf (columnsOf "a\tb\tc") 1) [1, 2, 9, 10, 17] @?= [1, 2, 3, 4, 5],
      testProperty "a span is never empty and never reversed" $ \(Positive a') (Positive b') ->
        let s = spanOf (columnsOf "\t\tx\ty") (1, a') (1, b') in start s < end s,
      testProperty "any text that cannot be read gets one sentence" $ \source (Positive l) (Positive c) ->
        let at = Place l c
            p = explainSyntax (Text.pack source) "parse error" (Just (Span at at {column = c + 1}))
         in not (Text.null (message p)) && Text.length (Text.filter (== '.') (message p)) >= 1,
      testCase "a type is taken apart at its outer arrows" $
        splitArrows "(a -> b) -> [c] -> Maybe d" @?= ["(a -> b)", "[c]", "Maybe d"],
      testCase "what Rosy added is taken out of GHC's words" $
        scrub "In the expression: (simulateNamed Names [Name \"a(\", Name \"b\"]) (a, b)" @?= "In the expression: simulate (a, b)"
    ]
