rest :: Double -> Double
rest x = 1 - x

speed :: Position -> Velocity
speed (Position x _) = Velocity (rest x * 0.5) 0

main = simulate speed
