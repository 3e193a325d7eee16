bump :: Bumper -> Maybe Sound
bump (Bumper _ Pressed) = return Just ErrorSound
bump _ = return Nothing

main = simulate bump
