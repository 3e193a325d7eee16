-- |
-- Module      : Rosy.Link.Ros
-- Description : A robot on ROS 1.
--
-- In: where the master is and what the base's topics are called. Out: a 'Base' while an action runs: the program is
-- a ROS node called @/rosy@. The robot is there when its odometry arrives and it listens to what it is told, and lost when
-- nobody publishes odometry any more or it has been silent for a second. A newer node of the same name takes the robot over.
module Rosy.Link.Ros
  ( withRos,
  )
where

import Control.Concurrent (threadDelay)
import Control.Concurrent.Async (withAsync)
import Control.Concurrent.STM
import Control.Monad (unless, when)
import Data.Maybe (isNothing)
import qualified Ros.Geometry_msgs.Point as Point
import qualified Ros.Geometry_msgs.Pose as Pose
import qualified Ros.Geometry_msgs.PoseWithCovariance as PoseWithCovariance
import qualified Ros.Geometry_msgs.Quaternion as Quaternion
import Ros.Geometry_msgs.Twist (Twist, angular, linear)
import qualified Ros.Geometry_msgs.TwistWithCovariance as TwistWithCovariance
import qualified Ros.Geometry_msgs.Vector3 as Vector3
import qualified Ros.Kobuki_msgs.BumperEvent as BumperEvent
import qualified Ros.Kobuki_msgs.ButtonEvent as ButtonEvent
import qualified Ros.Kobuki_msgs.CliffEvent as CliffEvent
import Ros.Kobuki_msgs.Led (Led (..))
import qualified Ros.Kobuki_msgs.RobotStateEvent as RobotStateEvent
import qualified Ros.Kobuki_msgs.Sound as Sound
import qualified Ros.Kobuki_msgs.WheelDropEvent as WheelDropEvent
import Ros.Lens
import Ros.Message (def)
import qualified Ros.Message as Ros
import qualified Ros.Nav_msgs.Odometry as Odometry
import qualified Ros.Net.Master as Master
import Ros.Node
import Ros.Node.Core (master)
import qualified Ros.Std_msgs.String as Ros
import Rosy.Core (Action (..), Message (..), Odometry (..))
import Rosy.Robot
import Rosy.Robots.Base
import Rosy.Robots.Target (Profile (..))

withRos :: Settings -> String -> Profile -> (Base -> IO a) -> IO a
withRos settings name p use = withNodeIn settings "rosy" $ do
  hearing <- liftIO newHearing
  count <- liftIO (newTVarIO (0 :: Int))
  present <- liftIO (newTVarIO False)
  let events :: Ros.Message a => String -> (a -> Maybe Message) -> Node ()
      events topic understood = do
        arriving <- subscribe (prefix p ++ "/events/" ++ topic)
        runHandler_ (mapM_ (atomically . heard hearing . Heard) . understood) arriving
      arrives listening o = do
        there <- readTVarIO present
        unless there listening
        atomically $ do
          known <- swapTVar present True
          unless known (heard hearing Here)
          modifyTVar' count (+ 1)
          heard hearing (Heard (OdometryMessage (odometryFrom o)))
  events "button" (\(ButtonEvent.ButtonEvent n s) -> fmap ButtonMessage (Button <$> nth n <*> nth' [Released, Pressed] s))
  events "bumper" (\(BumperEvent.BumperEvent n s) -> fmap BumperMessage (Bumper <$> nth n <*> nth' [Released, Pressed] s))
  events "cliff" (\(CliffEvent.CliffEvent n s _) -> fmap CliffMessage (Cliff <$> nth n <*> nth' [Floor, Hole] s))
  events "wheel_drop" (\(WheelDropEvent.WheelDropEvent n s) -> fmap WheelMessage (Wheel <$> nth n <*> nth' [Ground, Air] s))
  events "robot_state" (\(RobotStateEvent.RobotStateEvent s) -> StatusMessage <$> nth' [Offline, Online] s)
  odometry <- subscribe (odometryTopic p)
  velocity <- publisher (velocityTopic p)
  led1 <- publisherWith kept (prefix p ++ "/commands/led1")
  led2 <- publisherWith kept (prefix p ++ "/commands/led2")
  sound <- publisher (prefix p ++ "/commands/sound")
  said <- publisher "/rosy/say"
  -- The first sound of a program would be lost on a base whose odometry comes a moment before it has connected to ours.
  nodeIO (\run -> run (runHandler_ (arrives (run (awaitListeners silence))) odometry))
  let base =
        Base
          { baseName = name,
            tell = \case
              SetVelocity v w -> publish velocity (def & linear . Vector3.x .~ v & angular . Vector3.z .~ w :: Twist)
              SetLed1 c -> publish led1 (Led (fromIntegral (fromEnum c)))
              SetLed2 c -> publish led2 (Led (fromIntegral (fromEnum c)))
              PlaySound s -> publish sound (Sound.Sound (fromIntegral (fromEnum s)))
              SayText s -> publish said (Ros.String s),
            hear = hearAll hearing
          }
      -- Only a robot that was there can fall silent.
      watch = do
        atomically (readTVar present >>= check)
        before <- readTVarIO count
        came <- patiently silence (atomically (readTVar count >>= check . (/= before)))
        when (isNothing came) . atomically $ do
          writeTVar present False
          heard hearing (Gone "nothing was heard of it for a second")
        watch
  core <- askCore
  let -- Until the robot is there: what it waits for.
      advise told = do
        threadDelay silence
        there <- readTVarIO present
        answer <- if there then pure Nothing else Just <$> Master.hasParam (master core) "/run_id"
        let why = case answer of
              Nothing -> ""
              Just (Left _) -> "no ROS master answers; does roscore run there?"
              Just (Right _) -> "the ROS master answers and nobody tells it odometry as " ++ odometryTopic p ++ "; does the base's own program run?"
        when (why /= told && not (null why)) (atomically (heard hearing (Gone why)))
        advise why
  nodeIO $ \run ->
    withAsync watch $ \_ -> withAsync (advise "") $ \_ ->
      withAsync (run awaitEnd >>= atomically . heard hearing . Gone . because) (const (use base))
  where
    kept = publisherOptions {latched = True}
    because why = case why of
      AskedTo reason -> reason
      _ -> "this node ended"

-- | Nothing heard for so long means that the robot is lost, microseconds: fifty odometry messages are missing.
silence :: Int
silence = 1000000

-- | A side or a button by its number in kobuki_msgs.
nth :: (Enum a, Bounded a, Integral n) => n -> Maybe a
nth = nth' [minBound ..]

-- | None when the base says a number that has no meaning.
nth' :: Integral n => [a] -> n -> Maybe a
nth' values n = case drop (fromIntegral n) values of
  v : _ -> Just v
  [] -> Nothing

odometryFrom :: Odometry.Odometry -> Odometry
odometryFrom o =
  Odometry
    (Position (at ^. Pose.position . Point.x) (at ^. Pose.position . Point.y))
    (Orientation (wrapped (2 * atan2 (at ^. Pose.orientation . Quaternion.z) (at ^. Pose.orientation . Quaternion.w))))
    (Velocity (moving ^. linear . Vector3.x) (moving ^. angular . Vector3.z))
  where
    at = o ^. Odometry.pose . PoseWithCovariance.pose
    moving = o ^. Odometry.twist . TwistWithCovariance.twist
    wrapped a
      | a > pi = a - 2 * pi
      | a <= negate pi = a + 2 * pi
      | otherwise = a
