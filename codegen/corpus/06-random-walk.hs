data Mode = Go | Stop | Turn Double Seconds

data ChgDir = ChgDir

bumper :: Bumper -> (Led1, Maybe ChgDir)
bumper (Bumper _ Pressed)  = (Led1 Orange, Just ChgDir)
bumper (Bumper _ Released) = (Led1 Black, Nothing)

cliff :: Cliff -> (Led2, Maybe ChgDir)
cliff (Cliff _ Hole) = (Led2 Orange, Just ChgDir)
cliff (Cliff _ Floor) = (Led2 Black, Nothing)

wheel :: Wheel -> (Led1, Led2, Memory Mode)
wheel (Wheel _ Air) = (Led1 Red, Led2 Red, Memory Stop)
wheel (Wheel _ Ground) = (Led1 Black, Led2 Black, Memory Go)

chgdir :: ChgDir -> StdGen -> Seconds -> Memory Mode
chgdir _ gen now = Memory (Turn dir (now + time))
  where
    (angle, gen') = randomR (0, pi) gen
    (side, _)     = random gen'
    dir = if side then 1 else -1
    time = doubleToSeconds (angle / 1)

spin :: Memory Mode -> Seconds -> (Velocity, Memory Mode)
spin (Memory mode) now = case mode of
  Go -> (Velocity 0.5 0, Memory Go)
  Stop -> (Velocity 0 0, Memory Stop)
  Turn dir end
    | now > end -> (Velocity 0 0, Memory Go)
    | otherwise -> (Velocity 0 dir, Memory (Turn dir end))

main :: IO ()
main = simulate (bumper, cliff, wheel, chgdir, spin)
