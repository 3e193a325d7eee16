main = simulate play

play :: Bumper -> Maybe Sond
play _ = Just ErrorSound
