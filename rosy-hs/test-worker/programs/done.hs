main = simulate (task start (accelerate, untilBump))

start :: Led1
start = Led1 Green

accelerate :: Velocity -> Velocity
accelerate (Velocity v w) = Velocity (v + 0.5) w

untilBump :: Bumper -> (Led1, Done ())
untilBump _ = (Led1 Black, Done ())
