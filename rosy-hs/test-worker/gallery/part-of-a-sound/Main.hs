hit :: Bumper -> Sound
hit _ = Error

main = simulate hit
