main = simulate (accelerate, play)

accelerate :: Velocity -> Velocity
accelerate (Velocity v w) = Velocity (v + 0.5) w

play :: Bumper -> Maybe Sound
play (Bumper _ Pressed) = Just ErrorSound
play _ = Nothing
