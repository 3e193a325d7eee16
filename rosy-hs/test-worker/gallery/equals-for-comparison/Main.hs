main = simulate play

play :: Bumper -> Maybe Sound
play (Bumper _ s) = if s = Pressed then Just ErrorSound else Nothing
