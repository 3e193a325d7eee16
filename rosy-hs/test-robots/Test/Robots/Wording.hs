{-# LANGUAGE OverloadedStrings #-}

-- |
-- Description : What rosy-robot and built programs say, in other languages.
module Test.Robots.Wording (tests) where

import Control.Exception (toException)
import Control.Monad (forM_)
import Data.Char (isAlpha, isAscii)
import Data.Maybe (isJust, mapMaybe)
import qualified Data.Text as T
import Rosy.Problem (Fault (..), problemFrom, problemHint, problemMessage)
import Rosy.Robots.BuiltProgram (readCommandLine, usage)
import Rosy.Robots.Connection
import Rosy.Robots.RosbridgeCodec (decodeFrame, frameComplaint)
import Rosy.Robots.Target
import Rosy.Robots.Wording
import Rosy.Sentence
import Test.Tasty
import Test.Tasty.HUnit

tests :: TestTree
tests =
  testGroup
    "wording"
    [ testCase "the first variable of the locale that is set names the language" $ do
        let named variables = terminalLanguage (`lookup` variables)
        named [("LANG", "pt_BR.UTF-8")] @?= Translated "pt"
        named [("LC_ALL", ""), ("LC_MESSAGES", "fr"), ("LANG", "de_DE")] @?= Translated "fr"
        named [("ROSY_LOCALE", "es"), ("LC_ALL", "C.UTF-8")] @?= Translated "es"
        named [("LC_ALL", "en_XA")] @?= Pseudo
        mapM_ (\locale -> named [("LANG", locale)] @?= English) ["C", "POSIX", "en_GB.UTF-8", "xx_XX"]
        named [] @?= English,
      testCase "a sentence within a sentence is in the same language" $ do
        let lost = explainNotice robot (IsLost (tr "it has fallen silent"))
        worded English lost @?= "the robot at ws://pi is lost: it has fallen silent"
        worded (Translated "de") lost @?= "der Roboter bei ws://pi ist verloren: er ist verstummt",
      testCase "a text without translation stays, and so does a sentence that no table has" $ do
        worded Pseudo (verbatim "No such file") @?= "No such file"
        worded (Translated "de") (fromPortable "{\"id\":\"Not in {a table}.\"}") @?= "Not in {a table}.",
      testCase "formats are those of the language" $ do
        worded Pseudo (fromPortable "{\"id\":\"{a type}, {or names}, {then types}\",\"arguments\":{\"type\":\"A -> B\",\"names\":[\"x\",\"y\",\"z\"],\"types\":[\"A\",\"B\"]}}")
          @?= "å ƒûñçţîöñ ‘A -> B’, ‘x’, ‘y’ öŕ ‘z’, å ‘A’, ţĥéñ å ‘B’",
      testCase "nothing that is said is without a translation" $
        forM_ sentences $ \s -> do
          assertBool (T.unpack (english s)) (not (readsAsEnglish (worded Pseudo s)))
          forM_ languages $ \tag -> assertBool (T.unpack (tag <> ": " <> english s)) (worded (Translated tag) s /= english s)
    ]
  where
    robot = trWith "the robot at {address}" ["address" =: "ws://pi"]
    sentences =
      map (explainNotice robot) [IsAwaited unknownReason, IsAwaited (tr "it is not plugged in"), IsThere, IsLost unknownReason, IsLost (tr "it has fallen silent"), IsBack, IsRefused (trWith "its firmware {version} speaks another protocol" ["version" =: "2.2.0"]), IsComplaining (verbatim "x"), IsUnreadable (verbatim "y")]
        ++ mapMaybe (frameComplaint . decodeFrame [] []) ["{\"op\":\"service_response\",\"service\":\"/x\",\"result\":false}", "{\"op\":\"service_response\",\"service\":\"/x\",\"result\":false,\"values\":\"y\"}"]
        ++ [explainTargetError e | address <- ["pi", "ws://pi?robot=hal", "serial:/dev/x?robot=turtlesim", "ws://pi?ros=7"], Left e <- [readTarget address]]
        ++ [why | given <- [[], ["--sead", "1"], ["--robot"], ["--robot", "ws://pi", "--world", "maze"], ["--robot", "ws://pi", "--seconds", "soon"]], Left why <- [readCommandLine "walk" given]]
        ++ filter (isJust . sentenceId) (usage "walk")
        ++ concat [[problemMessage p, problemHint p] | p <- [problemFrom Nothing [] Nothing (toException (LinkLost "x"))]]

-- | Three words of English letters that follow one another, outside of options, commands and addresses.
readsAsEnglish :: T.Text -> Bool
readsAsEnglish = any ((>= 3) . length) . runs . map isEnglish . T.words
  where
    isEnglish w = T.length w > 1 && T.all (\c -> isAscii c && isAlpha c) (T.dropWhileEnd (`elem` (".,;:?!" :: String)) w)
    runs flags = case span not flags of
      (_, []) -> []
      (_, rest) -> takeWhile id rest : runs (dropWhile id rest)
