-- |
-- Description : Rosy's links to real robots, with robots that are not.
module Main (main) where

import Control.Monad (forM_)
import qualified Data.Text as T
import Rosy.Robots.RobotRun (runOnRobot)
import Rosy.Robots.Target (explainTargetError, readTarget)
import Rosy.Sentence (english)
import System.Environment (getArgs)
import System.Exit (die, exitWith)
import qualified Test.Robots.ActionClient
import qualified Test.Robots.BuiltProgram
import qualified Test.Robots.Distance
import qualified Test.Robots.Guard
import Test.Robots.Kobuki (anHour)
import qualified Test.Robots.Kobuki
import qualified Test.Robots.Links
import qualified Test.Robots.Motion
import Test.Robots.Programs (byName)
import qualified Test.Robots.RealLink
import Test.Robots.Rigs (withReady)
import qualified Test.Robots.Same
import qualified Test.Robots.Target
import qualified Test.Robots.Telemetry
import qualified Test.Robots.Wording
import Test.Tasty

main :: IO ()
main =
  getArgs >>= \case
    -- The tests start this program again as a learner's program.
    ["--drive", url, name] -> either (die . T.unpack . english . explainTargetError) (\t -> runOnRobot t (byName name) >>= exitWith) (readTarget url)
    -- Hours on a bad cable, one for each of these numbers.
    ["--hours", from, to] -> forM_ [read from .. read to] $ \seed -> putStrLn (show seed ++ ": " ++ show (anHour seed) ++ " wrong")
    _ -> defaultMain suite

suite :: TestTree
suite =
  testGroup
    "robots"
    [ Test.Robots.Kobuki.tests,
      Test.Robots.Guard.tests,
      Test.Robots.RealLink.tests,
      Test.Robots.ActionClient.tests,
      Test.Robots.Distance.tests,
      Test.Robots.Target.tests,
      Test.Robots.BuiltProgram.tests,
      Test.Robots.Telemetry.tests,
      Test.Robots.Wording.tests,
      withReady (\ready -> testGroup "robots that are not" [Test.Robots.Links.tests ready, Test.Robots.Same.tests ready, Test.Robots.Motion.tests ready])
    ]
