main = simulate hit

hit :: Bumper -> Velocity
hit = \_ => Velocity 0 0
