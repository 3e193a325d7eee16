data Memory a = Memory a

main = simulate count

count :: Bumper -> Memory Int -> Memory Int
count _ (Memory n) = Memory (n + 1)
