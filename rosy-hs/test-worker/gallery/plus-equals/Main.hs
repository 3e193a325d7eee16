main = simulate f
f :: Bumper -> Memory Int -> Memory Int
f b (Memory n) = n += 1
