main = simulate play

play :: Bumper -> Maybe Sound
play _ = Nothing
play (Bumper _ Pressed) = Just ErrorSound
