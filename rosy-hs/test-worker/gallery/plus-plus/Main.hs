count :: Memory Int -> Bumper -> Memory Int
count (Memory n) _ = Memory (n++)

main = simulate count
