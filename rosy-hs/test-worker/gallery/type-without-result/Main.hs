bump :: Bumper
bump (Bumper _ Pressed) = Just ErrorSound
bump (Bumper _ Released) = Nothing

main = simulate bump
