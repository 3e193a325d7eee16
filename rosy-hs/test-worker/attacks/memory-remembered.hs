main = simulate grow

grow :: Memory [Int] -> Memory [Int]
grow (Memory xs) = Memory (length xs : xs ++ xs)
