-- |
-- Description : The paper's account of controllers over roshask topics, against this client.
--
-- The classes are those of the paper; the only change is @advertise@ for its @publish@. A controller of a function pairs a topic of
-- functions with a topic of inputs.
module Test.Ros.Listings (tests) where

import qualified Ros.Geometry_msgs.Twist as Twist
import qualified Ros.Geometry_msgs.Vector3 as Vector3
import Ros.Kobuki_msgs.BumperEvent (BumperEvent)
import qualified Ros.Kobuki_msgs.BumperEvent as BumperEvent
import qualified Ros.Kobuki_msgs.Sound as Sound
import Ros.Message (def)
import Ros.Node
import Ros.Topic (Topic)
import qualified Ros.Topic as Topic
import Ros.Topic.Util (bothNew, topicRate)
import Test.Tasty
import Test.Tasty.HUnit

-- | What a robot senses.
class Sensor a where
  sensor :: Node (Topic IO a)

-- | What a robot is told.
class Command a where
  command :: Topic IO a -> Node ()

-- | What a robot is told as a function of what it senses.
class Controller c where
  controller :: Topic IO c -> Node ()

instance (Sensor a, Controller b) => Controller (a -> b) where
  controller functions = sensor >>= controller . applied functions

-- | Functions and inputs, each used once.
applied :: Topic IO (a -> b) -> Topic IO a -> Topic IO b
applied functions inputs = uncurry ($) <$> bothNew functions inputs

instance Sensor BumperEvent where sensor = subscribe "/mobile_base/events/bumper"

instance Command Twist.Twist where command = advertise "/mobile_base/commands/velocity"

instance Command Sound.Sound where command = advertise "/mobile_base/commands/sound"

instance Command a => Command (Maybe a) where command = command . Topic.catMaybes

newtype Always a = Always a

instance Command a => Controller (Always a) where
  controller = command . fmap (\(Always x) -> x)

-- | Ten times a second.
simulate :: Controller c => c -> IO ()
simulate c = runNode "controller" (controller (topicRate 10 (Topic.repeat c)))

move :: Always Twist.Twist
move = Always def {Twist._linear = def {Vector3._x = 0.5}}

play :: BumperEvent -> Always (Maybe Sound.Sound)
play event = Always (if BumperEvent._state event == BumperEvent.pressed then Just def {Sound._value = Sound.error} else Nothing)

tests :: TestTree
tests =
  testGroup
    "the paper's listings"
    [ testCase "controllers of each form are programs" $ length [simulate move, simulate play] @?= 2,
      testCase "a function is applied to what its topic brings" $
        Topic.take 3 (applied (Topic.repeat (+ 1)) (Topic.repeat (10 :: Int))) >>= (@?= [11, 11, 11])
    ]
