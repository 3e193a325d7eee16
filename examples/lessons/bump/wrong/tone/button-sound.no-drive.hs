bump :: Bumper -> Sound
bump _ = ButtonSound

main = simulate bump
