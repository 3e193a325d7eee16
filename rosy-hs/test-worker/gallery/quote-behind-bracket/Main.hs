main = simulate (say "hello)
