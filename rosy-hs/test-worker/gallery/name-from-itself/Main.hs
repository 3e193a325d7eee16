count :: Memory Int -> Bumper -> Memory Int
count (Memory n) _ = Memory n
  where n = n + 1

main = simulate count
