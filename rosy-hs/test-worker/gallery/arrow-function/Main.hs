bump :: Bumper -> Maybe Sound
bump = (b) => Just ErrorSound

main = simulate bump
