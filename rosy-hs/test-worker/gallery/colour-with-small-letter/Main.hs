hit :: Bumper -> Led1
hit _ = Led1 red

main = simulate hit
