data Task a = Task a

main = simulate plan

plan :: Bumper -> Task Int
plan _ = Task 3
