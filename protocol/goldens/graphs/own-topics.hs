-- Sensors and commands of the program's own. A robot event has the name of the first, too.
newtype Battery = Battery Int

instance Sensor Battery where
  sensor = topic "/mobile_base/sensors/core" "kobuki_msgs/SensorState" (Battery <$> field "battery")

data Place = Place Double Double

instance Sensor Place where
  sensor = located "geometry_msgs/Point"

-- | The name consists of two texts.
located kind = topic (room ++ "/place") kind (Place <$> field "x" <*> field "y")

room = "kitchen"

newtype Level = Level Double

instance Sensor Level where
  sensor = topic ('/' : show 7) "std_msgs/Float64" $ Level <$> field "data"

newtype Buzz = Buzz Int

instance Command Buzz where
  command = publish "/mobile_base/commands/sound" "kobuki_msgs/Sound" (\(Buzz n) -> [("value", whole n)])

-- Arrives from a topic, and goes to another one.
newtype Lamp = Lamp Bool

instance Sensor Lamp where
  sensor = topic "/lamp/state" "std_msgs/Bool" (Lamp <$> field "data")

instance Command Lamp where
  command = publish "/lamp/set" "std_msgs/Bool" (\(Lamp on) -> [("data", truth on)])

-- Received from a topic only: it goes from function to function, and comes from the topic as well.
newtype Heat = Heat Double

instance Sensor Heat where
  sensor = topic "/heat" "std_msgs/Float64" (Heat <$> field "data")

warn :: Either Battery Bumper -> Maybe Buzz
warn (Left (Battery n)) | n < 120 = Just (Buzz 3)
warn (Right _) = Just (Buzz 4)
warn _ = Nothing

follow :: Place -> Level -> Lamp
follow (Place x _) (Level l) = Lamp (x > l)

toggle :: Lamp -> (Lamp, Velocity)
toggle (Lamp on) = (Lamp (not on), Velocity 0 0)

cool :: Heat -> Maybe Velocity
cool (Heat h) =
  if h > 30 then Just (Velocity 0 0) else Nothing

main = simulate (warn, follow, toggle, cool)
