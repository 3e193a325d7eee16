-- |
-- Description : The command line of a program that @./rosy build@ made.
module Test.Robots.BuiltProgram (tests) where

import Data.Bifunctor (first)
import Data.Either (isRight)
import Data.List (isPrefixOf, nub, sort)
import qualified Data.Text as T
import Rosy.Robots.BuiltProgram
import Rosy.Sentence (english)
import Test.Tasty
import Test.Tasty.HUnit

tests :: TestTree
tests =
  testGroup
    "a built program's command line"
    [ testCase "a robot, and how long at most" $ do
        typed "--robot ws://pi" @?= Right (OnRobot "ws://pi" Nothing)
        typed "--seconds .5 --robot ros://pi" @?= Right (OnRobot "ros://pi" (Just 0.5))
        typed "--robot=ws://pi?ros=2 --seconds=10" @?= Right (OnRobot "ws://pi?ros=2" (Just 10)),
      testCase "what is said last counts" $
        typed "--robot ws://a --seconds 1 --seconds 2 --robot ws://b" @?= Right (OnRobot "ws://b" (Just 2)),
      testCase "without a robot, any option of ./rosy run means the simulator" $
        mapM_ ((@?= Right InSimulator) . typed) ["--world maze --seconds 3 --seed 1 --speed max --trace t.jsonl --input hands.jsonl", "--seconds 3", "--world=maze"],
      testCase "the other end of a link" $ typed "--link 7" @?= Right (OnLink 7),
      testCase "help, wherever it is asked for" $ mapM_ ((@?= Right Help) . typed) ["--help", "-h", "--world maze --help"],
      testCase "without a word it says both ways" $
        typed "" @?= Left "Say which robot to drive: walk --robot ws://HOST:9090, ros://HOST:11311 or serial:/dev/kobuki. Where Rosy is, walk --world room tries it in the simulator.",
      testCase "what it does not take is named" $ do
        typed "--sead 3" @?= Left "walk does not take --sead. walk --help says what there is."
        typed "ws://pi" @?= Left "walk does not take ws://pi. walk --help says what there is."
        typed "--seconds 3 --robot" @?= Left "Say what --robot is. walk --help says what there is."
        typed "--link seven" @?= Left "walk does not take --link. walk --help says what there is.",
      testCase "a real robot has no room and no luck" $
        mapM_
          (\o -> typed ("--robot ws://pi " ++ o ++ " 1") @?= Left (o ++ " is for the simulator; a real robot cannot have it."))
          ["--world", "--seed", "--speed", "--trace", "--input"],
      testCase "a time that is none, or longer than a week, is refused" $
        mapM_ (\s -> typed ("--robot ws://pi --seconds " ++ s) @?= Left "--seconds must be between 0 and 604800.") ["soon", "-1", "604801", "NaN", "Infinity"],
      testCase "its help names all that it takes" $ do
        let named = nub [w | w <- words (concatMap ((++ "\n") . said) (usage "walk")), "--" `isPrefixOf` w]
        sort named @?= ["--input", "--robot", "--seconds", "--seed", "--speed", "--trace", "--world"]
        mapM_ (\o -> assertBool o (isRight (readCommandLine "walk" [o, "1"]))) named
    ]
  where
    typed = first said . readCommandLine "walk" . words
    said = T.unpack . english
