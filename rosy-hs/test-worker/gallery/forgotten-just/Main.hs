main = simulate play

play :: Bumper -> Maybe Sound
play (Bumper _ Pressed) = ErrorSound
play _ = Nothing
