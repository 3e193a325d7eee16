main = simulate (replicate 4 (say "x"))
