{-# LANGUAGE DeriveGeneric #-}
{-# OPTIONS_GHC -fno-omit-yields #-}

-- |
-- Description : Programs that the tests drive robots with.
module Test.Robots.Programs (byName, functions, remembering, afterOneAnother) where

import GHC.Generics (Generic)
import Rosy hiding (dice)
import Rosy.Program (Value, commandTopics, sensorTopics, withTopics)

-- | A program by its name on the command line.
byName :: String -> IO ()
byName n = case n of
  "steady" -> simulate steady
  "turns" -> simulate (Velocity 0 1)
  "lights" -> simulate (steady, lights)
  "fails" -> simulate (steady, failing)
  "hangs" -> simulate (steady, hanging)
  "sings" -> simulate (sings, steady)
  "done" -> simulate (task steady pressed)
  "reports" -> reporting
  _ -> errorWithoutStackTrace ("no program is called " ++ n)

-- | Forwards at the default rate.
steady :: Velocity
steady = Velocity 0.2 0

-- | With a sensor and two commands of its own (rule R23).
reporting :: IO ()
reporting =
  withTopics
    [sensorTopics (sensor :: Sense Charge), commandTopics (command :: Plan Buzz), commandTopics (command :: Plan Report)]
    (simulate warn)

newtype Charge = Charge Int
  deriving (Generic)

instance Value Charge

instance Sensor Charge where
  sensor = topic "/dock/core" "kobuki_msgs/SensorState" (Charge <$> field "battery")

data Buzz = Buzz

instance Command Buzz where
  command = publish "/mobile_base/commands/sound" "kobuki_msgs/Sound" (\Buzz -> [("value", whole 3)])

data Report = Report Double Int

instance Command Report where
  command = publish "/report" "geometry_msgs/Twist" (\(Report x n) -> [("linear", record [("x", decimal x), ("y", whole n)])])

warn :: Charge -> Memory Int -> (Memory Int, Maybe Buzz, Report)
warn (Charge level) (Memory n) = (Memory (n + 1), if level < 130 then Just Buzz else Nothing, Report (fromIntegral level + 0.5) n)

failing :: Bumper -> Led1
failing _ = error "the bumper broke me"

hanging :: Bumper -> Led1
hanging = hanging

-- | Once, as soon as it knows where it is.
sings :: Velocity -> Memory Bool -> Maybe (Memory Bool, Sound)
sings _ (Memory sung)
  | sung = Nothing
  | otherwise = Just (Memory True, CleaningStartSound)

pressed :: Bumper -> Done ()
pressed _ = Done ()

-- ---------------------------------------------------------------------------------------------
-- From what the robot senses to what it should do

functions :: IO ()
functions = simulate (lights, sounds, follow, looks)

-- | A command for every odometry message: faster than now.
follow :: Velocity -> Position -> Velocity
follow (Velocity v w) (Position x _) = Velocity (v + 0.125) (w / 2 + x / 8)

lights :: Bumper -> Led1
lights (Bumper _ Pressed) = Led1 Red
lights (Bumper _ Released) = Led1 Black

sounds :: Either Cliff Button -> Maybe Sound
sounds e = case e of
  Left (Cliff _ Hole) -> Just ErrorSound
  Right (Button Button0 Pressed) -> Just OnSound
  _ -> Nothing

looks :: WheelLeft -> Orientation -> (Led2, Say)
looks (WheelLeft Air) here = (Led2 Green, Say (show (round (orientationToDegrees here) :: Int)))
looks (WheelLeft Ground) _ = (Led2 Black, Say "down")

-- ---------------------------------------------------------------------------------------------
-- Memory, events of its own, chance and time

-- | How often it was hurt.
newtype Hurt = Hurt Int deriving (Generic)

instance Value Hurt

instance Sensor Hurt

instance Command Hurt

remembering :: IO ()
remembering = simulate (count, cry, dice, hour, dance, here')

count :: Bumper -> Memory Int -> Maybe (Memory Int, Hurt)
count (Bumper _ Pressed) (Memory n) = Just (Memory (n + 1), Hurt (n + 1))
count _ _ = Nothing

cry :: Hurt -> Seconds -> (Led1, Param Int, Say)
cry (Hurt n) now = (Led1 (if odd n then Orange else Green), Param (10 * n), Say (show n ++ " at " ++ show (secondsToDouble now)))

dice :: Either Button Cliff -> StdGen -> Param Int -> (Say, Led2)
dice _ chance (Param n) = let (thrown, _) = randomR (1, 6) chance in (Say (show (n + thrown)), Led2 (toEnum (thrown `mod` 4)))

hour :: ButtonTwo -> Clock -> Say
hour _ (Clock h m s _) = Say (show (h, m, s))

-- | Ten times a second.
dance :: () -> StdGen -> Seconds -> Velocity
dance () chance now = Velocity (fst (randomR (-0.3, 0.3) chance)) (sin (secondsToDouble now))

here' :: RobotStatus -> Sound
here' s = if s == Online then CleaningStartSound else OffSound

-- ---------------------------------------------------------------------------------------------
-- One thing after another

afterOneAnother :: IO ()
afterOneAnother = simulate $ do
  say "go"
  task (Velocity 0.1 0) pressed
  wait 0.3
  (side, turned) <- parallel (task () whichSide) (task startHeading turning)
  say (show side ++ (if turned then " turned" else ""))
  first <- race (wait 0.2 >> pure 'w') (task () (\(Cliff _ _) -> Done 'c'))
  say (show first)
  replicateM_ 2 (task (Led2 Orange) (taskOfButtons, helper))
  taskWith taskOptions {stopped = (Led1 Red, OffSound)} circling :: Task ()

whichSide :: Bumper -> Done BumperSide
whichSide (Bumper side _) = Done side

startHeading :: Orientation -> Memory Orientation
startHeading = Memory

turning :: Memory Orientation -> Orientation -> Either Velocity (Done Bool)
turning (Memory start) now
  | normOrientation (now - start) < 0.4 = Left (Velocity 0 0.5)
  | otherwise = Right (Done True)

taskOfButtons :: Button -> Done ()
taskOfButtons (Button _ _) = Done ()

-- | Calls a task that says how far it is, until a wheel hangs.
helper :: CliffCenter -> Call
helper _ =
  call
    (task (Led1 Green) (\(Position x _) -> if x > 0.3 then Right (Done x) else Left (Feedback x)))
    callOptions {cancelOn = \(WheelLeft _) -> Just Cancel, onFeedback = (`Velocity` 0), onEnd = \x -> Say (show (round (100 * x :: Double) :: Int))}

circling :: Pose -> Velocity
circling (Pose _ heading) = Velocity 0.1 (orientationToDegrees heading / 360)
