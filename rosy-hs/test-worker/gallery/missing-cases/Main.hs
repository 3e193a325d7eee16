main = simulate play

play :: Bumper -> Maybe Sound
play (Bumper LeftBumper Pressed) = Just ErrorSound
play (Bumper RightBumper Pressed) = Just OnSound
