bump :: Bumper -> Maybe Sound
bump = lambda b: Just ErrorSound

main = simulate bump
