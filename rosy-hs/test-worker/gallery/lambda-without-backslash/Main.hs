main = simulate hit

hit :: Bumper -> Velocity
hit = (b -> Velocity 0 0)
