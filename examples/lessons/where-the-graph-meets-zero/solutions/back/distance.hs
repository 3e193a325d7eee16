way :: Double -> Double
way x = x + 1

speed :: Position -> Velocity
speed (Position x _) = Velocity (-(0.7 * way x)) 0

main = simulate speed
