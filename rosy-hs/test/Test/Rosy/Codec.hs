-- |
-- Module      : Test.Rosy.Codec
-- Description : The messages of every channel of every robot, there and back.
module Test.Rosy.Codec (tests) where

import qualified Data.Aeson as Aeson
import Data.Aeson.Encoding (double, encodingToLazyByteString)
import qualified Data.ByteString.Lazy.Char8 as Lazy
import Data.Maybe (isJust)
import qualified Data.Text as Text
import Rosy.Channel
import Rosy.Codec
import Rosy.Core (channelLimit)
import Rosy.Profile
import Rosy.Robot.Known (robots)
import Test.QuickCheck
import Test.Tasty (TestTree, testGroup)
import Test.Tasty.HUnit
import Test.Tasty.QuickCheck (testProperty)

tests :: TestTree
tests =
  testGroup
    "Codec"
    [ testGroup
        "reads what it has written"
        [ testProperty (robotName robot ++ ", " ++ profile ++ ", " ++ channelName (routeChannel route)) $
            forAll (fieldsOf (mappingPlaces mapping) (routeChannel route)) $ \fields ->
              fmap (decoded route) (Aeson.decode (encodingToLazyByteString (encode route (together route fields)))) === Just (Right [fields])
          | robot <- robots,
            (profile, variables) <- robotProfiles robot,
            (mapping, route) <- zip (robotMappings robot) (routes robot variables),
            not (routeHasLevels route)
        ],
      testProperty "writes a number as aeson does, to the last byte" $
        forAll (oneof [arbitrary, choose (-20, 20), elements [0, -0.0, 0.1, 1e7, 1e-2, 1 / 0, -1 / 0, 0 / 0], (\n -> fromIntegral (n :: Int) / 1000) <$> arbitrary]) $ \x ->
          encodingToLazyByteString (encodeFields [At [Key (Text.pack "x")] (ANumber 1)] [] [Number x]) === Lazy.concat [Lazy.pack "{\"x\":", encodingToLazyByteString (double x), Lazy.pack "}"],
      testCase "leaves no variable in a topic or a type" $
        [t | robot <- robots, (_, variables) <- robotProfiles robot, route <- routes robot variables, t <- [routeTopic route, routeType route], Text.any (`elem` "{}") t] @?= [],
      testCase "reads every channel of a topic that has several, and those whose fields are there" $ do
        let known = [r | robot <- take 1 robots, (_, variables) <- take 1 (robotProfiles robot), r <- routes robot variables]
            readCore = fmap (map tellMessage) . readMessages known (Text.pack "/mobile_base/sensors/core")
            field = Aeson.decode . Lazy.pack :: String -> Maybe Aeson.Value
        fmap readCore (field "{\"battery\": 164, \"charger\": 6, \"analog_input\": [0, 4095, 0, 0]}") @?= Just (Right ["Battery 16.4", "DockingCharging", "AnalogInput 0.0 3.3 0.0 0.0"])
        fmap readCore (field "{\"battery\": 164, \"charger\": 7}") @?= Just (Right ["Battery 16.4"])
        fmap readCore (field "{}") @?= Just (Left "\"battery\" is missing"),
      testCase "has room for every channel among the interests" $
        [c | c <- sensed, channelNumber c >= channelLimit] @?= [],
      testCase "gives every channel a number of its own" $
        [(a, b) | (i, a) <- zip [0 :: Int ..] everything, (j, b) <- zip [0 ..] everything, i < j, channelNumber a == channelNumber b, channelName a /= channelName b] @?= []
    ]
  where
    -- With the other commands in its message as they are at first.
    together route fields = case routeShared route of
      [] -> fields
      shared -> concat [if c == routeChannel route then fields else atFirst | (c, atFirst) <- shared]
    everything = concatMap (map mappingChannel . robotMappings) robots
    sensed = filter ((/= CommandChannel) . channelKind) everything

-- | Fields that a message of the channel can have.
fieldsOf :: [Place] -> Channel -> Gen [Field]
fieldsOf places c
  | hasRanges = do
    (first, step, nearest) <- (,,) <$> arbitrary <*> arbitrary <*> choose (0, 1)
    farthest <- choose (1, 10)
    distances <- listOf (choose (nearest, farthest))
    pure (map Number (first : step : nearest : farthest : distances))
  | otherwise = mapM place places `suchThat` (isJust . channelShow c)
  where
    hasRanges = not (null [() | ScanRanges <- places])
    place p = case p of
      NearestAhead _ -> Number . abs <$> arbitrary
      -- Its fields are made above.
      ScanRanges -> Number <$> arbitrary
      Yaw _ -> Number <$> elements [0, 0.5, -0.25, 3]
      At _ leaf -> fieldOf leaf
      AtAll _ leaf -> fieldOf leaf
    fieldOf leaf = case leaf of
      -- What is scaled is a whole number in the message.
      ANumber factor | factor /= 1 -> (\n -> Number (scaled factor (fromIntegral (n :: Int)))) <$> choose (0, 255)
      ANumber _ -> Number <$> arbitrary
      AWhole -> Whole <$> choose (0, 8)
      ATruth -> Whole <$> choose (0, 1)
      AText -> Text . filter (\x -> x < '\xD800' || x > '\xDFFF') <$> arbitrary
      ABit _ -> Whole <$> choose (0, 1)
      TheFirstOf flags -> Whole <$> elements (0 : flags)
      -- What several choices are in the message is read as the first of them.
      ACode codes -> Whole <$> elements [n | (i, (n, v)) <- zip [0 ..] codes, v `notElem` map snd (take i codes)]
