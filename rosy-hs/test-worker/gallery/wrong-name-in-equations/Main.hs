main = simulate play

play :: Bumper -> Maybe Sound
play (Bumper _ Pressed) = Just ErrorSound
plya _ = Nothing
