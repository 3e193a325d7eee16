count :: Memory Int -> Bumper -> (Memory Int, Velocity)
count (Memory n) _ = (Memory (n + 1), Velocity (n / 10) 0)

main = simulate count
