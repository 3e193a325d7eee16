main = simulate accelerate

accelerate :: Velocity -> Velocity
accelerate (Velocity v) = Velocity (v + 0.5) 0
