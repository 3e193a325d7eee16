main = simulate f
f :: Memory Int -> Int
f (Memory n) = Memory (n + 1)
