-- |
-- Description : Messages as bytes.
module Test.Ros.Messages (tests) where

import qualified Data.ByteString as B
import Data.Either (isLeft)
import Data.Proxy (Proxy (..))
import qualified Data.Vector.Storable as V
import Ros.Geometry_msgs.PoseWithCovariance (PoseWithCovariance (..))
import Ros.Geometry_msgs.Twist (Twist, angular, linear)
import qualified Ros.Geometry_msgs.Vector3 as Vector3
import Ros.Header (HasHeader (..), frameOf, stampOf)
import Ros.Kobuki_msgs.BumperEvent (BumperEvent (..))
import Ros.Kobuki_msgs.CliffEvent (CliffEvent (..))
import Ros.Kobuki_msgs.DigitalOutput (DigitalOutput (..))
import Ros.Kobuki_msgs.DockInfraRed (DockInfraRed (..))
import Ros.Kobuki_msgs.Led (Led (..))
import Ros.Kobuki_msgs.SensorState (SensorState)
import qualified Ros.Kobuki_msgs.SensorState as SensorState
import Ros.Kobuki_msgs.VersionInfo (VersionInfo (..))
import Ros.Lens
import Ros.Message
import Ros.Nav_msgs.Odometry (Odometry)
import qualified Ros.Nav_msgs.Odometry as Odometry
import Ros.Sensor_msgs.JointState (JointState (..))
import qualified Ros.Std_msgs.Header as Header
import qualified Ros.Std_msgs.String as Ros
import Test.Tasty
import Test.Tasty.HUnit
import Test.Tasty.QuickCheck

tests :: TestTree
tests =
  testGroup
    "messages"
    [ testGroup
        "are as long on the wire as rospy makes them"
        [ testCase "Twist" $ size (def :: Twist) @?= 48,
          testCase "BumperEvent" $ size (def :: BumperEvent) @?= 2,
          testCase "CliffEvent" $ size (def :: CliffEvent) @?= 4,
          testCase "Led" $ size (def :: Led) @?= 1,
          testCase "DigitalOutput" $ size (def :: DigitalOutput) @?= 8,
          testCase "SensorState" $ size (def {SensorState._bottom = V.replicate 3 0, SensorState._current = V.replicate 2 0, SensorState._analog_input = V.replicate 4 0} :: SensorState) @?= 61,
          testCase "DockInfraRed" $ size (DockInfraRed def (V.replicate 3 0)) @?= 23,
          testCase "Odometry" $ size odometry @?= 718
        ],
      testCase "are packed and little-endian" $
        encode (CliffEvent 2 1 0x0304) @?= B.pack [2, 1, 4, 3],
      testCase "carry the length of a string and of an array, not of a fixed array" $ do
        encode (Ros.String "h\233") @?= B.pack [3, 0, 0, 0, 104, 0xc3, 0xa9]
        encode (DigitalOutput (V.fromList [True, False, True, False]) (V.replicate 4 True)) @?= B.pack [1, 0, 1, 0, 1, 1, 1, 1],
      testCase "a fixed array that is too short is filled, one that is too long is cut" $ do
        size (PoseWithCovariance def V.empty) @?= size (def :: PoseWithCovariance)
        size (PoseWithCovariance def (V.replicate 99 1)) @?= size (def :: PoseWithCovariance),
      testCase "a count of four billion fails and allocates nothing" $ do
        assertBool "numbers" (isLeft (decode (B.replicate 15 0 <> B.replicate 20 255) :: Either DecodeError SensorState))
        assertBool "strings" (isLeft (decode (B.replicate 16 0 <> B.replicate 20 255) :: Either DecodeError JointState)),
      testCase "bytes that are left over are no message" $
        (decode (B.pack [1, 1, 1]) :: Either DecodeError BumperEvent) @?= Left (LeftOver 1),
      testCase "know their header" $ do
        frameOf odometry @?= "odom"
        stampOf (numbered 7 odometry) @?= (5, 6)
        (numbered 7 odometry ^. headerOf . Header.seq) @?= 7
        messageType (Proxy :: Proxy Odometry) @?= "nav_msgs/Odometry",
      testCase "fields are read and changed from far away" $ do
        let t = def & linear . Vector3.x .~ 0.5 & angular . Vector3.z %~ subtract 1 :: Twist
        (t ^. linear . Vector3.x, t ^. angular . Vector3.z) @?= (0.5, -1),
      testProperty "come back as they went: CliffEvent" $ \a b c -> roundTrip (CliffEvent a b c),
      testProperty "come back as they went: VersionInfo" $ \a b c d e -> roundTrip (VersionInfo (clean a) (clean b) (clean c) (V.fromList d) e),
      testProperty "come back as they went: JointState" $ \names ps vs es ->
        roundTrip (JointState def (map clean names) (V.fromList ps) (V.fromList vs) (V.fromList es)),
      testProperty "cut anywhere, they are no message" $ \n ->
        let bytes = encode odometry
            cut = B.take (n `mod` B.length bytes) bytes
         in isLeft (decode cut :: Either DecodeError Odometry),
      testProperty "times are kept to a nanosecond" $ \(NonNegative ms) ->
        let t = fromIntegral (ms :: Int) / 1000 :: Double
         in abs (toSeconds (fromSeconds t) - t) < 1e-6,
      testProperty "nanoseconds stay under a second" $ \(NonNegative t) ->
        snd (fromSeconds t) < 1000000000
    ]
  where
    size :: RosBinary a => a -> Int
    size = B.length . encode
    odometry :: Odometry
    odometry = def & Odometry.header .~ Header.Header 1 (5, 6) "odom" & Odometry.child_frame_id .~ "base_footprint"
    roundTrip :: (RosBinary a, Eq a, Show a) => a -> Property
    roundTrip x = decode (encode x) === Right x
    -- Half a surrogate pair is no character, so it cannot be written as UTF-8.
    clean = filter (\c -> c < '\xd800' || c > '\xdfff')
