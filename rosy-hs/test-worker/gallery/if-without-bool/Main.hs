main = simulate play

play :: Bumper -> Maybe Sound
play (Bumper _ status) = if status then Just ErrorSound else Nothing
