count :: Bumper -> Memory Int -> (Memory Int, Say)
count _ (Memory n) = (Memory (n + 1), Say ("bumps: " + n))

main = simulate count
