count :: Memory Int -> Bumper -> (Memory Int, Say)
count (Memory n) _ = (Memory (n + 1 % 3), Say (show n))

main = simulate count
