bump :: Bumper -> Maybe Sound
bump Bumper.Pressed = Just ErrorSound
bump Bumper.Released = Nothing

main = simulate bump
