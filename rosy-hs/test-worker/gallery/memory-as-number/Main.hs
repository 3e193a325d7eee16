main = simulate f
f :: Memory Int -> Memory Int
f n = n + 1
