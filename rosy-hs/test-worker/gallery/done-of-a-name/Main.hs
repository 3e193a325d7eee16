go n = task () (\(Bumper _ _) -> Done n)
main = simulate (go 3)
