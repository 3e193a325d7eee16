main = simulate play

play :: Bumper -> Maybe Sound
play (Bumper _ Pressed) = Just ErrorSound
play = Nothing
