turn = task () (\(Velocity _ _) -> Done 3)
main = simulate turn
