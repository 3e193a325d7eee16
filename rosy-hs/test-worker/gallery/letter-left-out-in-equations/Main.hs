main = simulate play

play :: Bumper -> Maybe Sound
play (Bumper _ Pressed) = Just ErrorSound
ply (Bumper LeftBumper _) = Nothing
ply _ = Nothing
