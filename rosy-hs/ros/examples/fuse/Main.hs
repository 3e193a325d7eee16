-- |
-- Description : Fuses odometry and laser range into a speed that slows down before walls.
--
-- > ros-fuse odom:=/odom scan:=/scan cmd_vel:=/mobile_base/commands/velocity _top_speed:=0.3
--
-- Whenever both sensors have said something new, the free way ahead decides how fast the robot should
-- go, and the speed moves from what odometry says towards that; ten times a second at most.
module Main (main) where

import qualified Data.Vector.Storable as V
import Ros.Geometry_msgs.Twist (Twist, linear)
import qualified Ros.Geometry_msgs.TwistWithCovariance as Covariance
import qualified Ros.Geometry_msgs.Vector3 as Vector3
import Ros.Lens
import Ros.Message (def)
import Ros.Nav_msgs.Odometry (Odometry)
import qualified Ros.Nav_msgs.Odometry as Odometry
import Ros.Node
import Ros.Sensor_msgs.LaserScan (LaserScan, ranges)
import Ros.Topic.Util (bothNew, topicRate)

main :: IO ()
main = runNode "fuse" $ do
  topSpeed <- getParam "~top_speed" 0.3
  odometry <- subscribeBuffered 1 "odom"
  scans <- subscribeBuffered 1 "scan"
  advertise "cmd_vel" (topicRate 10 (fmap (uncurry (drive topSpeed)) (bothNew odometry scans)))

-- | Half a metre per second for each free metre, up to the top speed; half of the change at a time.
drive :: Double -> Odometry -> LaserScan -> Twist
drive topSpeed odometry scan = def & linear . Vector3.x .~ (now + wanted) / 2
  where
    now = odometry ^. Odometry.twist . Covariance.twist . linear . Vector3.x
    wanted = min topSpeed (0.5 * max 0 (free scan - stopAt))

-- | The nearest thing that the scanner sees, metres.
free :: LaserScan -> Double
free scan = realToFrac (V.foldl' min 10 (V.filter (> 0) (scan ^. ranges)))

-- | Metres from the scanner at which to stand still: a Kobuki's radius and a hand.
stopAt :: Double
stopAt = 0.3
