count :: Memory Int -> Bumper -> Memory Int
count (Memory n) _ = let n = n + 1 in Memory n

main = simulate count
