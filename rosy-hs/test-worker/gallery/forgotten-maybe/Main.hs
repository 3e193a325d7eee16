main = simulate play

play :: Bumper -> Sound
play (Bumper _ Pressed) = Just ErrorSound
play _ = Nothing
