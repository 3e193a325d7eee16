-- |
-- Description : A drive as the base's sensors saw it.
module Test.Robots.Recorded (recorded, isTold, starting, timeOf, ticksAt, odometryJson) where

import qualified Data.ByteString as B
import Rosy.Channel (Channel (..), Kind (..), Message (..))
import Rosy.Kobuki.Feedback (Core (..), Inertia (..))
import Rosy.Kobuki.Sensing
import Rosy.Robot
import Test.Robots.Kobuki (corePacket, senseCore)

-- | Four seconds of a drive: two straight on, faster and faster, then a quarter turn to the left and a little back; on the way bumps, a
-- hole, a wheel in the air and buttons. Counters wrap.
recorded :: [(B.ByteString, [Message])]
recorded = go unsensed [0 .. 199 :: Int]
  where
    go s is = case is of
      [] -> []
      i : rest -> let (ms, s') = senseCore (core i) (Just (inertia i)) s in (corePacket (core i) (inertia i), filter isTold ms) : go s' rest
    core i =
      Core
        { timeStamp = fromIntegral (63000 + 20 * i),
          bumpers = if within' i [(20, 28), (31, 33)] then 4 else if within' i [(44, 47)] then 3 else 0,
          wheelDrops = if within' i [(80, 86)] then 2 else 0,
          cliffs = if within' i [(60, 64), (150, 155)] then 2 else 0,
          leftEncoder = ticks (\d turn -> d - turn * 0.115) i,
          rightEncoder = ticks (\d turn -> d + turn * 0.115) i,
          buttons = if within' i [(95, 98)] then 1 else if within' i [(110, 112)] then 4 else if within' i [(160, 165)] then 2 else 0
        }
    inertia i = Inertia (fromIntegral (hundredths (turned i))) (fromIntegral (50 * (hundredths (turned (i + 1)) - hundredths (turned i))))
    within' i = any (\(a, b) -> a <= i && i < b)
    hundredths a = round (a * 18000 / pi) :: Int
    ticks side i = fromIntegral (round (65000 + side (gone i) (turned i) / metresPerTick :: Double) :: Int)
    -- Metres and radians from the start.
    gone i = if i < 100 then 0.000055 * sq i else 0.55 - 0.001 * fromIntegral (max 0 (i - 185)) :: Double
    turned i = if i < 100 then 0 else 0.0185 * fromIntegral (min 185 i - 100) :: Double
    sq i = fromIntegral (i * i)

-- | Whether every link tells it; the states that only packets have are left out.
isTold :: Message -> Bool
isTold (Message c _) = channelKind c /= StateChannel

-- | How long a step is, seconds, and from how many to the next tick (protocol/README.md).
timeOf :: Int -> Double
timeOf n = fromIntegral n / 50

ticksAt :: Int -> Bool
ticksAt n = n `mod` 5 == 0

-- | All that the program's odometry is made of.
odometryJson :: Odometry -> String
odometryJson (Odometry (Position x y) (Orientation a) (Velocity v w)) =
  ("{\"pose\": {\"pose\": {\"position\": {\"x\": " ++ show x ++ ", \"y\": " ++ show y ++ ", \"z\": 0.0}, ")
    ++ ("\"orientation\": {\"x\": 0.0, \"y\": 0.0, \"z\": " ++ show (sin (a / 2)) ++ ", \"w\": " ++ show (cos (a / 2)) ++ "}}}, ")
    ++ ("\"twist\": {\"twist\": {\"linear\": {\"x\": " ++ show v ++ ", \"y\": 0.0, \"z\": 0.0}, \"angular\": {\"x\": 0.0, \"y\": 0.0, \"z\": " ++ show w ++ "}}}}")

-- | The base is there.
starting :: [[Message]] -> [[Message]]
starting steps = case steps of
  ms : rest -> (RobotStatusMessage Online : ms) : rest
  [] -> []
