main = simulate (forever say "x")
