main = simulate accelerate

accelerate :: Velocity -> Velocity
accelerate (Velocity v w) = faster v

faster :: Double -> Double -> Velocity
faster v w = Velocity (v + 0.5) w
