instance Sensor Velocity

accelerate :: Velocity -> Velocity
accelerate (Velocity v w) = Velocity (v + 0.5) w

main = simulate accelerate
