count :: Bumper -> Memory Int -> Memory Int
count _ (Memory n) = Memory (n ++ 1)
main = simulate count
