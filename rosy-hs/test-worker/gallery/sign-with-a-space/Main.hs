bump :: Bumper - > Maybe Sound
bump _ = Just ErrorSound

main = simulate bump
