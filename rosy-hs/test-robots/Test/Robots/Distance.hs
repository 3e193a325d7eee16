{-# LANGUAGE DataKinds #-}
{-# LANGUAGE OverloadedStrings #-}
{-# LANGUAGE PatternSynonyms #-}

-- |
-- Module      : Test.Robots.Distance
-- Description : Laser scans of robots on their way to a program: from a rosbridge server and from ROS 1, over the robot link.
module Test.Robots.Distance (tests) where

import Data.Aeson (Value (..), object, (.=))
import qualified Data.Aeson as Aeson
import qualified Data.Aeson.Key as Key
import qualified Data.Aeson.KeyMap as KeyMap
import qualified Data.ByteString.Builder as Builder
import qualified Data.ByteString.Char8 as C
import qualified Data.ByteString.Lazy as L
import Data.Either (fromRight, isLeft)
import Data.Foldable (toList)
import Data.List (intercalate, mapAccumL)
import Data.Maybe (catMaybes)
import qualified Data.Text as T
import Data.Tuple (swap)
import Ros.Message (DecodeError, decode, encode)
import Rosy.Channel (Message, tellMessage)
import Rosy.Codec (readMessages, routes)
import Rosy.JsonNumber (doubleValue)
import Rosy.Profile (Robot (..))
import Rosy.Robot.Known (robots)
import Rosy.Robots.DynamicMessage (DynamicMessage (..))
import Rosy.Robots.JsonOfServers (readJson)
import Rosy.Robots.PipeCodec (batchLines, noQuestions)
import Rosy.Robots.RosbridgeCodec (Frame (..), decodeFrame)
import Rosy.Robots.UnreadableMessages
import Rosy.Sentence (english)
import Rosy.Topic (pattern OpenMessage)
import qualified Rosy.Topic as Topic
import qualified Rosy.Wire as Wire
import Test.Tasty (TestTree, testGroup)
import Test.Tasty.HUnit
import Test.Tasty.QuickCheck

tests :: TestTree
tests =
  testGroup
    "distances"
    [ testCase "of a TurtleBot 3 behind a rosbridge server reach the program" $
        -- 0, as its driver writes, and null, as servers write infinity, are beams that meet nothing.
        heard (frameMessages . decodeFrame turtlebot [] $ "{\"op\":\"publish\",\"topic\":\"/scan\",\"msg\":{\"header\":{},\"angle_min\":0,\"angle_max\":3,\"angle_increment\":1,\"time_increment\":0,\"scan_time\":0.2,\"range_min\":0.125,\"range_max\":3.5,\"ranges\":[0.75,0.0,null,0.5],\"intensities\":[]}}")
          @?= ["Ahead 0.75", "Scan 0.0 1.0 0.125 3.5 [0.75,3.5,3.5,0.5]"],
      testCase "of a scanner on a Kobuki, in the bytes of ROS 1, reach the program" $ do
        let bytes = encode (DynamicMessage scan :: DynamicMessage "sensor_msgs/LaserScan")
        case decode bytes :: Either DecodeError (DynamicMessage "sensor_msgs/LaserScan") of
          Left e -> assertFailure (show e)
          Right (DynamicMessage message) -> fmap heard (readMessages kobuki "/scan" message) @?= Right ["Ahead 0.75", "Scan 0.0 1.0 0.125 3.5 [0.75,3.5,0.5]"],
      testGroup
        "of beams with words for numbers, as rosbridge_suite writes them, and the same in the bytes of ROS 1"
        [ testCase beams $ do
            let ahead = ["Ahead " ++ x | x <- toList nearest]
                readings = map (fromRight (String "?") . readJson . L.fromStrict . C.pack) (words beams)
                bytes = encode (DynamicMessage (withRanges readings) :: DynamicMessage "sensor_msgs/LaserScan")
                ofRos1 = case decode bytes :: Either DecodeError (DynamicMessage "sensor_msgs/LaserScan") of
                  Right (DynamicMessage message) -> heard . fromRight [] $ readMessages kobuki "/scan" message
                  Left e -> [show e]
            heard (frameMessages (decodeFrame turtlebot [] (scanFrame (map (\c -> if c == ' ' then ',' else c) beams)))) @?= ahead ++ ["Scan 0.0 0.125 0.125 3.5 " ++ scanned]
            ofRos1 @?= ahead ++ ["Scan 0.0 0.125 0.125 3.5 " ++ scanned]
          | (beams, nearest, scanned) <-
              [ ("1.0 Infinity", Just "1.0", "[1.0,3.5]"),
                ("Infinity Infinity", Just "3.5", "[3.5,3.5]"),
                -- What is no reading does not say that the way is free.
                ("NaN 0.5", Just "0.5", "[3.5,0.5]"),
                ("NaN NaN", Nothing, "[3.5,3.5]"),
                ("-Infinity 1.0", Just "1.0", "[3.5,1.0]"),
                ("NaN Infinity", Just "3.5", "[3.5,3.5]")
              ]
        ],
      testProperty "JSON with such words for some numbers is what it is with numbers there, and words in texts stay" $ \(Written v) ->
        readJson (L.fromStrict (C.pack (written v))) === Right (meant v),
      testGroup
        "what only looks like such a word is no JSON"
        [testCase text (assertBool text (isLeft (readJson (L.fromStrict (C.pack text))))) | text <- ["[1Infinity]", "[Infinity5]", "[NaNa]", "[+Infinity]", "[-NaN]", "[infinity]", "[nan]", "[NaN", "{NaN: 1}", "[1.Infinity]"]],
      testCase "a message that cannot be read is said once for each topic with its reason, and counted" $ do
        let frames =
              [ "{\"op\":\"publish\",\"topic\":\"/odom\",\"msg\":{\"pose\":{\"pose\":{\"position\":{\"x\":NaN,\"y\":0},\"orientation\":{\"z\":0,\"w\":1}}},\"twist\":{\"twist\":{\"linear\":{\"x\":0},\"angular\":{\"z\":0}}}}}",
                "not JSON",
                "{\"op\":\"publish\",\"topic\":\"/odom\",\"msg\":{}}",
                "{\"op\":\"publish\",\"topic\":\"/scan\",\"msg\":{\"ranges\":1}}",
                "[1]",
                "{\"op\":\"publish\",\"topic\":\"/another\",\"msg\":{}}",
                "{\"op\":\"png\"}"
              ]
            (counts, said) = mapAccumL (\c frame -> maybe (c, Nothing) (swap . (`countUnreadable` c)) (frameUnreadable (decodeFrame turtlebot [] frame))) noneUnreadable frames
        map (takeWhile (/= ':') . T.unpack . english) (catMaybes said)
          @?= ["a message on /odom cannot be read", "a message of its server cannot be read", "a message on /scan cannot be read"]
        map english (unreadableSentences counts)
          @?= ["Messages of the robot's server that could not be read: 2.", "Messages on /odom that could not be read: 2.", "Messages on /scan that could not be read: 1."],
      testCase "a number of a program's own topic may be infinite or none" $
        [ [show (Topic.fromMessage x :: Maybe Double) | OpenMessage _ (Object o) <- frameMessages (decodeFrame turtlebot ["/own"] ("{\"op\":\"publish\",\"topic\":\"/own\",\"msg\":{\"x\":" <> word <> "}}")), Just x <- [KeyMap.lookup "x" o]]
          | word <- ["NaN", "Infinity", "-Infinity", "1.5"]
        ]
          @?= [["Just NaN"], ["Just Infinity"], ["Just (-Infinity)"], ["Just 1.5"]]
    ]
  where
    turtlebot = known "turtlebot3"
    kobuki = known "kobuki"
    known name = concat [routes r variables | r <- robots, robotName r == name, (_, variables) <- take 1 (robotProfiles r)]

-- | A scan with these ranges as a frame.
scanFrame :: String -> L.ByteString
scanFrame ranges = L.fromStrict (C.pack ("{\"op\":\"publish\",\"topic\":\"/scan\",\"msg\":{\"angle_min\":0.0,\"angle_increment\":0.125,\"range_min\":0.125,\"range_max\":3.5,\"ranges\":[" ++ ranges ++ "]}}"))

withRanges :: [Value] -> Value
withRanges ranges = object ["angle_increment" .= (0.125 :: Double), "range_min" .= (0.125 :: Double), "range_max" .= (3.5 :: Double), "ranges" .= ranges]

-- | JSON as it is written, with words for numbers.
newtype Written = Written Piece
  deriving (Show)

data Piece = Word' String Double | Figure Int | Words String | Several [Piece] | Named [Piece]
  deriving (Show)

instance Arbitrary Written where
  arbitrary = Written <$> sized piece
    where
      piece n =
        oneof $
          [elements [Word' "NaN" (0 / 0), Word' "Infinity" (1 / 0), Word' "-Infinity" (-1 / 0)], Figure <$> arbitrary, Words . concat <$> listOf (elements ["NaN", "Infinity", "\"", "\\", ",", "-", ": ", "a"])]
            ++ (if n > 1 then [Several <$> resize (n `div` 3) (listOf (piece (n `div` 3))), Named <$> resize (n `div` 3) (listOf (piece (n `div` 3)))] else [])

written :: Piece -> String
written p = case p of
  Word' w _ -> w
  Figure n -> show n
  Words t -> C.unpack (L.toStrict (Aeson.encode t))
  Several ps -> "[" ++ intercalate ", " (map written ps) ++ "]"
  Named ps -> "{" ++ intercalate "," ["\"NaN\\\"" ++ show i ++ "\":" ++ written q | (i, q) <- zip [0 :: Int ..] ps] ++ "}"

meant :: Piece -> Value
meant p = case p of
  Word' _ x -> doubleValue x
  Figure n -> Aeson.toJSON n
  Words t -> Aeson.toJSON t
  Several ps -> Aeson.toJSON (map meant ps)
  Named ps -> object [Key.fromString ("NaN\"" ++ show i) .= meant q | (i, q) <- zip [0 :: Int ..] ps]

scan :: Value
scan = object ["angle_increment" .= (1 :: Double), "range_min" .= (0.125 :: Double), "range_max" .= (3.5 :: Double), "ranges" .= ([0.75, 0, 0.5] :: [Double])]

-- | What a program hears when these messages are sent to it in a step.
heard :: [Message] -> [String]
heard messages = concat [map tellMessage found | line <- C.lines bytes, Right (Wire.SensorLine found) <- [Wire.readLine line]]
  where
    bytes = L.toStrict (Builder.toLazyByteString (batchLines noQuestions 0 0 messages))
