{-# LANGUAGE OverloadedStrings #-}

-- |
-- Description : What a held robot's lines look like, held against the golden conversations.
module Test.Robots.Telemetry (tests) where

import Control.Monad (forM_)
import Data.Aeson (Value (..))
import qualified Data.Aeson as Aeson
import qualified Data.Aeson.KeyMap as KeyMap
import qualified Data.ByteString.Char8 as C
import qualified Data.ByteString.Lazy as L
import Data.List (nub, sort)
import Data.Maybe (isJust, mapMaybe)
import qualified Data.Text as T
import Rosy.Robot
import Rosy.Robot.Known (simulated)
import Rosy.Robots.Connection (Notice (..), unknownReason)
import Rosy.Robots.RobotProcess (readRequest)
import Rosy.Robots.Telemetry
import Rosy.Sentence (tr, trWith, (=:))
import System.Directory (listDirectory)
import Test.Tasty
import Test.Tasty.HUnit

tests :: TestTree
tests =
  testGroup
    "a held robot"
    [ testCase "understands all that the service asks in the golden conversations" $ do
        asked <- spoken "service"
        assertBool "nothing is asked" (not (null asked))
        forM_ asked $ \l -> assertBool (show l) (isJust (readRequest (L.toStrict (Aeson.encode l)))),
      testCase "says nothing but what stands in the golden conversations" $ do
        golden <- spoken "holder"
        sort (nub (map shape golden)) @?= sort (nub (map shape said)),
      testCase "says why a robot is lost as a sentence with its arguments" $
        fieldOf "sentence" (linkLine (IsRefused (trWith "its firmware {version} speaks another protocol" ["version" =: "0.9"])))
          @?= Just (Aeson.object ["id" Aeson..= ("its firmware {version} speaks another protocol" :: T.Text), "arguments" Aeson..= Aeson.object ["version" Aeson..= ("0.9" :: T.Text)]]),
      testCase "shows the state of each sensor, the left one first" $
        map robotState [BumperMessage (Bumper LeftBumper Pressed), CliffMessage (Cliff RightCliff Hole), WheelMessage (Wheel LeftWheel Air), ButtonMessage (Button Button2 Pressed)]
          @?= [([1, 0, 0], [0, 0, 0], [0, 0], [0, 0, 0]), ([0, 0, 0], [0, 0, 1], [0, 0], [0, 0, 0]), ([0, 0, 0], [0, 0, 0], [1, 0], [0, 0, 0]), ([0, 0, 0], [0, 0, 0], [0, 0], [0, 0, 1])],
      testCase "shows what is let go of no more" $
        numbers "Bumper" (applyMessage (BumperMessage (Bumper LeftBumper Released)) (applyMessage (BumperMessage (Bumper LeftBumper Pressed)) blank)) @?= [0, 0, 0],
      testCase "shows the last command of each light, and none that does not last" $ do
        numbers "Led1" (applyCommand (Led1Command (Led1 Red)) blank) @?= [3]
        numbers "Sound" (applyCommand (SoundCommand ErrorSound) blank) @?= [],
      testCase "tells each event once, as Haskell shows it" $ do
        let (first, p) = frameLine 1 False (applyMessage (BumperMessage (Bumper LeftBumper Pressed)) blank)
        (fieldOf "sensed" first, fieldOf "sensed" (fst (frameLine 1 False p))) @?= (Just (Aeson.toJSON ["Bumper LeftBumper Pressed" :: T.Text]), Just (Aeson.toJSON ([] :: [T.Text]))),
      testCase "tells each firing once" $ do
        let (first, p) = frameLine 1 False (recordFirings ["a", "b"] blank)
        (fieldOf "fired" first, fieldOf "fired" (fst (frameLine 1 False p))) @?= (Just (Aeson.toJSON ["a", "b" :: T.Text]), Just (Aeson.toJSON ([] :: [T.Text])))
    ]
  where
    blank = initialState simulated
    robotState m = let p = applyMessage m blank in (numbers "Bumper" p, numbers "Cliff" p, numbers "Wheel" p, numbers "Button" p)
    numbers k p = case fieldOf "channels" (fst (frameLine 0 False p)) of
      Just (Object o) | Just v <- KeyMap.lookup k o, Aeson.Success ns <- Aeson.fromJSON v -> ns :: [Int]
      _ -> []
    fieldOf k l = case Aeson.decode l of Just (Object o) -> KeyMap.lookup k o; _ -> Nothing
    said =
      mapMaybe Aeson.decode ([holdingLine True 0.7 3.14, saidLine 0 "hi", soundLine 0 OnSound, commandsLine 0 ["move"] [] [VelocityCommand (Velocity 0.2 0)] Nothing, commandsLine 0 ["move"] [] [] (Just (False, Aeson.object [])), endedLine 0 "done" Nothing, endedLine 0 "error" (Just (Aeson.object [])), stoppedLine True, fst (frameLine 0 False moved)] ++ map linkLine [IsAwaited unknownReason, IsThere, IsLost (tr "the cable was pulled")])
    moved = applyCommand (Led1Command (Led1 Red)) (applyMessage (OdometryMessage (Odometry (Position 1 2) (Orientation 3) (Velocity 4 5))) blank)

-- | A line's word and the names of its fields.
shape :: Value -> [String]
shape v = case v of
  Object o -> concat [T.unpack t | Just (String t) <- [KeyMap.lookup "op" o]] : sort (map show (KeyMap.keys o))
  _ -> []

-- | All that one side says.
spoken :: String -> IO [Value]
spoken who = do
  names <- listDirectory folder
  texts <- mapM (C.readFile . (folder ++)) names
  pure [l | text <- texts, bytes <- C.lines text, Just (Object o) <- [Aeson.decodeStrict' bytes], KeyMap.lookup "from" o == Just (String (T.pack who)), Just l <- [KeyMap.lookup "line" o]]
  where
    folder = "protocol/goldens/holder/"
