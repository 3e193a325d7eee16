count :: Memory Int -> Bumper -> (Memory Int, Say)
count (Memory n) _ = (Memory (n + 1), Say (show (n%2)))

main = simulate count
