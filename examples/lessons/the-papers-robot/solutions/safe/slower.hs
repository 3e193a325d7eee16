-- What the robot is doing. A turn has a speed and a time when it ends.
data Mode = Go | Stop | Turn Double Seconds

-- Sent when something is in the way.
data ChgDir = ChgDir

-- Messages of the first kind are more important than those of the second.
newtype M1 a = M1 a

newtype M2 a = M2 a

-- Until then, only important messages pass.
newtype M = M Seconds

bumper :: Bumper -> (Led1, Maybe ChgDir)
bumper (Bumper _ Pressed) = (Led1 Orange, Just ChgDir)
bumper (Bumper _ Released) = (Led1 Black, Nothing)

cliff :: Cliff -> (Led2, Maybe ChgDir)
cliff (Cliff _ Hole) = (Led2 Orange, Just ChgDir)
cliff (Cliff _ Floor) = (Led2 Black, Nothing)

wheel :: Wheel -> (Led1, Led2, Memory Mode)
wheel (Wheel _ Air) = (Led1 Red, Led2 Red, Memory Stop)
wheel (Wheel _ Ground) = (Led1 Black, Led2 Black, Memory Go)

-- Picks an angle up to half a turn, and a side.
chgdir :: ChgDir -> StdGen -> Seconds -> Memory Mode
chgdir ChgDir gen now = Memory (Turn speed (now + doubleToSeconds angle))
  where
    (angle, more) = randomR (0, pi) gen
    (left, _) = random more
    speed = if left then 1 else -1

spin :: Memory Mode -> Seconds -> Either (M2 Velocity) (Memory Mode)
spin (Memory Go) _ = Left (M2 (Velocity 0.15 0))
spin (Memory Stop) _ = Left (M2 (Velocity 0 0))
spin (Memory (Turn speed end)) now
  | now < end = Left (M2 (Velocity 0 speed))
  | otherwise = Right (Memory Go)

-- Remembers the sides on which something is in the way.
watch :: Either Bumper Cliff -> Memory [BumperSide] -> Memory [BumperSide]
watch (Left (Bumper side Pressed)) (Memory sides) = Memory (side : sides)
watch (Left (Bumper side Released)) (Memory sides) = Memory (without side sides)
watch (Right (Cliff side Hole)) (Memory sides) = Memory (bumperAt side : sides)
watch (Right (Cliff side Floor)) (Memory sides) =
  Memory (without (bumperAt side) sides)

without :: BumperSide -> [BumperSide] -> [BumperSide]
without side = filter (/= side)

-- Warns at once, and then ten times a second for as long as it is so.
safetyControl ::
  Maybe (Either Bumper Cliff) ->
  Memory [BumperSide] ->
  Memory Mode ->
  Maybe (M1 Velocity)
safetyControl _ _ (Memory Stop) = Just (M1 (Velocity 0 0))
safetyControl _ (Memory (side : _)) _ = Just (M1 (backOff side))
safetyControl _ (Memory []) _ = Nothing

-- Backwards, and away from the side that was hit.
backOff :: BumperSide -> Velocity
backOff CenterBumper = Velocity (-0.1) 0
backOff LeftBumper = Velocity (-0.1) (-0.4)
backOff RightBumper = Velocity (-0.1) 0.4

bumperAt :: CliffSide -> BumperSide
bumperAt CenterCliff = CenterBumper
bumperAt LeftCliff = LeftBumper
bumperAt RightCliff = RightBumper

mux :: Seconds -> Memory M -> Either (M1 a) (M2 a) -> Maybe (a, Memory M)
mux now _ (Left (M1 message)) = Just (message, Memory (M (now + 1)))
mux now (Memory (M end)) (Right (M2 message))
  | now > end = Just (message, Memory (M end))
  | otherwise = Nothing

muxVelocity ::
  Seconds ->
  Memory M ->
  Either (M1 Velocity) (M2 Velocity) ->
  Maybe (Velocity, Memory M)
muxVelocity = mux

main :: IO ()
main =
  simulate
    ((bumper, cliff, wheel, chgdir, spin), (watch, safetyControl), muxVelocity)
