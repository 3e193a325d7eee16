main = simulate f
f :: Memory Int -> (Memory Int, Say)
f (Memory n) = Memory (n + 1), Say (show n)
