main = simulate play

play :: Bumper -> Maybe Sound
play (Bumper side status) = _
